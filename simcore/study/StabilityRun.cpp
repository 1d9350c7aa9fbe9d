// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/StabilityRun.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <ctime>

#include "simcore/body/SoftObject.h"
#include "simcore/live/PenetrationProbe.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/step/StepModel.h"
#include "simcore/study/StabilityEnergy.h"

namespace glenoid {
namespace {

/// Depths of all pairs against their bounds, by the check that shares nothing with the search.
class Depths {
 public:
  Depths(const Model& model, const State& start, const StabilityBounds& bounds, int misshapen) : m_model(model), m_probe(model, SurfaceKind::Collision) {
    for (const CollisionPair& pair : model.collisionPairs)
      m_limits.push_back(std::min(bounds.depth, bounds.thinShare * std::min(meanThickness(*model.objects[pair.surfaceA].collision.mesh),
                                                                           meanThickness(*model.objects[pair.surfaceB].collision.mesh))));
    m_probe.look(start.q);
    for (std::size_t p = 0; p < m_limits.size(); ++p) {
      const CollisionPair& pair = model.collisionPairs[p];
      m_apart.push_back(m_probe.lastLook()[p].depth == 0 && pair.surfaceA != misshapen && pair.surfaceB != misshapen);
    }
  }

  void look(const State& state, const std::vector<DentView>& dents, StabilityFigures& figures) {
    m_probe.look(state.q, dents);
    figures.depthEnd = figures.depthShareEnd = 0;
    for (std::size_t p = 0; p < m_limits.size(); ++p) {
      const double depth = m_probe.lastLook()[p].depth, share = depth / m_limits[p];
      figures.depthEnd = std::max(figures.depthEnd, depth);
      figures.depthShareEnd = std::max(figures.depthShareEnd, share);
      if (!m_apart[p]) continue;
      figures.depth = std::max(figures.depth, depth);
      if (share <= figures.depthShare) continue;
      const CollisionPair& pair = m_model.collisionPairs[p];
      figures.depthShare = share;
      figures.depthPair = m_model.objects[pair.surfaceA].id + " / " + (pair.self() ? "itself" : m_model.objects[pair.surfaceB].id);
    }
  }

 private:
  const Model& m_model;
  PenetrationProbe m_probe;
  std::vector<double> m_limits;
  std::vector<char> m_apart;
};

double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double movedFar(const Model& model, const State& state) {
  double most = 0;
  for (const SceneObject& object : model.objects)
    for (int k = 0; !object.tool && k < (object.layout.rigid ? 1 : object.layout.nodeCount); ++k)
      most = std::max(most, (state.q.segment<3>(object.layout.qOffset + 3 * k) - model.start.q.segment<3>(object.layout.qOffset + 3 * k)).norm());
  return most;
}

}  // namespace

double fastestPoint(const Model& model, const State& state) {
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

int elementsInsideOut(const Model& model, const State& state, bool stretchLaw) {
  int count = 0;
  for (std::size_t i = 0; i < model.objects.size(); ++i)
    if (const ObjectLayout& layout = model.objects[i].layout; layout.free && !layout.rigid)
      count += static_cast<const SoftObject&>(*model.inside->objects[i]).troubleOf(state.q, stretchLaw).insideOut;
  return count;
}

StabilityFigures measureStability(const StabilityRun& run) {
  const Model& model = *run.model;
  const double dt = model.scenario.dt;
  const bool stretchLaw = hasStretchLaw(run.stepper.profile, run.stepper.paper);
  StabilityFigures figures;
  State state = run.start, before = state;
  EnergyBooks books(run.model, state);
  const auto look = [&] {
    figures.energyExcess = std::max(figures.energyExcess, books.excess());
    figures.energyGained = std::max(figures.energyGained, books.gained());
  };
  StepperOptions options = run.stepper;
  options.afterPart = [&](const State& after, double length) {
    books.add(before, after, length);
    look();
    before = after;
  };
  Stepper stepper(run.model, options);
  Depths depths(model, state, run.bounds, run.misshapen);
  figures.insideOutStart = figures.insideOut = figures.insideOutEnd = elementsInsideOut(model, state, stretchLaw);
  const double begun = threadSeconds();
  const long lookEvery = std::max(1L, std::lround(run.lookEvery / dt));
  double unrestful = 0;  // the last moment beyond a bound of rest
  for (long step = 0; static_cast<double>(step) * dt < run.seconds; ++step) {
    const double time = static_cast<double>(step) * dt, after = static_cast<double>(step + 1) * dt;
    before = state;
    if (run.push) {
      run.push(time, state);
      books.push(before, state);
      before = state;
    }
    const StepReport& report = stepper.step(run.hands ? run.hands(time) : Inputs{}, state);
    ++figures.steps;
    figures.rejected += !report.taken;
    figures.endsTaken = report.taken;
    figures.pivotsExhausted += report.pivotsExhausted;
    figures.diverged += report.paper.diverged;
    figures.contactsMax = std::max(figures.contactsMax, report.contacts);
    figures.partsMost = std::max(figures.partsMost, report.parts);
    figures.finite = figures.finite && isFinite(state);
    figures.contacts = report.contactViews;
    figures.dents = report.dents;
    if (!figures.finite) break;
    if (step % lookEvery == 0 || static_cast<double>(step + 1) * dt >= run.seconds) {
      depths.look(state, report.dents, figures);
      figures.insideOutEnd = elementsInsideOut(model, state, stretchLaw);
      figures.insideOut = std::max(figures.insideOut, figures.insideOutEnd);
    }
    figures.restSpeed = fastestPoint(model, state);
    if (run.observe) run.observe(report, state);
    if (figures.restSpeed >= run.bounds.restSpeed || figures.insideOutEnd > 0 || figures.depthShareEnd > 1) unrestful = after;
    if (run.comesToRest && run.quiet > 0 && after > std::max(unrestful, run.loadEnds) + run.quiet) break;
    figures.timeUp = run.timeLimit > 0 && threadSeconds() - begun > run.timeLimit;
    if (figures.timeUp) break;
  }
  figures.secondsToRest = std::max(0.0, unrestful - run.loadEnds);
  if (figures.finite) figures.moved = movedFar(model, state);
  figures.end = std::move(state);
  return figures;
}

std::vector<std::string> brokenBounds(const StabilityRun& run, const StabilityFigures& figures, bool carries) {
  std::vector<std::string> broken;
  if (!figures.finite) return {"not-finite"};
  if (figures.rejected > run.bounds.rejectedSteps || !figures.endsTaken) broken.push_back("rejected-steps");
  if (figures.energyExcess > run.bounds.energyExcess) broken.push_back("energy");
  if (figures.depthShare > 1) broken.push_back("depth");
  if (figures.timeUp && carries) broken.push_back("time-up");
  if (!run.comesToRest || !carries || figures.timeUp || figures.secondsToRest <= run.bounds.secondsToRest) return broken;
  // What keeps it from rest.
  if (figures.insideOutEnd > 0) broken.push_back("inside-out");
  if (figures.depthShareEnd > 1) broken.push_back("too-deep-at-end");
  if (figures.restSpeed >= run.bounds.restSpeed || broken.empty()) broken.push_back("not-at-rest");
  return broken;
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

}  // namespace glenoid
