// SPDX-License-Identifier: GPL-3.0-or-later
/// `generate_recording RESOURCES OUT.recording [arthroscopy|palpation|tour|landmarks]`: plans the input that ships with a scene from the
/// joint and the scenario in the folder RESOURCES. Palpation: a finger presses, strokes and circles. Arthroscopy: the
/// probe presses biceps tendon (below its groove, where the tip does not slip off the arch), labrum, cuff and cartilage
/// from in front while the arthroscope leans on the head from behind. Tour and landmarks: somebody sure does the tasks. Same files in, same bytes out. Exit status 0 done,
/// 1 failed, 2 usage.
#include <cstdio>

#include "resources/generate/PressPlan.h"
#include "resources/generate/StrokePlan.h"
#include "resources/generate/TaskPlan.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ResourcePaths.h"
#include "simcore/scene/ScenarioFile.h"

namespace {

int fail(const glenoid::Error& error) {
  std::fprintf(stderr, "%s\n", glenoid::toLogLine(error).c_str());
  return 1;
}

glenoid::Recording arthroscopy(const glenoid::Joint& joint, const glenoid::Scenario& scenario) {
  using namespace glenoid;
  using namespace glenoid::generate;
  constexpr double kBegin = 1.5;  // s: one second to settle, half a second that counts as rest
  const Vec3 front = Vec3(0.8, 0.3, 0.5).normalized(), behind = Vec3(-0.9, 0.1, 0.3).normalized();
  Recording recording = planPresses(joint, scenario, "probe",
                                    {{"press-biceps-tendon", "biceps-tendon", "distal-end", 7e-3},
                                     {"press-labrum", "labrum", "", 4e-3},
                                     {"press-cuff", "subscapularis", "", 9e-3},
                                     {"press-cartilage", "humerus", "head-cartilage", 8e-3}},
                                    front, kBegin);
  const PressTarget lean{"lean-on-cartilage", "humerus", "head-cartilage", 4e-3};
  Recording scope = planPresses(joint, scenario, "arthroscope", {lean, lean, lean, lean}, behind, kBegin);
  recording.tracks.push_back(scope.tracks[0]);
  recording.marks.insert(recording.marks.end(), scope.marks.begin(), scope.marks.end());
  return recording;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace glenoid;
  using namespace glenoid::generate;
  const std::string scene = argc == 4 ? argv[3] : "arthroscopy";
  if (argc < 3 || argc > 4 || (scene != "arthroscopy" && scene != "palpation" && scene != "tour" && scene != "landmarks")) {
    std::fprintf(stderr, "usage: generate_recording RESOURCES OUT.recording [arthroscopy|palpation|tour|landmarks]\n");
    return 2;
  }
  const std::string root = argv[1];
  const Result<std::string> scenarioPath = resolveScenario("builtin:" + scene, "", root);
  if (!scenarioPath) return fail(scenarioPath.error());
  const Result<Scenario> scenario = loadScenario(*scenarioPath);
  if (!scenario) return fail(scenario.error());
  const Result<std::string> jointPath = resolveJoint(scenario->joint, folderOf(*scenarioPath), root);
  if (!jointPath) return fail(jointPath.error());
  const Result<Joint> joint = loadJoint(*jointPath);
  if (!joint) return fail(joint.error());

  Recording recording = scene == "palpation"   ? planStrokes(*scenario, "finger", "skin")
                        : scene == "tour"      ? planTasks(*joint, *scenario, "probe", Vec3(0.8, 0.3, 0.5).normalized(), 5e-3)
                        : scene == "landmarks" ? planTasks(*joint, *scenario, "finger", Vec3::UnitZ(), 0.012)
                                               : arthroscopy(*joint, *scenario);
  recording.scenario = "builtin:" + scene;
  recording.profile = "direct";
  if (const auto saved = saveRecording(recording, argv[2]); !saved) return fail(saved.error());
  for (const RecordingMark& mark : recording.marks)
    std::printf("%6.2f %6.2f %-22s %-12s %s\n", mark.begin, mark.end, mark.name.c_str(), mark.tool.c_str(), mark.part.c_str());
  return 0;
}
