// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/live/RunReport.h"
#include "simcore/scene/Recording.h"

namespace glenoid {

/// Writes a file as a whole or not at all; of every effect it says why it is on or off (`why`). `model`: the one that ran. Fails with
/// FileUnwritable.
Result<Done> saveOutcome(const RunReport& report, const Model& model, const std::string& path);
Result<Done> saveOutcome(const Recording& recording, const std::string& path);

/// The few lines of a report that a person reads on the terminal.
std::string summaryOf(const RunReport& report, const Model& model);

}  // namespace glenoid
