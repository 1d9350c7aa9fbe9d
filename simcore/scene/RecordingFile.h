// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Recording.h"

namespace glenoid {

/// NAME.recording, a JSON text. Fails as readDocument does and with DuplicateId (two tracks of one tool) or OutOfRange
/// (times that do not ascend, a mark that ends before it begins, a rotation that is no unit quaternion).
Result<Recording> loadRecording(const std::string& path);

/// Atomic; numbers come back bit for bit. Fails as checkRecording does and as writeJson does.
Result<Done> saveRecording(const Recording& recording, const std::string& path);

/// What loadRecording asks, for a recording in memory; `file` only names it in errors.
Result<Done> checkRecording(const Recording& recording, const std::string& file);

}  // namespace glenoid
