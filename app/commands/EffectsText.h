// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "app/plot/BarPlot.h"
#include "simcore/study/effects/EffectsStudy.h"

namespace glenoid {

/// What was found, effect by effect, for a newcomer: price, what would be lost and where, why `auto` has it
/// on or off.
std::string effectsSummary(const EffectsResult& result, const std::string& scene);

/// "Friction: 0.08 ms, …": one effect of the summary, without its line break.
std::string effectLine(const EffectsResult& result, const EffectRow& row);

/// Bars of a step's time without, with and with `auto`, beside what is lost. `machine`: as machineWords says
/// it.
BarPlot effectsPlot(const EffectsResult& result, const std::string& scene, const std::string& machine);

/// Name of a part or tool for people: its id where it has no other.
std::string objectName(const Model& model, const std::string& id);

}  // namespace glenoid
