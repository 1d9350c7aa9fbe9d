// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

/// How the worker ends where it cannot send an answer.
inline constexpr int kWorkerOutOfMemory = 42;
inline constexpr int kWorkerBadUsage = 43;

/// Descriptor on which the worker sends toWire().
inline constexpr int kWorkerChannel = 3;

/// main() of `glenoid-import FILE --memory BYTES --seconds N --triangles N`: limits itself, reads the file, sends the
/// answer, ends with 0. Not for people.
int importWorkerMain(int argc, char** argv);

}  // namespace glenoid
