// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of the shipped arthroscopy with its hands in tissue, for counting instructions under callgrind: counting is on
// between its two client requests, so that loading and warming up cost neither count nor much time. Without valgrind
// the requests do nothing.
#include <valgrind/callgrind.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "simcore/live/Run.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"

using namespace glenoid;

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: count_step RESOURCES fast|portable\n");
    return 2;
  }
  const std::string resources = argv[1];
  const auto joint = loadJoint(resources + "/joints/shoulder.joint");
  const auto scenario = loadScenario(resources + "/scenarios/arthroscopy.scenario.json");
  const auto input = loadRecording(resources + "/recordings/arthroscopy.recording");
  if (!joint || !scenario || !input) return 2;
  const auto model = compileModel(*joint, *scenario);
  if (!model) return 2;
  StepperOptions options;
  options.portable = std::string(argv[2]) == "portable";
  Stepper stepper(*model, options);
  State state = (*model)->start;
  Inputs inputs;

  // The hands go at once to where the input has them when the cuff is pressed.
  constexpr double kPressed = 6.5;  // s
  constexpr int kWarmUp = 60, kCounted = 20;
  handsAt(*scenario, &*input, kPressed, inputs.hands);
  for (int s = 0; s < kWarmUp; ++s) stepper.step(inputs, state);
  int contacts = 0, active = 0;
  CALLGRIND_START_INSTRUMENTATION;
  for (int s = 0; s < kCounted; ++s) {
    const StepReport& report = stepper.step(inputs, state);
    contacts += report.contacts;
    active += report.active;
  }
  CALLGRIND_STOP_INSTRUMENTATION;
  std::printf("isa %s steps %d contacts %.1f active %.1f\n", kernelIsa(options.portable), kCounted,
              contacts / static_cast<double>(kCounted), active / static_cast<double>(kCounted));
}
