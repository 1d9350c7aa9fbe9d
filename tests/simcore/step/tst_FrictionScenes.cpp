// SPDX-License-Identifier: GPL-3.0-or-later
// Where friction is hard: straps round drums, sheets on sheets, blocks that collapse, piles of loose boxes. Each step
// settles or says that it did not, within a bounded number of Newton steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "simcore/mesh/TetTools.h"
#include "tests/simcore/step/FrictionCourse.h"

namespace glenoid {
namespace {

void print(const char* what, const Course& run) {
  std::printf("%s: %d rows, %d pressing, friction %.2f ms median, %.2f most, Newton steps %d at most, convex in %d, unsettled %ld of %zu, error %.1e m/s\n",
              what, run.rows, run.pressing, medianOf(run.frictionMs), *std::max_element(run.frictionMs.begin(), run.frictionMs.end()), run.newtonMost,
              run.convex, run.unsettled, run.frictionMs.size(), run.worst);
}

Part softPart(const std::string& id, int number, TetMesh volume, double cell) {
  Part part;
  part.id = part.name = id;
  part.number = number;
  part.kind = PartKind::Soft;
  for (std::size_t t = 0; t < volume.tets.size(); ++t)
    if (tetVolume(volume, static_cast<int>(t)) < 0) std::swap(volume.tets[t][0], volume.tets[t][1]);
  TriMesh skin = boundaryOf(volume);
  part.volume = std::make_shared<TetMesh>(std::move(volume));
  part.visual = part.collision = std::make_shared<TriMesh>(std::move(skin));
  part.cellSize = cell;
  part.materials = {{"tissue", ""}};
  return part;
}

struct Scene {
  Joint joint;
  Scenario scenario;
  explicit Scene(double mu) {
    joint.id = joint.name = scenario.id = scenario.name = "friction";
    scenes::addMaterials(joint);
    for (Material& material : joint.materials) material.friction = mu;
    scenario.dt = 5e-3;
    scenario.effects.friction = Wish::On;
  }
};

/// A drum of radius R about Z and a strap that lies round its upper half at rest, each end with a straight tail downwards.
constexpr double kRadius = 0.02, kThick = 0.001, kWide = 0.01, kTail = 0.01;
constexpr int kFacets = 90;

TetMesh strap(int along) {
  TetMesh mesh = scenes::boxVolume(Vec3(0, 0, -kWide / 2), Vec3(1, kThick, kWide / 2), along, 1, 2);
  const double middle = kRadius + kThick / 2, whole = M_PI * middle + 2 * kTail;
  for (Vec3& x : mesh.nodes) {
    const double s = x.x() * whole - kTail, r = kRadius + 1e-4 + x.y();
    const double angle = std::clamp(s / middle, 0.0, M_PI), over = s < 0 ? -s : std::max(0.0, s - M_PI * middle);
    x = Vec3(-r * std::cos(angle), r * std::sin(angle) - over, x.z());
  }
  return mesh;
}

Part drum(int facets) {
  Part part = rigidBox("drum", 1, Vec3(-1, -1, -1), Vec3(1, 1, 1), 1);
  TriMesh mesh;
  for (const double z : {-kWide, kWide})
    for (int k = 0; k < facets; ++k) {
      const double angle = 2 * M_PI * k / facets;
      mesh.vertices.emplace_back(kRadius * std::cos(angle), kRadius * std::sin(angle), z);
    }
  mesh.vertices.emplace_back(0, 0, -kWide);
  mesh.vertices.emplace_back(0, 0, kWide);
  for (int k = 0; k < facets; ++k) {
    const int l = (k + 1) % facets;
    mesh.triangles.push_back({k, l, facets + l});
    mesh.triangles.push_back({k, facets + l, facets + k});
    mesh.triangles.push_back({l, k, 2 * facets});
    mesh.triangles.push_back({facets + k, facets + l, 2 * facets + 1});
  }
  part.visual = part.collision = std::make_shared<TriMesh>(mesh);
  return part;
}

TEST(FrictionScenes, aStrapRoundADrumHoldsToEulersFormula) {
  constexpr double mu = 0.3, slack = 2;  // N
  // Euler–Eytelwein; tension runs along the strap's middle, friction acts on the drum's face.
  const double tight = slack * std::exp(mu * M_PI * kRadius / (kRadius + kThick / 2));
  for (const double share : {0.95, 1.1}) {
    Scene scene(mu);
    scene.joint.materials[1].youngsModulus = 2e7;
    scene.joint.materials[1].poissonRatio = 0.3;
    scene.joint.parts = {drum(kFacets), softPart("strap", 2, strap(36), 2e-3)};
    scene.scenario.fixedParts = {"drum"};
    scene.scenario.gravity_W.setZero();
    scene.scenario.contactDistance = 5e-4;
    scene.scenario.loadRise = 0.2;
    const double x = kRadius + kThick / 2 + 1e-4, y = -kTail + 1e-4;
    scene.scenario.loads = {{"strap", Vec3(0, -slack, 0), Vec3::Zero(), Vec3(-x, y, 0)},
                            {"strap", Vec3(0, -share * tight, 0), Vec3::Zero(), Vec3(x, y, 0)}};
    const auto model = compileModel(scene.joint, scene.scenario).value();
    Stepper stepper(model, {});
    State state = model->start;
    const ObjectLayout& layout = model->objects[1].layout;
    const auto slackEnd = [&] { return state.q[layout.qOffset + 1]; };  // height of node 0
    const double from = slackEnd();
    Course run = runFor(stepper, state, 60);
    print("strap, loaded", run);
    const double before = slackEnd();
    run = runFor(stepper, state, 20);
    print("strap, after", run);
    std::printf("%.2f of Euler's force: the slack end rose %.1e m under the load, then %.1e m in a tenth of a second\n", share, before - from,
                slackEnd() - before);
    // By the state alone, whatever the solver says of itself: no node lies under the drum's flats.
    double nearest = 1;
    for (int i = 0; i < layout.nodeCount; ++i) {
      const Vec3 x = state.q.segment<3>(layout.qOffset + 3 * i);
      if (x.y() > 0) nearest = std::min(nearest, std::hypot(x.x(), x.y()));
    }
    EXPECT_GT(nearest, kRadius * std::cos(M_PI / kFacets) - 1e-6);
    EXPECT_GT(run.pressing, 20);
    EXPECT_LT(run.worst, 1e-5);
    if (share < 1) {
      EXPECT_EQ(run.unsettled, 0);
      EXPECT_LT(std::abs(slackEnd() - before), 1e-9);
    } else {
      EXPECT_GT(slackEnd() - before, 1e-3);
    }
  }
}

TEST(FrictionScenes, sheetsOnSheetsStandUnderALid) {
  Scene scene(0.5);
  scene.joint.materials[1].youngsModulus = 2e5;
  scene.joint.parts = {rigidBox("plate", 1, Vec3(-0.1, -0.02, -0.1), Vec3(0.1, 0, 0.1), 2)};
  double y = 2e-4;
  for (int i = 0; i < 4; ++i) {
    TetMesh mesh = scenes::boxVolume(Vec3(-0.03, y, -0.03), Vec3(0.03, y + 0.002, 0.03), 6, 1, 6);
    const Mat3 R = Eigen::AngleAxisd(0.1 * i, Vec3::UnitY()).toRotationMatrix();
    for (Vec3& x : mesh.nodes) x = R * x;
    scene.joint.parts.push_back(softPart("sheet" + std::to_string(i), i + 2, std::move(mesh), 1e-2));
    y += 0.0022;
  }
  scene.joint.parts.push_back(rigidBox("lid", 9, Vec3(-0.031, y, -0.029), Vec3(0.029, y + 0.02, 0.031), 3));
  scene.scenario.fixedParts = {"plate"};
  scene.scenario.contactDistance = 5e-4;
  scene.scenario.gravity_W = 9.81 * Vec3(std::sin(0.2), -std::cos(0.2), 0);
  const auto model = compileModel(scene.joint, scene.scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  Course run = runFor(stepper, state, 40);
  print("sheets, falling", run);
  EXPECT_LT(run.worst, 1e-3);
  runFor(stepper, state, 40);
  run = runFor(stepper, state, 20);
  print("sheets, later", run);
  EXPECT_GT(run.pressing, 200);
  EXPECT_EQ(run.unsettled, 0);
  EXPECT_LE(run.newtonMost, 3) << "what lies still is seen to";
  EXPECT_LT(state.v.cwiseAbs().maxCoeff(), 1e-6) << "the plate leans by 0.2 rad, friction holds to 0.46";
}

TEST(FrictionScenes, aBlockThatCollapsesUnderAWeight) {
  Scene scene(0.5);
  scene.joint.materials[1].youngsModulus = 5e3;
  scene.joint.parts = {rigidBox("plate", 1, Vec3(-0.1, -0.02, -0.1), Vec3(0.1, 0, 0.1), 2),
                       softPart("block", 2, scenes::boxVolume(Vec3(-0.02, 2e-4, -0.02), Vec3(0.02, 0.0402, 0.02), 6, 6, 6), 7e-3),
                       rigidBox("weight", 3, Vec3(-0.03, 0.0404, -0.03), Vec3(0.03, 0.0804, 0.03), 3)};
  scene.scenario.fixedParts = {"plate"};
  scene.scenario.gravity_W = 9.81 * Vec3(0, -1, 0);
  const auto model = compileModel(scene.joint, scene.scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  Course run = runFor(stepper, state, 200);
  print("collapse", run);
  const double sunk = 0.0604 - state.q[model->objects[2].layout.qOffset + 1];
  std::printf("the weight sank %.1f mm of 40\n", 1e3 * sunk);
  EXPECT_GT(sunk, 0.01);
  EXPECT_GT(run.pressing, 60);
  EXPECT_EQ(run.unsettled, 0);
}

Scene pileOf(int side, int layers) {
  Scene scene(0.5);
  scene.joint.parts = {rigidBox("plate", 1, Vec3(-0.5, -0.02, -0.5), Vec3(0.5, 0, 0.5), 2)};
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> shift(-1, 1);
  int number = 2;
  for (int l = 0; l < layers; ++l)
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const Vec3 low(0.022 * i + 0.01 * (l % 2) + 0.001 * shift(draw), 5e-4 + 0.0206 * l, 0.022 * j + 0.01 * (l % 2) + 0.001 * shift(draw));
        scene.joint.parts.push_back(rigidBox("box" + std::to_string(number), number, low, low + Vec3::Constant(0.02), 1));
        ++number;
      }
  scene.scenario.fixedParts = {"plate"};
  scene.scenario.gravity_W = 9.81 * Vec3(0.05, -1, 0);
  return scene;
}

// Loose boxes of twelve triangles are the hardest: hundreds of contacts for six unknowns each. Small piles settle; of large
// ones every step says that it did not, its Newton steps stay bounded and its time grows little faster than the rows.
TEST(FrictionScenes, aPileOfBoxesSettlesOrSaysThatItDidNotWithinABoundedTime) {
  std::vector<std::array<double, 2>> costs;
  for (const auto& [side, layers] : {std::pair{3, 2}, {4, 4}, {5, 6}}) {
    Scene scene = pileOf(side, layers);
    const auto model = compileModel(scene.joint, scene.scenario).value();
    Stepper stepper(model, {});
    State state = model->start;
    runFor(stepper, state, 20);
    Course run = runFor(stepper, state, 11);
    print(("pile of " + std::to_string(side * side * layers)).c_str(), run);
    costs.push_back({static_cast<double>(run.rows), medianOf(run.frictionMs)});
    EXPECT_EQ(run.unsaid, 0) << "an error that is not said";
    EXPECT_LE(run.newtonMost, 400);
    EXPECT_LT(state.v.cwiseAbs().maxCoeff(), 50) << "m/s and rad/s";
    if (side == 3) {
      EXPECT_EQ(run.unsettled, 0);
    }
  }
  const double exponent = std::log(costs[2][1] / costs[1][1]) / std::log(costs[2][0] / costs[1][0]);
  std::printf("time grows with rows to the power of %.2f\n", exponent);
  EXPECT_LT(exponent, 1.7);
}

}  // namespace
}  // namespace glenoid
