// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/resources/Indentation.h"

#include <cmath>
#include <numbers>

#include "simcore/author/MakeDents.h"
#include "simcore/scene/TriangleUse.h"
#include "simcore/spatial/TriangleTree.h"
#include "simcore/step/Stepper.h"

namespace glenoid::test {

namespace {

constexpr double kForce = 2;  // N

bool contains(const std::string& list, const std::string& word) { return ("," + list + ",").find("," + word + ",") != std::string::npos; }

/// The tip alone: the frame's origin, wherever the body's own frame lies.
struct Tip {
  Tip(const Model& model, const Tool& tool) : offset(model.objects.back().layout.qOffset) {
    centre_T = tool.home.q_WB.conjugate() * (poseAt(model.start.q, offset).p_WB - tool.home.p_WB);
  }
  Vec3 at(const State& state) const { return poseAt(state.q, offset) * Vec3(-centre_T); }
  int offset;
  Vec3 centre_T;
};

}  // namespace

Vec3 middleOf(const Part& part, const std::string& region) {
  std::vector<char> counts(part.visual->triangles.size(), region.empty() || region[0] == '-');
  for (const Region& each : part.regions) {
    const bool named = region == each.id, left = !region.empty() && region[0] == '-' && contains(region.substr(1), each.id);
    if (named || left)
      for (const int t : trianglesOf(each)) counts[static_cast<std::size_t>(t)] = named;
  }
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (std::size_t t = 0; t < counts.size(); ++t) {
    if (!counts[t]) continue;
    const auto& c = part.visual->triangles[t];
    const Vec3 &x = part.visual->vertices[c[0]], &y = part.visual->vertices[c[1]], &z = part.visual->vertices[c[2]];
    const double share = 0.5 * (y - x).cross(z - x).norm();
    sum += share * (x + y + z) / 3;
    area += share;
  }
  return sum / area;
}

double fineIndentation(const Joint& joint, const std::string& id, const TipPatch& patch, bool refined) {
  const int index = findPart(joint, id);
  const Part& part = joint.parts[static_cast<std::size_t>(index)];
  const int use = useOfTriangles(part)[static_cast<std::size_t>(TriangleTree(*part.visual).closest(patch.middle_W).triangle)];
  const Material& material = joint.materials[static_cast<std::size_t>(findMaterial(joint, part.materials[static_cast<std::size_t>(use)].material))];
  const double modulus = material.youngsModulus / (1 - material.poissonRatio * material.poissonRatio), radius = patch.radius;
  const double hertz = std::cbrt(0.75 * kForce * radius / modulus), contact = std::min(hertz, radius);
  // A ball that has gone in to its middle is a punch of its own radius.
  const double ball = hertz < radius ? hertz * hertz / radius : radius + (kForce - 4.0 / 3 * modulus * radius * radius) / (2 * radius * modulus);
  const double pressed = std::max(contact, 0.3 * radius), pi = std::numbers::pi;  // no smaller patch than the cells can show
  const TipPatch under = tipPatchAt(*part.visual, patch.middle_W, pressed);
  GradedCells cells = fineCells(part, pressed);
  if (refined) {
    cells.finest /= 1.4;
    cells.coarsest /= 1.4;
  }
  auto mesh = embedGraded(part, under, cells).value();
  const double even = kForce * StaticPart::make(joint, index, std::make_shared<const TetMesh>(std::move(mesh)), TetFilling::Whole).value().compliance(under);
  return even + ball - kForce * 16 / (3 * pi * pi * modulus * pressed);
}

Pressed pressWithTip(const Joint& whole, const std::string& id, const TipPatch& patch, Wish dent) {
  Joint joint = whole;
  Scenario scenario;
  scenario.id = "press";
  scenario.gravity_W = Vec3::Zero();
  scenario.effects.bursa = Wish::Off;
  scenario.effects.friction = Wish::Off;
  scenario.effects.dent = dent;
  joint.bursae.clear();
  Tool tip;
  tip.id = "tip";
  tip.kind = ToolKind::Ball;
  tip.radius = patch.radius;
  tip.home.q_WB = Quat::FromTwoVectors(Vec3::UnitZ(), patch.normal_W);
  tip.home.p_WB = patch.middle_W + 3e-3 * patch.normal_W;
  tip.stiffness = 8000;  // a hand that does not give way sideways
  tip.angularStiffness = 50;
  for (const Part& part : joint.parts) {
    if (part.id == id) continue;
    scenario.fixedParts.push_back(part.id);
    tip.perforates.push_back(part.id);
    joint.exclusions.push_back({id, part.id, "pressed alone"});
  }
  scenario.tools = {tip};
  const auto model = compileModel(joint, scenario).value();
  const Tip point(*model, tip);
  Stepper stepper(model, {});
  State state = model->start;
  Inputs inputs;
  inputs.hands = {tip.home};
  Pressed pressed;
  double pushed = 0, touched = NAN, along = 0;
  const auto height = [&] { return (point.at(state) - patch.middle_W).dot(patch.normal_W); };
  for (int n = 0, calm = 0; n < 6000 && !pressed.settled; ++n) {
    // At most 5 mm/s, slower where the force is nearly there.
    const double step = std::min(1e-5, 0.05 * (kForce - pressed.force) / tip.stiffness);
    pushed += step;
    inputs.hands[0].p_WB = tip.home.p_WB - pushed * patch.normal_W;
    const double before = height();
    const StepReport& report = stepper.step(inputs, state);
    pressed.force = report.toolForces[0].dot(patch.normal_W);
    if (std::isnan(touched) && pressed.force > 0) touched = before;
    along = height();
    pressed.dent = 0;
    for (const DentView& view : report.dents) pressed.dent = std::max(pressed.dent, view.depth);
    calm = std::abs(pressed.force - kForce) < 0.01 * kForce && std::abs(along - before) < 1e-7 ? calm + 1 : 0;
    pressed.settled = calm > 20;
  }
  pressed.travel = touched - along;
  const Vec3 off = point.at(state) - patch.middle_W;
  pressed.drift = (off - off.dot(patch.normal_W) * patch.normal_W).norm();
  return pressed;
}

}  // namespace glenoid::test
