// SPDX-License-Identifier: GPL-3.0-or-later
/// `generate_peer_scene FOLDER`: writes the scene of the peers as it lies in tests/scenes/peers: one joint and one
/// scenario for each stiffness, and the recording that all share. Same bytes every time. Exit status 0 done, 1 failed,
/// 2 usage.
#include <cstdio>

#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/study/PeerScene.h"

int main(int argc, char** argv) {
  using namespace glenoid;
  if (argc != 2) {
    std::fprintf(stderr, "usage: generate_peer_scene FOLDER\n");
    return 2;
  }
  const std::string folder = argv[1];
  const auto failed = [](const Result<Done>& saved) {
    if (!saved) std::fprintf(stderr, "%s\n", toLogLine(saved.error()).c_str());
    return !saved;
  };
  for (const peers::Stiffness stiffness : peers::kStiffnesses) {
    const std::string name = peers::stiffnessName(stiffness);
    if (failed(saveJoint(peers::makeJoint(stiffness), folder + "/" + name + ".joint"))) return 1;
    Scenario scenario = peers::makeScenario(0.005);
    scenario.id += "-" + name;
    scenario.joint = name + ".joint";
    scenario.input = "press.recording";
    if (failed(saveScenario(scenario, folder + "/" + name + ".scenario.json"))) return 1;
  }
  return failed(saveRecording(peers::makeRecording(0.01), folder + "/press.recording")) ? 1 : 0;
}
