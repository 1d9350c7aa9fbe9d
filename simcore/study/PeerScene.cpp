// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/PeerScene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/mesh/TetTools.h"
#include "simcore/study/PeerBlocks.h"

namespace glenoid::peers {

namespace {

constexpr double kLength = 0.08;                               // m, of every block between the bones
constexpr double kBetween = 0.002;                             // m, between two blocks
constexpr double kRidgeRise = 0.003, kRidgeStart = -0.001;     // m, of its top against the blocks' undersides
constexpr double kRidgeHalf = 0.015, kRidgeOverhang = 0.01;    // m
constexpr double kBoneHalfX = 0.01, kBoneHalfY = 0.03, kBoneAbove = 0.015;  // m; its centre above the undersides
constexpr double kBoneGap = 0.002;                             // m, between a bone and the blocks' ends

double totalWidth() {
  double width = -kBetween;
  for (const BlockShape& shape : blockShapes()) width += shape.width + kBetween;
  return width;
}

/// Corner of all blocks (fixed end, underside, first block) in W.
Vec3 corner() { return {-kLength - kBoneGap - kBoneHalfX, -kBoneAbove, -0.5 * totalWidth()}; }

/// Across the blocks, from the corner: where a block begins.
double beginOf(int block) {
  double at = 0;
  for (int i = 0; i < block; ++i) at += blockShapes()[i].width + kBetween;
  return at;
}

Part makePart(const std::string& id, int number, PartKind kind, TriMesh surface) {
  Part part;
  part.id = part.name = id;
  part.number = number;
  part.kind = kind;
  part.visual = part.collision = std::make_shared<TriMesh>(std::move(surface));
  return part;
}

/// All triangles of the surface in the plane x = const.
Region endRegion(const Part& part, const std::string& id, double x) {
  std::vector<int> triangles;
  for (std::size_t t = 0; t < part.visual->triangles.size(); ++t) {
    const auto& corners = part.visual->triangles[t];
    if (std::all_of(corners.begin(), corners.end(),
                    [&](int v) { return std::abs(part.visual->vertices[v].x() - x) < 1e-9; }))
      triangles.push_back(static_cast<int>(t));
  }
  return {id, id, "footprint", SurfaceKind::Visual, runsOf(triangles)};
}

Part makeBone(const std::string& id, int number, double x) {
  const double half = 0.5 * totalWidth() + 0.01;
  const Vec3 reach(kBoneHalfX, kBoneHalfY, half);
  Part bone = makePart(id, number, PartKind::Rigid, boxSurface(Vec3(x, 0, 0) - reach, Vec3(x, 0, 0) + reach));
  bone.materials = {{"bone", ""}};
  bone.color = {0.9f, 0.87f, 0.8f};
  return bone;
}

double smoothstep(double from, double to, double x) {
  const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

}  // namespace

const char* stiffnessName(Stiffness stiffness) {
  switch (stiffness) {
    case Stiffness::Soft: return "soft";
    case Stiffness::Firm: return "firm";
    case Stiffness::Mixed: return "mixed";
    case Stiffness::Tendon: return "tendon";
  }
  return "";
}

std::array<double, 7> youngsModuli(Stiffness stiffness) {
  std::array<double, 7> alike;
  switch (stiffness) {
    case Stiffness::Soft: alike.fill(20e3); break;
    case Stiffness::Firm: alike.fill(1e6); break;
    case Stiffness::Mixed: return {20e3, 50e3, 100e3, 100e6, 10e6, 200e3, 1e6};
    case Stiffness::Tendon: alike.fill(100e6); break;
  }
  return alike;
}

Joint makeJoint(Stiffness stiffness) {
  Joint joint;
  joint.id = std::string("peers-") + stiffnessName(stiffness);
  joint.name = std::string("Seven blocks, ") + stiffnessName(stiffness);
  const std::array<double, 7> moduli = youngsModuli(stiffness);
  int number = 0;
  for (const BlockShape& shape : blockShapes()) {
    const double width = beginOf(number);
    const auto volume = std::make_shared<TetMesh>(makeBlock(shape, corner() + Vec3(0, 0, width), kLength));
    Part part = makePart(shape.name, number + 1, PartKind::Soft, boundaryOf(*volume));
    part.volume = volume;
    part.cellSize = kLength / shape.cells[0];
    part.color = {0.75f, 0.35f + 0.05f * static_cast<float>(number), 0.35f};
    part.regions = {endRegion(part, "fixed-end", corner().x()), endRegion(part, "moving-end", corner().x() + kLength)};
    Material material;
    material.id = material.name = part.id;
    material.youngsModulus = moduli[number];
    material.stiffnessDamping = 0;  // as the peers: what is lost is lost in the implicit step
    part.materials = {{material.id, ""}};
    joint.materials.push_back(material);
    // 1e7 N/m and more for a node: a hundred newtons open a gap of 3 µm.
    joint.couplings.push_back({part.id + "-fixed", part.id, "fixed-bone", "fixed-end", 1e12, 0});
    joint.couplings.push_back({part.id + "-moving", part.id, "moving-bone", "moving-end", 1e12, 0});
    joint.parts.push_back(std::move(part));
    ++number;
  }
  joint.parts.push_back(makeBone("fixed-bone", 8, corner().x() - kBoneGap - kBoneHalfX));
  joint.parts.push_back(makeBone("moving-bone", 9, 0));
  Material bone;
  bone.id = bone.name = "bone";
  bone.density = 2.0 / enclosedVolume(*joint.parts.back().visual);  // 2 kg
  bone.stiffnessDamping = 0;
  joint.materials.push_back(bone);
  // In the peers only ridge and ball touch the blocks.
  for (std::size_t a = 0; a < joint.parts.size(); ++a)
    for (std::size_t b = a + 1; b < joint.parts.size(); ++b)
      joint.exclusions.push_back({joint.parts[a].id, joint.parts[b].id, "Only ridge and ball touch anything."});
  joint.provenance = {"Glenoid Studio", "GPL-3.0-or-later", "", "generate_peer_scene"};
  return joint;
}

Scenario makeScenario(double dt) {
  Scenario scenario;
  scenario.id = "peers";
  scenario.name = "Seven blocks between two bones";
  scenario.description = "A scene of the shoulder's size without anatomy, measured beside other simulators.";
  scenario.dt = dt;
  scenario.fixedParts = {"fixed-bone"};
  scenario.holds = {{"moving-bone", 2e4, 50, 5e-3}};
  Tool ball;
  ball.id = ball.name = "ball";
  ball.kind = ToolKind::Ball;
  ball.length = 0.06;
  ball.radius = kBallRadius;
  ball.stiffness = 1e8;
  ball.angularStiffness = 1e5;
  ball.forceMax = 1e6;  // a step may bring it a centimetre further
  ball.friction = 0;
  ball.perforates = {"fixed-bone", "moving-bone"};
  Tool ridge = ball;
  ridge.id = ridge.name = "ridge";
  ridge.kind = ToolKind::Bar;
  ridge.length = totalWidth() + 2 * kRidgeOverhang;
  ridge.radius = kRidgeHalf;
  ridge.mass = 1;
  std::vector<Pose> hands;
  handsAt(0, hands);
  ball.home = hands[kBall];
  ridge.home = hands[kRidge];
  scenario.tools = {ball, ridge};
  scenario.cameras = {{"front", "Front", Vec3(-0.2, 0.25, 0.35), Vec3(-0.05, 0, 0), Vec3::UnitY(), 0.6}};
  return scenario;
}

Vec3 ballCentre(double time) {
  const auto& shapes = blockShapes();
  // Beyond the ends the ball comes from, and leaves to, the block it presses.
  const auto top = [&](int block) { return shapes[std::clamp(block, 0, kBlocks - 1)].height + kRidgeRise; };
  const auto middle = [&](int block) {
    const int known = std::clamp(block, 0, kBlocks - 1);
    return beginOf(known) + 0.5 * shapes[known].width;
  };
  const double visits = std::clamp((time - kSettleSeconds) / kPressSeconds, 0.0, kBlocks - 1e-6);
  const int block = static_cast<int>(visits);
  const double s = visits - block;
  constexpr double kNear = 0.002, kClear = 0.005;
  const double arrive = std::max(top(block - 1), top(block)) + kClear;
  const double leave = std::max(top(block), top(block + 1)) + kClear;
  const double over = top(block) + kNear;
  const double across = middle(block - 1) + (middle(block) - middle(block - 1)) * smoothstep(0, 0.2, s);
  double height = arrive + (over - arrive) * smoothstep(0.2, 0.35, s);
  if (s > 0.35 && s < 0.85) {
    const double sine = std::sin(std::numbers::pi * (s - 0.35) / 0.5);
    height -= (0.25 * shapes[block].height + kNear) * sine * sine;
  }
  height += (leave - over) * smoothstep(0.85, 1, s);
  return corner() + Vec3(0.5 * kLength, height + kBallRadius, across);
}

double ridgeTop(double time) {
  return corner().y() + kRidgeStart + (kRidgeRise - kRidgeStart) * smoothstep(0, 0.5 * kSettleSeconds, time);
}

void handsAt(double time, std::vector<Pose>& hands) {
  hands.resize(2);
  hands[kBall] = {ballCentre(time) - kBallRadius * Vec3::UnitY(), Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY())};
  hands[kRidge] = {Vec3(corner().x() + 0.5 * kLength, ridgeTop(time) - kRidgeHalf, corner().z() - kRidgeOverhang),
                   Quat::Identity()};
}

Recording makeRecording(double spacing) {
  Recording recording;
  recording.scenario = "peers.scenario.json";
  recording.profile = "direct";
  recording.tracks = {{"ball", {}}, {"ridge", {}}};
  std::vector<Pose> hands;
  const int last = static_cast<int>(std::lround(kSeconds / spacing));
  for (int i = 0; i <= last; ++i) {
    const double time = i * spacing;
    handsAt(time, hands);
    recording.tracks[kBall].keys.push_back({time, hands[kBall]});
    if (time <= 0.5 * kSettleSeconds + spacing) recording.tracks[kRidge].keys.push_back({time, hands[kRidge]});
  }
  for (int block = 0; block < kBlocks; ++block) {
    const double begin = kSettleSeconds + block * kPressSeconds;
    const std::string& id = blockShapes()[block].name;
    recording.marks.push_back({"press-" + id, begin + 0.35, begin + 0.85, "ball", id});
  }
  return recording;
}

}  // namespace glenoid::peers
