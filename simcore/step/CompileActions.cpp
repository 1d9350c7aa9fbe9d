// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/CompileActions.h"

#include <algorithm>

#include "simcore/embed/Bind.h"
#include "simcore/step/Actions.h"
#include "simcore/step/RegionPoints.h"

namespace glenoid {

namespace {

Error at(Error error, const char* list, std::size_t index, const std::string& part) {
  error.place.pointer = std::string("/") + list + "/" + std::to_string(index);
  error.place.part = part;
  return error;
}

/// The material point of a soft part that rests at `rest_W`; nothing where no tetrahedron holds it.
std::optional<VertexBinding> softPoint(const SceneObject& object, const Vec3& rest_W) {
  const VertexBinding binding = bindToTets(*object.volume, {&rest_W, 1})[0];
  // A point that somebody typed, on a face whose nodes came through files: a ten-thousandth of a cell is on it.
  constexpr double kOnFace = 1e-4;
  // Whole cells may have left a sliver out whose tissue goes on from its neighbour (embed/WholeCells.h).
  constexpr double kInSliver = 1;
  if (*std::min_element(binding.weight.begin(), binding.weight.end()) < -(object.cells ? kInSliver : kOnFace)) return std::nullopt;
  return binding;
}

Result<Done> compileLoads(const Model& model, StepModel& inside, const std::vector<Vec3>& centres) {
  for (std::size_t i = 0; i < model.scenario.loads.size(); ++i) {
    const Load& load = model.scenario.loads[i];
    const int object = findPart(model.joint, load.part);  // parts come first, in the joint's order
    if (inside.islandOfObject[object] < 0) continue;      // nothing moves a fixed part
    BoundLoad bound;
    bound.object = object;
    bound.base = inside.baseOfObject[object];
    bound.force_W = load.force_W;
    bound.torque_W = load.torque_W;
    if (model.objects[object].layout.rigid) {
      bound.point.r_B = load.point_W.value_or(Vec3::Zero()) - centres[object];
    } else if (load.point_W) {
      const std::optional<VertexBinding> binding = softPoint(model.objects[object], *load.point_W);
      if (!binding) return at({Fault::Unusable, {}, {"the point of a load rests outside the part's tetrahedra"}, ""}, "loads", i, load.part);
      bound.point = pointAt(*binding, false);
    } else {
      bound.spread = true;
    }
    inside.islands[inside.islandOfObject[object]].loads.push_back(bound);
  }
  return Done{};
}

Result<Done> compilePressures(const Model& model, StepModel& inside, const std::vector<Vec3>& centres) {
  for (std::size_t i = 0; i < model.scenario.pressures.size(); ++i) {
    const Pressure& pressure = model.scenario.pressures[i];
    const int object = findPart(model.joint, pressure.part);
    if (inside.islandOfObject[object] < 0) continue;
    Result<RegionPoints> region = regionPoints(model.objects[object], model.joint.parts[object], pressure.region, centres[object]);
    if (!region) return at(region.error(), "pressures", i, pressure.part);
    inside.islands[inside.islandOfObject[object]].pressures.push_back(
        {object, inside.baseOfObject[object], static_cast<int>(i), pressure.pressure, std::move(region->points), std::move(region->triangles)});
  }
  return Done{};
}

Result<Done> compileSupports(const Model& model, StepModel& inside, const std::vector<Vec3>& centres) {
  for (std::size_t i = 0; i < model.scenario.supports.size(); ++i) {
    const Support& support = model.scenario.supports[i];
    const int object = findPart(model.joint, support.part);
    if (inside.islandOfObject[object] < 0) continue;
    const Result<RegionPoints> region = regionPoints(model.objects[object], model.joint.parts[object], support.region, centres[object]);
    if (!region) return at(region.error(), "supports", i, support.part);
    for (std::size_t k = 0; k < region->points.size(); ++k) {
      if (!(region->area[k] > 0)) continue;
      BoundSupport bound;
      bound.object = inside.objects[object].get();
      bound.base = inside.baseOfObject[object];
      bound.support = static_cast<int>(i);
      bound.point = region->points[k];
      bound.rest_W = region->rest_W[k];
      bound.stiffness = support.stiffnessPerArea * region->area[k] * support.axes.mask();
      if (inside.settings.damping) bound.damping = support.damping * bound.stiffness;
      inside.islands[inside.islandOfObject[object]].supports.push_back(std::move(bound));
    }
  }
  return Done{};
}

}  // namespace

Result<Done> checkActions(const Joint& joint, const Scenario& scenario) {
  const auto known = [&](const auto& actions, const char* list) -> Result<Done> {
    for (std::size_t i = 0; i < actions.size(); ++i)
      if (findPart(joint, actions[i].part) < 0) return at({Fault::UnknownId, {}, {actions[i].part, "part"}, ""}, list, i, "");
    return Done{};
  };
  if (auto good = known(scenario.loads, "loads"); !good) return good;
  if (auto good = known(scenario.pressures, "pressures"); !good) return good;
  if (auto good = known(scenario.supports, "supports"); !good) return good;
  if (auto good = known(scenario.motions, "motions"); !good) return good;
  for (std::size_t i = 0; i < scenario.loads.size(); ++i) {
    const Load& load = scenario.loads[i];
    if (!load.torque_W.isZero(0) && joint.parts[findPart(joint, load.part)].kind != PartKind::Rigid)
      return at({Fault::Unusable, {}, {"a torque on a soft part"}, ""}, "loads", i, load.part);
  }
  for (std::size_t i = 0; i < scenario.motions.size(); ++i) {
    const Motion& motion = scenario.motions[i];
    if (motion.keys.empty()) return at({Fault::Unusable, {}, {"a motion without keys"}, ""}, "motions", i, motion.part);
    if (std::find(scenario.fixedParts.begin(), scenario.fixedParts.end(), motion.part) == scenario.fixedParts.end())
      return at({Fault::Unusable, {}, {"a motion of a part that is not among fixedParts"}, ""}, "motions", i, motion.part);
  }
  return Done{};
}

void compileMotions(Model& model, StepModel& inside) {
  inside.drivenOfObject.assign(model.objects.size(), -1);
  for (std::size_t i = 0; i < model.scenario.motions.size(); ++i) {
    DrivenObject driven;
    driven.object = findPart(model.joint, model.scenario.motions[i].part);
    driven.motion = static_cast<int>(i);
    SceneObject& object = model.objects[driven.object];
    object.motion = driven.motion;
    for (int k = 0; k < (object.layout.rigid ? 1 : object.layout.nodeCount); ++k)
      driven.rest_W.push_back(model.start.q.segment<3>(object.layout.qOffset + 3 * k));
    inside.drivenOfObject[driven.object] = static_cast<int>(inside.driven.size());
    inside.driven.push_back(std::move(driven));
  }
  placeDriven(model, inside, 0, model.start.q);
}

Result<Done> compileActions(const Model& model, StepModel& inside, const std::vector<Vec3>& centres) {
  if (Result<Done> done = compileLoads(model, inside, centres); !done) return done;
  if (Result<Done> done = compilePressures(model, inside, centres); !done) return done;
  return compileSupports(model, inside, centres);
}

void appendSupportPairs(const BoundSupport& support, const VecX& q, std::vector<std::array<int, 2>>& pairs) {
  RowTerm terms[kMaxPointTerms];
  const int count = support.object->rowTerms(support.point, Vec3::UnitX(), q, support.base, terms);
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < i; ++j) pairs.push_back({terms[i].block, terms[j].block});
}

void bindSupport(BoundSupport& support, const VecX& q, const BlockSymbolic& symbolic) {
  RowTerm terms[kMaxPointTerms];
  const int count = support.object->rowTerms(support.point, Vec3::UnitX(), q, support.base, terms);
  support.entries.clear();
  for (int i = 0; i < count; ++i)
    for (int j = 0; j <= i; ++j) support.entries.push_back(symbolic.entry(terms[i].block, terms[j].block));
}

}  // namespace glenoid
