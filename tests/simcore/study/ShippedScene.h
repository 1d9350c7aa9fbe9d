// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/study/ContactState.h"

namespace glenoid::test {

/// The built-in arthroscopy with its hands.
inline StudyScene shippedScene() {
  const std::string resources = GLENOID_SOURCE_DIR "/resources";
  return {loadJoint(resources + "/joints/shoulder.joint").value(),
          loadScenario(resources + "/scenarios/arthroscopy.scenario.json").value(),
          loadRecording(resources + "/recordings/arthroscopy.recording").value()};
}

/// Where the input has brought the scene at a time, s.
inline State stateAt(const StudyScene& scene, std::shared_ptr<const Model> model, double time) {
  Stepper stepper(model, {});
  State state = model->start;
  Inputs inputs;
  const long steps = std::lround(time / scene.scenario.dt);
  for (long s = 0; s < steps; ++s) {
    handsAt(scene.scenario, &scene.input, static_cast<double>(s + 1) * scene.scenario.dt, inputs.hands);
    stepper.step(inputs, state);
  }
  return state;
}

}  // namespace glenoid::test
