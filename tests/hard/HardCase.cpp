// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard/HardCase.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "simcore/collide/Penetration.h"
#include "simcore/step/StepModel.h"
#include "tests/hard/Energy.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid::hard {

namespace {

constexpr double kShortTail = 0.25;  ///< s that a short run goes on after the case must be at rest

constexpr double kQuiet = 0.3;       ///< s of rest after which a short run may end

bool isLong() {
  const char* wish = std::getenv("GLENOID_LONG");
  return wish && wish[0] == '1';
}

/// Depth of all pairs that started apart, by the check that shares nothing with the search.
class Depths {
 public:
  Depths(const Model& model, const State& start) : m_model(model) {
    for (const SceneObject& object : model.objects) m_positions.emplace_back(object.collision.vertices.size());
    for (const auto& list : m_positions) m_spans.emplace_back(list);
    std::vector<CollisionPair> apart;
    move(start);
    for (const CollisionPair& pair : model.collisionPairs)
      if (PenetrationCheck(model.collisionSurfaces, {pair}).deepest(m_spans).depth == 0) apart.push_back(pair);
    m_check = std::make_unique<PenetrationCheck>(model.collisionSurfaces, apart);
  }
  double deepest(const State& state) {
    move(state);
    return m_check->deepest(m_spans).depth;
  }

 private:
  void move(const State& state) {
    for (std::size_t i = 0; i < m_positions.size(); ++i)
      surfacePositions(m_model.objects[i].collision, m_model.objects[i].layout, state.q, m_positions[i]);
  }
  const Model& m_model;
  std::vector<std::vector<Vec3>> m_positions;
  std::vector<std::span<const Vec3>> m_spans;
  std::unique_ptr<PenetrationCheck> m_check;
};

/// The fastest node of a soft part or surface vertex of a rigid one, m/s.
double fastest(const Model& model, const State& state) {
  double most = 0;
  std::vector<Vec3> velocities;
  for (const SceneObject& object : model.objects) {
    const ObjectLayout& layout = object.layout;
    if (!layout.free) continue;
    for (int node = 0; node < layout.nodeCount; ++node)
      most = std::max(most, state.v.segment<3>(layout.vOffset + 3 * node).norm());
    if (!layout.rigid) continue;
    velocities.resize(object.collision.vertices.size());
    surfaceVelocities(object.collision, layout, state.q, state.v, velocities);
    for (const Vec3& v : velocities) most = std::max(most, v.norm());
  }
  return most;
}

}  // namespace

HardResult run(const HardCase& hard, double dt, double seconds) {
  const bool mayEnd = seconds <= 0 && !isLong();
  if (seconds <= 0) seconds = isLong() ? 10 : hard.loadEnds + (hard.comesToRest ? hard.secondsToRest + kShortTail : 0);
  HardResult result;
  Scenario scenario = hard.scenario;
  scenario.dt = dt;
  scenario.elements = scenes::wishedElements();
  auto compiled = compileModel(hard.joint, scenario);
  if (!compiled) {
    ADD_FAILURE() << hard.name << " does not compile: " << compiled.error().detail;
    result.finite = false;
    return result;
  }
  result.model = compiled.value();
  const Model& model = *result.model;
  State state = model.start;
  if (hard.start) hard.start(model, state);
  EnergyBooks books(result.model, state);
  State before = state;
  StepperOptions options;
  options.afterPart = [&](const State& after, double length) {
    books.add(before, after, length);
    result.energyExcess = std::max(result.energyExcess, books.excess());
    before = after;
  };
  Stepper stepper(result.model, options);
  Depths depths(model, state);
  double lastFast = 0;
  for (long step = 0; static_cast<double>(step) * dt < seconds; ++step) {
    before = state;
    const StepReport& report = stepper.step(hard.hands ? hard.hands(model, static_cast<double>(step) * dt) : Inputs{}, state);
    ++result.steps;
    result.rejected += !report.taken;
    result.endsTaken = report.taken;
    result.pivotsExhausted += report.pivotsExhausted;
    result.contactsMax = std::max(result.contactsMax, report.contacts);
    result.finite = result.finite && isFinite(state);
    if (!result.finite) break;
    result.partsMost = std::max(result.partsMost, report.parts);
    result.penetration = std::max(result.penetration, depths.deepest(state));
    result.restSpeed = fastest(model, state);
    if (std::getenv("GLENOID_TRACE"))
      std::printf("%8.4f E %.6g W %.6g excess %.4g depth %.4g mm speed %.4g contacts %d active %d exhausted %d\n", state.time,
                  books.energy(), books.work(), books.excess(), 1e3 * depths.deepest(state), result.restSpeed, report.contacts,
                  report.active, report.pivotsExhausted);
    if (result.restSpeed >= hard.restSpeed) lastFast = state.time;
    // A short run is over when nothing has moved for a while.
    if (mayEnd && hard.comesToRest && state.time > std::max(lastFast, hard.loadEnds) + kQuiet) break;
  }
  result.secondsToRest = std::max(0.0, lastFast - hard.loadEnds);
  result.end = state;
  return result;
}

void expectUnshaken(const HardCase& hard, const std::function<void(const HardResult&, double dt)>& check) {
  for (const double dt : {1e-3, 5e-3, 2e-2}) {
    if (const char* only = std::getenv("GLENOID_ONLY"); only && std::abs(std::atof(only) - 1e3 * dt) > 0.1) continue;
    SCOPED_TRACE(hard.name + " at " + std::to_string(1e3 * dt) + " ms");
    const HardResult result = run(hard, dt);
    std::printf("%-34s %5.0f ms  %s  energy %+8.4f  depth %7.4f mm  rest %6.3f s  end %.1e m/s  contacts %3d  unsettled %ld  parts %2d  rejected %ld\n",
                hard.name.c_str(), 1e3 * dt, result.finite ? "finite" : "NOT FINITE", result.energyExcess, 1e3 * result.penetration,
                result.secondsToRest, result.restSpeed, result.contactsMax, result.pivotsExhausted, result.partsMost,
                result.rejected);
    std::fflush(stdout);
    EXPECT_TRUE(result.finite);
    if (!result.finite) continue;
    EXPECT_LE(result.energyExcess, hard.energyExcess) << "energy beyond what was there and what was put in";
    EXPECT_LE(result.penetration, hard.penetration) << "m, of surfaces that started apart";
    if (hard.comesToRest) {
      EXPECT_LE(result.secondsToRest, hard.secondsToRest) << "s after the load ends: " << hard.ending;
    }
    EXPECT_LE(result.rejected, hard.rejectedSteps);
    EXPECT_TRUE(result.endsTaken);
    if (check) check(result, dt);
  }
}

double shapeError(const Model& model, const State& state, int object) {
  const ObjectLayout& layout = model.objects[object].layout;
  const Eigen::Index n = layout.nodeCount;
  const Eigen::Map<const Eigen::Matrix3Xd> now(state.q.data() + layout.qOffset, 3, n);
  const Eigen::Map<const Eigen::Matrix3Xd> rest(model.start.q.data() + layout.qOffset, 3, n);
  const Vec3 nowMean = now.rowwise().mean(), restMean = rest.rowwise().mean();
  const Eigen::Matrix3Xd a = rest.colwise() - restMean, b = now.colwise() - nowMean;
  const Eigen::JacobiSVD<Mat3> svd(Mat3(b * a.transpose()), Eigen::ComputeFullU | Eigen::ComputeFullV);
  // A proper rotation only: a mirrored part is not at its rest shape.
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Mat3 R = svd.matrixU() * Vec3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
  return (b - R * a).colwise().norm().maxCoeff();
}

}  // namespace glenoid::hard
