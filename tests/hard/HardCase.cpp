// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard/HardCase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/scenes/BlockScenes.h"

namespace glenoid::hard {

namespace {

constexpr double kShortTail = 0.25;  ///< s that a short run goes on after the case must be at rest

bool isLong() {
  const char* wish = std::getenv("GLENOID_LONG");
  return wish && wish[0] == '1';
}

StabilityRun stabilityRun(const HardCase& hard, std::shared_ptr<const Model> model) {
  StabilityRun run;
  run.model = model;
  run.start = model->start;
  if (hard.start) hard.start(*model, run.start);
  if (hard.hands) run.hands = [&hard, model](double time) { return hard.hands(*model, time); };
  run.loadEnds = hard.loadEnds;
  run.comesToRest = hard.comesToRest;
  run.seconds = isLong() ? 10 : hard.loadEnds + (hard.comesToRest ? hard.bounds.secondsToRest + kShortTail : 0);
  run.quiet = isLong() ? 0 : 0.3;  // a short run is over when nothing has moved for a while
  run.bounds = hard.bounds;
  if (std::getenv("GLENOID_TRACE"))
    run.observe = [model](const StepReport& report, const State& state) {
      std::printf("%8.4f speed %.4g contacts %d active %d exhausted %d\n", state.time, fastestPoint(*model, state), report.contacts, report.active,
                  report.pivotsExhausted);
    };
  return run;
}

}  // namespace

HardResult run(const HardCase& hard, double dt) {
  Scenario scenario = hard.scenario;
  scenario.dt = dt;
  scenario.elements = scenes::wishedElements();
  const auto compiled = compileModel(hard.joint, scenario);
  HardResult result;
  if (!compiled) {
    ADD_FAILURE() << hard.name << " does not compile: " << compiled.error().detail;
    result.finite = false;
    return result;
  }
  result.model = *compiled;
  static_cast<StabilityFigures&>(result) = measureStability(stabilityRun(hard, *compiled));
  return result;
}

void expectUnshaken(const HardCase& hard, const std::function<void(const HardResult&, double dt)>& check) {
  for (const double dt : {1e-3, 5e-3, 2e-2}) {
    if (const char* only = std::getenv("GLENOID_ONLY"); only && std::abs(std::atof(only) - 1e3 * dt) > 0.1) continue;
    SCOPED_TRACE(hard.name + " at " + std::to_string(1e3 * dt) + " ms");
    const HardResult result = run(hard, dt);
    std::printf("%-34s %5.0f ms  %s  energy %+8.4f  depth %7.4f mm, %.2f of its bound  rest %6.3f s  end %.1e m/s  inside out %d, %d  contacts %3d  unsettled %ld  parts %2d  rejected %ld\n",
                hard.name.c_str(), 1e3 * dt, result.finite ? "finite" : "NOT FINITE", result.energyExcess, 1e3 * result.depth, result.depthShare,
                result.secondsToRest, result.restSpeed, result.insideOut, result.insideOutEnd, result.contactsMax, result.pivotsExhausted, result.partsMost,
                result.rejected);
    std::fflush(stdout);
    EXPECT_TRUE(result.finite);
    if (!result.finite) continue;
    EXPECT_LE(result.energyExcess, hard.bounds.energyExcess) << "energy beyond what was there and what was put in";
    EXPECT_LE(result.depthShare, 1) << "of its bound, of surfaces that started apart: " << result.depthPair;
    if (hard.comesToRest) {
      EXPECT_LE(result.secondsToRest, hard.bounds.secondsToRest) << "s after the load ends: " << hard.ending;
    }
    EXPECT_LE(result.rejected, hard.bounds.rejectedSteps);
    EXPECT_TRUE(result.endsTaken);
    if (check) check(result, dt);
  }
}

}  // namespace glenoid::hard
