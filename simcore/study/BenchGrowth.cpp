// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "simcore/collide/ProximityFinder.h"
#include "simcore/study/Bench.h"
#include "simcore/study/Machine.h"
#include "simcore/study/RefineJoint.h"

namespace glenoid {
namespace {

constexpr int kSettlingSteps = 4;  ///< with the hands where they are: the finer surface finds its own contacts

long tetrahedraOf(const Joint& joint) {
  long count = 0;
  for (const Part& part : joint.parts)
    if (part.volume) count += static_cast<long>(part.volume->tets.size());
  return count;
}

long collisionTrianglesOf(const Model& model) {
  long count = 0;
  for (const SceneObject& object : model.objects) count += static_cast<long>(object.collision.mesh->triangles.size());
  return count;
}

/// Pairs of triangles whose boxes overlap: what is near, before any exact test.
long nearTrianglePairs(const Model& model, const State& state) {
  std::vector<std::vector<Vec3>> positions, velocities;
  std::vector<std::span<const Vec3>> positionSpans, velocitySpans;
  for (const SceneObject& object : model.objects) {
    auto& x = positions.emplace_back(object.collision.vertices.size());
    auto& v = velocities.emplace_back(object.collision.vertices.size(), Vec3::Zero());
    surfacePositions(object.collision, object.layout, state.q, x);
    if (object.layout.free) surfaceVelocities(object.collision, object.layout, state.q, state.v, v);
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positionSpans.emplace_back(positions[i]);
    velocitySpans.emplace_back(velocities[i]);
  }
  ProximityFinder finder(model.collisionSurfaces, model.collisionPairs);
  finder.find(positionSpans, velocitySpans, model.scenario.contactDistance, model.scenario.dt);
  return finder.counts().trianglePairs;
}

/// Slope of log y over log x by least squares; nothing for fewer than two points.
StudyCell exponentOf(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double a = std::log(x[i]), b = std::log(y[i]);
    sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  const double below = n * sxx - sx * sx;
  if (x.size() < 2 || !(below > 0)) return {};
  return (n * sxy - sx * sy) / below;
}

}  // namespace

Result<std::vector<StudyTable>> benchGrowth(const StudyScene& scene, const BenchOptions& options) {
  const auto progress = [&](double fraction) { return !options.progress || options.progress("growth", fraction); };
  const auto states = findContactStates(scene, {options.contacts.front()}, [&](double done) { return progress(0.1 * done); });
  if (!states) return states.error();
  const ContactState& start = states->front();
  const Scenario scenario = scenarioOf(scene, start);
  const auto coarse = compileModel(scene.joint, scenario);
  if (!coarse) return coarse.error();

  StudyTable table;
  table.id = "growth";
  table.columns = {"wanted", "tetrahedra", "velocities", "collisionTriangles", "contacts", "pressing", "repeats", "stepMedianMs",
                   "stepP95Ms", "stepP99Ms", "stepP999Ms", "wallMedianMs", "assembleMs", "factorMs", "delassusMs", "contactMs",
                   "collideMs", "nearTrianglePairs", "memoryMiB", "taken", "solver"};
  std::vector<double> tets, ms, collideMs, contacts, near;
  for (std::size_t i = 0; i < options.tetrahedra.size(); ++i) {
    const double begin = 0.1 + 0.9 * static_cast<double>(i) / static_cast<double>(options.tetrahedra.size());
    const double factor = std::max(1.0, options.tetrahedra[i] / static_cast<double>(tetrahedraOf(scene.joint)));
    // Within two hundredths of the joint as it is, it is taken as it is.
    const auto joint = refineJoint(scene.joint, factor < 1.02 ? 1 : factor, 0.4e-3,
                                   [&](const std::string&, double) { return progress(begin); });
    if (!joint) return joint.error();
    const auto model = compileModel(*joint, scenario);
    if (!model) return model.error();
    State state = carryToRefined(**coarse, start.state, **model);
    {
      Stepper stepper(*model, {});
      for (int s = 0; s < kSettlingSteps; ++s) stepper.step(start.inputs, state);
    }
    const StepCost cost = measureStep(*model, {}, state, start.inputs, options.grown);
    const auto stage = [&](Stage which) { return cost.stages[static_cast<int>(which)].median; };
    const long nearPairs = nearTrianglePairs(**model, state);
    table.rows.push_back({long{options.tetrahedra[i]}, tetrahedraOf(*joint), static_cast<long>(state.v.size()),
                          collisionTrianglesOf(**model), long{cost.contacts}, long{cost.pressing}, cost.repeats, cost.cpu.median,
                          cost.cpu.p95, cost.cpu.p99, cost.cpu.p999, cost.wall.median, stage(Stage::Assemble), stage(Stage::Factor),
                          stage(Stage::Delassus), stage(Stage::Contact), stage(Stage::Collide), nearPairs, cost.memoryMiB,
                          cost.taken, std::string(solverName(**model, Profile::Direct))});
    tets.push_back(static_cast<double>(tetrahedraOf(*joint)));
    ms.push_back(cost.cpu.median);
    collideMs.push_back(stage(Stage::Collide));
    contacts.push_back(std::max(1, cost.contacts));
    near.push_back(static_cast<double>(std::max(1L, nearPairs)));
  }
  table.facts = {{"stepExponent", exponentOf(tets, ms)},
                 {"contactsExponent", exponentOf(tets, contacts)},
                 {"collideExponent", exponentOf(tets, collideMs)},
                 {"collideExponentOverNear", exponentOf(near, collideMs)},
                 {"memoryPeakMiB", residentPeakMiB()}};
  return std::vector<StudyTable>{std::move(table)};
}

}  // namespace glenoid
