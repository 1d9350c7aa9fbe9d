// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/step/Stepper.h"

namespace glenoid {

/// One way to run a scene: everything that trades time for accuracy and can be asked for. Plain value. Rotations and
/// linearisations are not among it: rotations always iterate to round-off (the profile `reference` takes singular values
/// instead), forces are linearised once a step, and neither has a setting.
struct AccuracySetting {
  std::string id;       ///< what differs from the scene, as "cells=4,dt=2.5ms"; "scene" for nothing; unique in a study
  std::string family;   ///< what it is about: "scene", "time-step", "profile", "elements", "cells", "surfaces", "contact", "paper"
  Profile profile = Profile::Direct;
  double dt = 0.005;                  ///< s
  std::optional<Elements> elements;   ///< of all soft parts; nothing: as the scene has them
  double cells = 1;                   ///< times as many tetrahedra in every soft part; where parts touch stays (refineCells)
  bool visualContact = false;         ///< the visual surfaces collide in place of the simplified ones
  double contactDistance = 0;         ///< m
  double recoverySpeedMax = 0;        ///< m/s
  PaperSettings paper;
  PaperLimits paperLimits;
};

/// What a study sweeps. `base`: the scene compiled as it is, so that lengths which follow its scale are known. The first is
/// the scene itself. `quick`: the few that matter most.
std::vector<AccuracySetting> accuracySettings(const Model& base, bool quick);

/// The scene itself as a setting.
AccuracySetting settingOf(const Model& base);

/// Names what differs from `base` and sets the id by it.
void nameSetting(AccuracySetting& setting, const AccuracySetting& base);

/// Whether cells, elements and surfaces are the scene's own, so that only the solving differs.
bool hasOwnCells(const AccuracySetting& setting, const AccuracySetting& base);

/// Whether a scenario's file, with a joint beside it, can say this setting. What the paper profile adds and where its
/// iterations end stands in no file.
bool fitsScenario(const AccuracySetting& setting);

Scenario scenarioWith(const AccuracySetting& setting, Scenario scenario);
/// Fails as refineCells does.
Result<Joint> jointWith(const AccuracySetting& setting, const Joint& joint);
StepperOptions stepperWith(const AccuracySetting& setting);

}  // namespace glenoid
