// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// NAME.scenario.json. A file may say `"extends": "OTHER.scenario.json"` (path relative to itself): it then is that
/// scenario with its own members on top: objects are merged member by member, everything else is replaced. The
/// extended file must be a whole scenario. Its `joint` and `input` still mean what they meant beside their own file.
/// Fails as readDocument does and with CyclicReference (argument: the file that comes round again), TooDeep (a chain
/// of more than 16), BadReference (`extends` is absolute or builtin), DuplicateId (tools, cameras), OutOfRange.
Result<Scenario> loadScenario(const std::string& path);

/// Writes one whole scenario; `extends` is not kept. Relative `joint` and `input` are written as they are. Atomic.
/// The first save over a file of an older schema keeps that beside it, as NAME.scenario.v1.json for schema 1.
/// Fails as checkScenario does without a joint and as writeJson does.
Result<Done> saveScenario(const Scenario& scenario, const std::string& path);

/// The scenario's own values: ids unique, ranges, one hold and one motion for each part, turns that are turns, keys that
/// ascend.
Result<Done> checkScenario(const Scenario& scenario, const std::string& file);

/// Its references into the joint: fixedParts, holds (rigid, not fixed), loads, pressures and supports (not fixed),
/// motions (fixed), what tools perforate. Fails with UnknownId (arguments: id, kind) or BadReference (a hold on a soft or
/// fixed part, …); the pointer and part are added to `place`.
Result<Done> checkScenario(const Scenario& scenario, const Joint& joint, const Place& place);

}  // namespace glenoid
