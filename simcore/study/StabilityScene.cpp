// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/StabilityScene.h"

#include <algorithm>
#include <cmath>

#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& id) { return std::find(list.begin(), list.end(), id) != list.end(); }

double densityOf(const Joint& joint, const Part& part) {
  const int material = part.materials.empty() ? -1 : findMaterial(joint, part.materials[0].material);
  return material < 0 ? Material{}.density : joint.materials[static_cast<std::size_t>(material)].density;
}

double massOf(const Joint& joint, const Part& part) { return densityOf(joint, part) * std::abs(enclosedVolume(*part.visual)); }

/// What a run of a joint alone needs around it.
Scenario scenarioAround(const Joint& joint) {
  Scenario scenario;
  scenario.id = joint.id;
  scenario.name = joint.name;
  const Part* heaviest = nullptr;
  for (const Part& part : joint.parts) {
    const bool better = !heaviest || (part.kind == PartKind::Rigid && heaviest->kind == PartKind::Soft) ||
                        (part.kind == heaviest->kind && massOf(joint, part) > massOf(joint, *heaviest));
    if (better) heaviest = &part;
  }
  for (const Part& part : joint.parts) {
    const bool coupled = std::any_of(joint.couplings.begin(), joint.couplings.end(),
                                     [&](const Coupling& c) { return c.partA == part.id || c.partB == part.id; });
    if (&part == heaviest || (part.kind == PartKind::Soft && !coupled)) scenario.fixedParts.push_back(part.id);
    else if (part.kind == PartKind::Rigid) {
      Hold hold;
      hold.part = part.id;
      scenario.holds.push_back(hold);
    }
  }
  return scenario;
}

/// A finger before the first part that a look from one of six sides through the middle meets, clear of everything.
Tool fingerBefore(const Joint& joint) {
  std::vector<TriangleTree> trees;
  Box3 box;
  for (const Part& part : joint.parts) {
    trees.emplace_back(*part.visual);
    box.extend(boundsOf(*part.visual));
  }
  const double reach = box.diagonal().norm();
  Tool finger;
  finger.id = finger.name = "gauntlet-finger";
  finger.kind = ToolKind::Finger;
  finger.radius = std::min(0.006, 0.05 * reach);
  finger.length = 10 * finger.radius;
  finger.home.p_WB = box.center() + reach * Vec3::UnitX();
  Vec3 outward = Vec3::UnitX();
  double nearest = HUGE_VAL;
  for (int side = 0; side < 6 && !std::isfinite(nearest); ++side) {
    outward = (side % 2 ? -1 : 1) * Vec3::Unit(side / 2);
    for (const TriangleTree& tree : trees)
      if (const auto hit = tree.cast(box.center() + reach * outward, -outward)) nearest = std::min(nearest, hit->distance);
  }
  if (std::isfinite(nearest)) {
    const auto clear = [&](const Vec3& p) {
      return std::all_of(trees.begin(), trees.end(), [&](const TriangleTree& tree) { return tree.closest(p).distance > finger.radius + 0.005; });
    };
    double back = 0.02;
    do finger.home.p_WB = box.center() + (reach - nearest + back) * outward, back += 0.01;
    while (!clear(finger.home.p_WB) && back < reach);
  }
  finger.home.q_WB = Quat::FromTwoVectors(Vec3::UnitZ(), outward);
  return finger;
}

}  // namespace

StabilityScene stabilityScene(Joint joint, const std::optional<Scenario>& wanted) {
  Scenario scenario = wanted ? *wanted : scenarioAround(joint);
  scenario.input.clear();
  for (Motion& motion : scenario.motions)
    if (motion.keys.size() > 1) motion.keys.resize(1);
  if (scenario.tools.empty() && !joint.parts.empty()) scenario.tools.push_back(fingerBefore(joint));
  return {std::move(joint), std::move(scenario)};
}

CarriedShare carriedShare(const Joint& joint, const Scenario& scenario) {
  CarriedShare most;
  for (const Part& part : joint.parts) {
    if (part.kind != PartKind::Soft || contains(scenario.fixedParts, part.id) || part.materials.empty()) continue;
    double pull = scenario.effects.gravity == Wish::Off ? 0 : scenario.gravity_W.norm() * massOf(joint, part);
    for (const Load& load : scenario.loads)
      if (load.part == part.id) pull += load.force_W.norm();
    const int material = findMaterial(joint, part.materials[0].material);
    const double section = std::cbrt(std::pow(std::abs(enclosedVolume(*part.visual)), 2));
    const double share = pull / (joint.materials[static_cast<std::size_t>(std::max(material, 0))].youngsModulus * section);
    if (share > most.share || most.part.empty()) most = {share, part.id};
  }
  return most;
}

}  // namespace glenoid
