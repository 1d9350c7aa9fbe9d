// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Recording.h"
#include "simcore/scene/Scenario.h"

namespace glenoid::generate {

/// A hand that palpates with a tool whose home lies over the skin: presses straight in, strokes up and down along the
/// fibres at 0.1 to 0.2 m/s, goes round in circles of 25 mm radius at 0.5 m/s, and leaves. Eight seconds.
Recording planStrokes(const Scenario& scenario, const std::string& toolId, const std::string& partId);

}  // namespace glenoid::generate
