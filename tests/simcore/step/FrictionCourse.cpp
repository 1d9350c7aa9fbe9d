// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/step/FrictionCourse.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glenoid {

Course runFor(Stepper& stepper, State& state, int steps) {
  Course run;
  for (int i = 0; i < steps; ++i) {
    const StepReport& report = stepper.step({}, state);
    EXPECT_TRUE(report.taken);
    run.stepMs.push_back(report.stepCpuMs);
    run.frictionMs.push_back(report.cpuMs[static_cast<int>(Stage::Friction)]);
    run.newton += report.contactSolver.newtonMax;
    run.newtonMost = std::max(run.newtonMost, report.contactSolver.newtonMax);
    run.velocities += report.contactSolver.velocities;
    run.convex += report.contactSolver.convex > 0;
    run.rows = std::max(run.rows, report.contactSolver.rowsMax);
    run.active = std::max(run.active, report.active);
    run.pressing = std::max(run.pressing, report.pressing);
    run.unsettled += report.pivotsExhausted;
    run.unsaid += report.pivotsExhausted == 0 && report.complementarity > 1e-8;
    run.worst = std::max(run.worst, report.complementarity);
  }
  EXPECT_TRUE(state.q.allFinite() && state.v.allFinite());
  return run;
}

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Part rigidBox(const std::string& id, int number, const Vec3& low, const Vec3& high, int squares) {
  Part part = scenes::boxPart(id, number, PartKind::Rigid, low, high);
  part.visual = part.collision = std::make_shared<TriMesh>(scenes::boxSurface(low, high, squares));
  return part;
}

}  // namespace glenoid
