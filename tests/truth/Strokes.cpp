// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/truth/Strokes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "simcore/author/MakeDents.h"
#include "simcore/embed/Cells.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/TriangleUse.h"
#include "simcore/spatial/TriangleTree.h"
#include "simcore/step/Stepper.h"
#include "tests/scenes/LadderScenes.h"

namespace glenoid::truth {

namespace {

std::vector<double> steps(double from, double to, double size) {
  const int count = std::max(1, static_cast<int>(std::lround((to - from) / size)));
  std::vector<double> at;
  for (int i = 0; i <= count; ++i) at.push_back(from + (to - from) * i / count);
  return at;
}

/// Where a place of the straight slab lies, and what is up there.
Vec3 shaped(const Slab& slab, const Vec3& p) {
  Vec3 q = p;
  if (slab.curvature != 0) {
    const double radius = 1 / slab.curvature, angle = p.x() * slab.curvature;
    q = Vec3((radius + p.y()) * std::sin(angle), (radius + p.y()) * std::cos(angle) - radius, p.z());
  }
  return Eigen::AngleAxisd(slab.slope, Vec3::UnitZ()) * q;
}
Vec3 upAt(const Slab& slab, const Vec3& p) { return Eigen::AngleAxisd(slab.slope - p.x() * slab.curvature, Vec3::UnitZ()) * Vec3::UnitY(); }

/// One layer of it: triangles of a size, and where their middles were before it was shaped.
struct Layer {
  TriMesh mesh;
  std::vector<Vec3> middles;
};
Layer layerOf(const Slab& slab, double low, double high, double size) {
  Layer layer{scenes::gradedSurface(steps(-slab.length / 2, slab.length / 2, size), steps(low, high, size), steps(-slab.width / 2, slab.width / 2, size)), {}};
  for (const auto& c : layer.mesh.triangles)
    layer.middles.push_back((layer.mesh.vertices[c[0]] + layer.mesh.vertices[c[1]] + layer.mesh.vertices[c[2]]) / 3);
  for (Vec3& v : layer.mesh.vertices) v = shaped(slab, v);
  return layer;
}

Region regionWhere(const std::string& id, const Layer& layer, const std::function<bool(const Vec3&)>& in) {
  Region region;
  region.id = id;
  for (std::size_t t = 0; t < layer.middles.size(); ++t)
    if (in(layer.middles[t])) region.triangles.push_back({static_cast<int>(t), 1});
  return region;
}

/// A layer as a part whose base is a region.
Part softLayer(const Slab& slab, const std::string& id, int number, double low, double high, double cell) {
  Part soft = scenes::boxPart(id, number, PartKind::Soft, Vec3(-0.01, -0.01, -0.01), Vec3(0.01, 0.01, 0.01));
  const Layer visual = layerOf(slab, low, high, slab.facet);
  soft.visual = std::make_shared<const TriMesh>(visual.mesh);
  soft.collision = std::make_shared<const TriMesh>(layerOf(slab, low, high, slab.collisionFacet).mesh);
  soft.volume = std::make_shared<const TetMesh>(embedInCells(*soft.visual, *soft.collision, cell).value());
  soft.cellSize = cell;
  soft.elements = slab.elements;
  soft.regions = {regionWhere("base", visual, [&](const Vec3& p) { return p.y() < low + 1e-6; })};
  if (slab.inclusion != 1) {
    soft.regions.push_back(regionWhere("inclusion", visual, [](const Vec3& p) {
      return p.y() > -1e-6 && std::abs(p.x()) < kInclusion / 2 && std::abs(p.z()) < kInclusion / 2;
    }));
    soft.materials.push_back({"inclusion", "inclusion"});
  }
  return soft;
}

Joint jointOf(const Slab& slab, double cell) {
  Joint joint;
  joint.id = "slab";
  scenes::addMaterials(joint);
  Material& tissue = *std::find_if(joint.materials.begin(), joint.materials.end(), [](const Material& m) { return m.id == "tissue"; });
  tissue.youngsModulus = slab.young;
  tissue.poissonRatio = slab.poisson;
  tissue.friction = 0;
  tissue.massDamping = 5;
  tissue.stiffnessDamping = 0.005;
  Material stiffer = tissue;
  stiffer.id = "inclusion";
  stiffer.youngsModulus *= slab.inclusion;
  joint.materials.push_back(stiffer);
  joint.parts = {softLayer(slab, "slab", 1, slab.upper > 0 ? -slab.upper : -slab.thickness, 0, cell),
                 scenes::boxPart("plate", 2, PartKind::Rigid, Vec3(-slab.length, -0.2, -slab.length), Vec3(slab.length, -0.15, slab.length))};
  if (slab.upper > 0) {
    joint.parts.push_back(softLayer(slab, "lower", 3, -slab.thickness, -slab.upper, cell));
    joint.couplings.push_back({"between", "slab", "lower", "base", 1e9, 1e-3, {}});
    joint.couplings.push_back({"glue", "lower", "plate", "base", 1e9, 1e-3, {}});
    joint.exclusions = {{"slab", "plate", "glued"}, {"lower", "plate", "glued"}, {"slab", "lower", "glued"}};
  } else {
    joint.couplings.push_back({"glue", "slab", "plate", "base", 1e9, 1e-3, {}});
    joint.exclusions = {{"slab", "plate", "glued"}};
  }
  return joint;
}

}  // namespace

std::shared_ptr<const DentTable> dentsOf(const Slab& slab, int places) {
  Joint joint = jointOf(slab, 0.01);
  Part& part = joint.parts[0];
  DentWishes wishes;
  wishes.places = places;
  wishes.part = "slab";
  const Layer layer = layerOf(slab, slab.upper > 0 ? -slab.upper : -slab.thickness, 0, slab.facet);
  const auto nearMiddle = [&](const Vec3& p) { return p.y() > -1e-6 && std::abs(p.x()) < 0.22 * slab.length && std::abs(p.z()) < 0.2 * slab.width; };
  if (slab.inclusion == 1) {
    // The middle of the top as a tissue of its own has its own places; those elsewhere are near sides that no stroke reaches.
    part.regions.push_back(regionWhere("middle", layer, nearMiddle));
    part.materials.push_back({part.materials[0].material, "middle"});
  }
  makeDents(joint, wishes).value();
  DentTable table = *part.dents;
  if (slab.inclusion == 1) {
    const std::vector<int> use = useOfTriangles(part);
    const TriangleTree tree(*part.visual);
    std::erase_if(table.samples, [&](const DentSample& s) { return use[static_cast<std::size_t>(tree.closest(s.at_W).triangle)] == 0; });
  }
  const Joint plain = jointOf(slab, 0.01);
  table.basis = dentBasis(plain, plain.parts[0]);
  return std::make_shared<const DentTable>(table);
}

double fineForce(const Slab& slab, double radius, double depth) {
  const Joint joint = jointOf(slab, 0.01);
  const Part& part = joint.parts[0];
  const double modulus = slab.inclusion * slab.young / (1 - slab.poisson * slab.poisson), pi = std::numbers::pi;
  // The depth rises with the force: halving finds the one that is asked for.
  double low = 0, high = 4.0 / 3 * modulus * std::sqrt(radius) * std::pow(depth, 1.5) * 2;
  for (int n = 0; n < 6; ++n) {
    const double force = 0.5 * (low + high), contact = std::cbrt(0.75 * force * radius / modulus);
    const TipPatch patch = tipPatchAt(*part.visual, Vec3(0.3e-3, 0, 0.4e-3), contact);
    GradedCells cells = fineCells(part, contact);
    cells.finest /= 1.2;
    const auto mesh = std::make_shared<const TetMesh>(embedGraded(part, patch, cells).value());
    const double even = force * StaticPart::make(joint, 0, mesh, TetFilling::Whole).value().compliance(patch);
    const double lies = even + contact * contact / radius - force * 16 / (3 * pi * pi * modulus * contact);
    (lies < depth ? low : high) = force;
  }
  return 0.5 * (low + high);
}

Felt stroke(const Slab& slab, std::shared_ptr<const DentTable> dents, double cell, const Stroke& stroke) {
  Joint joint = jointOf(slab, cell);
  joint.parts[0].dents = std::move(dents);
  Scenario scenario;
  scenario.id = "stroke";
  scenario.gravity_W = Vec3::Zero();
  scenario.fixedParts = {"plate"};
  Tool tool;
  tool.id = "tool";
  tool.kind = stroke.kind;
  tool.length = 0.08;
  tool.radius = stroke.radius;
  tool.mass = 0.08;
  tool.stiffness = 2000;
  tool.angularStiffness = 20;
  tool.forceMax = 30;
  tool.friction = 0;
  // Along the straight slab: where the hand is above or below the top, and how it stands there.
  const auto placeOn = [&](double gone) { return Vec3(0.0007 + gone * std::cos(slab.turn), 0, 0.0013 + gone * std::sin(slab.turn)); };
  const auto handAt = [&](double gone, double height) {
    const Vec3 p = placeOn(gone), up = upAt(slab, p);
    return Pose{shaped(slab, p) + height * up, Quat::FromTwoVectors(Vec3::UnitZ(), up)};
  };
  constexpr double kAbove = 0.004, kSpeed = 0.02, kPress = 0.3, kRest = 0.5;  // m, m/s, s, s
  tool.home = handAt(-0.5 * stroke.way, kAbove);
  scenario.tools = {tool};
  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  Inputs inputs;
  inputs.hands = {tool.home};
  const int offset = model->objects.back().layout.qOffset;
  const Vec3 tip_B = tool.home.q_WB.conjugate() * (tool.home.p_WB - poseAt(state.q, offset).p_WB);
  Felt felt;
  double least = 1e300, most = 0;
  const double dt = scenario.dt, end = kPress + kRest + stroke.way / kSpeed;
  for (double t = 0; t < end; t += dt) {
    const double in = std::min(1.0, t / kPress), gone = std::clamp((t - kPress - kRest) * kSpeed, 0.0, stroke.way) - 0.5 * stroke.way;
    inputs.hands[0] = handAt(gone, (1 - in) * kAbove - in * stroke.depth);
    const StepReport& report = stepper.step(inputs, state);
    if (t < kPress + kRest + 0.1) continue;
    const Vec3 up = upAt(slab, placeOn(gone)), total = report.toolForces[0];
    const double force = total.dot(up);
    least = std::min(least, force);
    most = std::max(most, force);
    felt.mean += force;
    felt.sideways = std::max(felt.sideways, (total - force * up).norm());
    felt.depth -= (poseAt(state.q, offset) * tip_B - shaped(slab, placeOn(gone))).dot(up);
    felt.trace.push_back({gone, force});
  }
  const auto count = static_cast<double>(felt.trace.size());
  felt.mean /= count;
  felt.depth /= count;
  felt.spread = (most - least) / felt.mean;
  felt.sideways /= felt.mean;
  return felt;
}

}  // namespace glenoid::truth
