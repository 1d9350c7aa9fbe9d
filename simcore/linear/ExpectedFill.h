// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <span>

namespace glenoid {

/// About what BlockSymbolic::updateCount() would be for these pairs, from the ordering alone: to ask before a pattern is laid out
/// that may be too dense for it. Minimum degree, whatever the size.
double expectedUpdates(int blockCount, std::span<const std::array<int, 2>> pairs);

}  // namespace glenoid
