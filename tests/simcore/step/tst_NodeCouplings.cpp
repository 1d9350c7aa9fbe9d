// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that hang on springs at picked nodes, against k Σ (u + θ × r) solved apart and against bonds over a region.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "simcore/embed/Bind.h"
#include "simcore/embed/Cells.h"
#include "simcore/scene/CouplingHold.h"
#include "simcore/step/Stepper.h"
#include "tests/scenes/NodeScenes.h"
#include "tests/simcore/mesh/Shapes.h"
#include "tests/simcore/step/Measures.h"

namespace glenoid {
namespace {

constexpr double kSide = 0.02, kStiffness = 100;  // m, N/m of each spring

struct Hung {
  Joint joint;
  Scenario scenario;
};

/// A cube of 20 mm below a fixed plate, so stiff (1 GPa) that the springs alone give; without weight and contact.
Hung stiffBlock(const std::function<bool(const Vec3&)>& picked) {
  Hung hung;
  hung.joint.id = hung.joint.name = hung.scenario.id = hung.scenario.name = "hung";
  scenes::addMaterials(hung.joint);
  Material stiff = hung.joint.materials[1];
  stiff.id = stiff.name = "stiff";
  stiff.youngsModulus = 1e9;
  hung.joint.materials.push_back(stiff);
  hung.joint.parts.push_back(scenes::boxPart("plate", 1, PartKind::Rigid, Vec3(-0.03, 0, -0.03), Vec3(0.03, 0.01, 0.03)));
  Part block = scenes::boxPart("block", 2, PartKind::Soft, Vec3(-kSide / 2, -kSide, -kSide / 2), Vec3(kSide / 2, 0, kSide / 2));
  block.materials = {{"stiff", ""}};
  hung.joint.parts.push_back(block);
  hung.joint.couplings = {scenes::atNodes("hang", "block", "plate", scenes::nodesWhere(block, picked), kStiffness)};
  hung.scenario.fixedParts = {"plate"};
  hung.scenario.effects.gravity = hung.scenario.effects.contact = Wish::Off;
  return hung;
}

/// At rest under its loads.
State settled(const std::shared_ptr<const Model>& model, int steps = 800) {
  Stepper stepper(model, {});
  State state = model->start;
  for (int i = 0; i < steps; ++i)
    if (!stepper.step({}, state).taken) ADD_FAILURE() << "step " << i;
  return state;
}

std::vector<Vec3> nodesOf(const Model& model, const State& state, int object) {
  std::vector<Vec3> nodes;
  const ObjectLayout& layout = model.objects[object].layout;
  for (int i = 0; i < layout.nodeCount; ++i) nodes.push_back(state.q.segment<3>(layout.qOffset + 3 * i));
  return nodes;
}

/// Displacement u of the origin and rotation θ of a rigid body on springs at r_i, under a force at p: small motions.
Vec6 rigidAnswer(const std::vector<Vec3>& places, const Vec3& force, const Vec3& at) {
  const auto cross = [](const Vec3& r) {
    Mat3 m;
    m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return m;
  };
  Eigen::Matrix<double, 6, 6> K = Eigen::Matrix<double, 6, 6>::Zero();
  for (const Vec3& r : places) {
    Eigen::Matrix<double, 3, 6> J;
    J << Mat3::Identity(), -cross(r);
    K += kStiffness * J.transpose() * J;
  }
  Vec6 load;
  load << force, at.cross(force);
  return K.fullPivLu().solve(load);
}

TEST(NodeCouplings, nEqualSpringsGiveLoadOverNTimesK) {
  const Vec3 force(0, -0.05, 0);
  using Pick = std::pair<std::function<bool(const Vec3&)>, int>;
  for (const auto& [picked, n] : {Pick{[](const Vec3& p) { return p.y() > -1e-9; }, 9},
                                  Pick{[](const Vec3& p) { return p.y() > -1e-9 && std::abs(p.x()) > 5e-3 && std::abs(p.z()) > 5e-3; }, 4},
                                  Pick{[](const Vec3&) { return true; }, 27}}) {
    Hung hung = stiffBlock(picked);
    ASSERT_EQ(static_cast<int>(hung.joint.couplings[0].nodesA.size()), n);
    hung.scenario.loads = {{"block", force, Vec3::Zero(), Vec3(0, -kSide / 2, 0)}};
    const auto model = compileModel(hung.joint, hung.scenario).value();
    const State state = settled(model);
    const std::vector<Vec3> now = nodesOf(*model, state, 1);
    double mean = 0;
    for (const int node : hung.joint.couplings[0].nodesA) mean += (now[node] - model->objects[1].volume->nodes[node]).y() / n;
    EXPECT_NEAR(mean, force.y() / (n * kStiffness), 1e-4 * 0.05 / (n * kStiffness)) << n << " springs";
  }
}

TEST(NodeCouplings, anUnevenPickTurnsAsItsSpringsSay) {
  // Five nodes to one side, pulled at a corner; small, so that arms do not change.
  const Vec3 force(3e-4, -1e-3, 2e-4), at(0.006, -0.018, -0.004);
  for (const Elements elements : {Elements::Tetrahedra, Elements::Cells}) {
    Hung hung = stiffBlock([](const Vec3& p) { return (p.y() > -1e-9 && p.x() < 1e-9 && p.z() < 1e-9) || (p - Vec3(0.01, -0.01, 0.01)).norm() < 1e-9; });
    ASSERT_EQ(hung.joint.couplings[0].nodesA.size(), 5u);
    hung.scenario.loads = {{"block", force, Vec3::Zero(), at}};
    hung.scenario.elements = elements;
    const auto model = compileModel(hung.joint, hung.scenario).value();
    const std::vector<Vec3> now = nodesOf(*model, settled(model), 1), &rest = model->objects[1].volume->nodes;
    const Vec6 expected = rigidAnswer(holdPlaces(hung.joint.parts[1], hung.joint.couplings[0]), force, at);
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Vec3 u = expected.head<3>() + Vec3(expected.tail<3>()).cross(rest[i]);
      largest = std::max(largest, u.norm());
      worst = std::max(worst, (now[i] - rest[i] - u).norm());
    }
    EXPECT_GT(largest, 1e-6);
    EXPECT_LT(worst, 2e-3 * largest) << "turns of a milliradian";
  }
}

TEST(NodeCouplings, ofTwoSoftPartsTheSpringsGiveAndNothingIsPushedFromOutside) {
  // The upper part soft too, reaching 3 mm into the lower one, so that no two nodes meet.
  Hung hung = stiffBlock([](const Vec3& p) { return p.y() > -1e-9; });
  Part upper = scenes::boxPart("plate", 1, PartKind::Soft, Vec3(-0.03, -0.003, -0.029), Vec3(0.03, 0.02, 0.031), 3);
  upper.materials = {{"stiff", ""}};
  hung.joint.parts[0] = upper;
  hung.scenario.loads = {{"block", Vec3(0, -0.05, 0), Vec3::Zero(), Vec3(0, -kSide / 2, 0)}};
  const auto model = compileModel(hung.joint, hung.scenario).value();
  const std::vector<Vec3> now = nodesOf(*model, settled(model), 1);
  double mean = 0;
  for (const int node : hung.joint.couplings[0].nodesA) mean += (now[node] - model->objects[1].volume->nodes[node]).y() / 9;
  EXPECT_NEAR(mean, -0.05 / (9 * kStiffness), 1e-3 * 0.05 / (9 * kStiffness));

  // Both free and of tissue, whose own forces leave less round-off, the lower one set in motion: what the springs take from the one they give
  // to the other.
  for (Part& part : hung.joint.parts) part.materials = {{"tissue", ""}};
  hung.scenario.fixedParts.clear();
  hung.scenario.loads.clear();
  const auto free = compileModel(hung.joint, hung.scenario).value();
  State state = free->start;
  test::setInMotion(*free, 1, Vec3(0.02, -0.05, 0.01), Vec3::Zero(), state);
  const Vec6 before = test::momentumOf(*free, state);
  Stepper stepper(free, {});
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(stepper.step({}, state).taken);
  EXPECT_LT((test::momentumOf(*free, state) - before).head<3>().norm(), 1e-11 * before.head<3>().norm());
  EXPECT_LT((test::velocitiesOf(*free, 1, state).segment<3>(0) - test::velocitiesOf(*free, 0, state).segment<3>(0)).norm(), 0.02) << "they move on as one";
}

/// Mean displacement of the free end of Figure 4's soft part, held at the left end alone.
Vec3 endMoves(Joint joint, const Vec3& gravity, double total) {
  for (Coupling& coupling : joint.couplings)
    if (coupling.byNodes()) coupling.stiffnessPerNode = total / static_cast<double>(coupling.nodesA.size());
    else coupling.stiffnessPerArea = total / 4e-4;
  joint.couplings.pop_back();
  joint.parts.pop_back();
  Part& middle = joint.parts[1];
  middle.volume = std::make_shared<TetMesh>(scenes::boxVolume(Vec3(-0.02, 0, 0), Vec3(0.02, 0.02, 0.02), 8, 4, 4));
  middle.cellSize = 0.005;
  if (joint.couplings[0].byNodes()) {
    joint.couplings[0].nodesA = scenes::nodesWhere(middle, [](const Vec3& p) { return p.x() < -0.0199; });
    joint.couplings[0].stiffnessPerNode = total / static_cast<double>(joint.couplings[0].nodesA.size());
  }
  Scenario scenario = scenes::figure4Scenario();
  scenario.effects.contact = Wish::Off;
  scenario.gravity_W = gravity;
  const auto model = compileModel(joint, scenario).value();
  const std::vector<Vec3> now = nodesOf(*model, settled(model, 600), 1);
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (middle.volume->nodes[i].x() > 0.0199) sum += now[i] - middle.volume->nodes[i], ++count;
  return sum / count;
}

TEST(NodeCouplings, holdAsARegionOfTheSameStiffnessDoes) {
  const Joint region = scenes::figure4Joint(), nodes = scenes::figure4AtNodes();
  // Firm: 40 kN/m in all on a block that gives 500 N/m; what is left between the two is how they hold the face.
  const Vec3 pulled = endMoves(region, Vec3(9.81, 0, 0), 4e4), pulledAtNodes = endMoves(nodes, Vec3(9.81, 0, 0), 4e4);
  const double own = 1000 * 9.81 * 0.04 * 0.04 / (2 * 5e4), weight = 0.016 * 9.81;  // ρ g L² / 2E, m; N
  EXPECT_NEAR(pulled.x(), own + weight / 4e4, 0.1 * own) << "a little less: the held end cannot narrow";
  EXPECT_LT((pulledAtNodes - pulled).norm(), 0.01 * pulled.norm());
  const Vec3 bent = endMoves(region, Vec3(0, -9.81, 0), 4e4), bentAtNodes = endMoves(nodes, Vec3(0, -9.81, 0), 4e4);
  EXPECT_LT((bentAtNodes - bent).norm(), 0.05 * bent.norm()) << "nodes hold the rim as firmly as the middle";
  // Soft: as soft as the block, pulled.
  const Vec3 soft = endMoves(region, Vec3(9.81, 0, 0), 500), softAtNodes = endMoves(nodes, Vec3(9.81, 0, 0), 500);
  EXPECT_NEAR(soft.x(), own + weight / 500, 0.01 * soft.x());
  EXPECT_NEAR(softAtNodes.x(), own + weight / 500, 0.03 * soft.x());
  EXPECT_LT((softAtNodes - soft).norm(), 0.03 * soft.norm());
}

TEST(NodeCouplings, keepTheirPlacesWhereAPartRunsAsWholeCells) {
  // Cut cells of a ball: whole ones have more nodes, in another order, and lack what only slivers had.
  Hung hung = stiffBlock([](const Vec3&) { return false; });
  Part ball = hung.joint.parts[1];
  ball.visual = ball.collision = std::make_shared<const TriMesh>(shapes::moved(shapes::sphere(0.0205), Pose{Vec3(0, -0.02, 0), Quat::Identity()}));
  ball.cellSize = 0.008;
  ball.volume = std::make_shared<const TetMesh>(embedInCells(*ball.visual, *ball.collision, ball.cellSize).value());
  hung.joint.parts[1] = ball;
  hung.joint.couplings = {scenes::atNodes("hang", "block", "plate", scenes::nodesWhere(ball, [](const Vec3&) { return true; }), kStiffness)};
  hung.scenario.elements = Elements::Cells;
  const auto model = compileModel(hung.joint, hung.scenario).value();
  const TetMesh& whole = *model->objects[1].volume;
  EXPECT_NE(whole, *ball.volume);
  ASSERT_EQ(model->springs.size(), ball.volume->nodes.size());
  for (std::size_t i = 0; i < model->springs.size(); ++i)
    EXPECT_LT((boundPosition(model->springs[i].a, whole.nodes) - ball.volume->nodes[i]).norm(), 1e-12) << i;
  hung.scenario.loads = {{"block", Vec3(0, -0.05, 0), Vec3::Zero(), Vec3(0, -0.02, 0)}};
  hung.scenario.elements = Elements::Cells;
  const auto loaded = compileModel(hung.joint, hung.scenario).value();
  const State state = settled(loaded);
  const std::vector<Vec3> now = nodesOf(*loaded, state, 1);
  double mean = 0;
  for (const SpringView& spring : loaded->springs) mean += (boundPosition(spring.a, now) - boundPosition(spring.a, whole.nodes)).y() / static_cast<double>(loaded->springs.size());
  EXPECT_NEAR(mean, -0.05 / (kStiffness * static_cast<double>(loaded->springs.size())), 1e-3 * std::abs(mean));
}

TEST(NodeCouplings, whereTheyHoldSurfacesAreNotTestedAgainstEachOther) {
  const Joint joint = scenes::figure4AtNodes();
  const auto model = compileModel(joint, scenes::figure4Scenario()).value();
  const CollisionPair* pair = nullptr;
  for (const CollisionPair& each : model->collisionPairs)
    if (each.surfaceA == 0 && each.surfaceB == 1) pair = &each;
  ASSERT_NE(pair, nullptr);
  const TriMesh& middle = *joint.parts[1].collision;
  ASSERT_EQ(pair->skipTriangleB.size(), middle.triangles.size());
  for (std::size_t t = 0; t < middle.triangles.size(); ++t) {
    double least = 1, most = -1;
    for (const int v : middle.triangles[t]) least = std::min(least, middle.vertices[v].x()), most = std::max(most, middle.vertices[v].x());
    if (most < -0.0199) { EXPECT_TRUE(pair->skipTriangleB[t]) << "the held face"; }
    if (least > 0.0199) { EXPECT_FALSE(pair->skipTriangleB[t]) << "the far end"; }
  }
}

TEST(NodeCouplings, runInEveryProfileAlike) {
  Joint joint = scenes::figure4AtNodes();
  for (Coupling& coupling : joint.couplings) coupling.stiffnessPerNode = 50;  // soft enough for the paper's splitting
  Scenario scenario = scenes::figure4Scenario();
  scenario.effects.contact = Wish::Off;
  scenario.gravity_W = Vec3(0, -0.1, 0);  // little: the published step has neither tension nor a law for large stretches
  scenario.elements = Elements::Tetrahedra;
  const auto model = compileModel(joint, scenario).value();
  std::vector<State> states;
  for (const Profile profile : {Profile::Direct, Profile::Reference, Profile::Paper}) {
    State state = model->start;
    Stepper stepper(model, {profile});
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(stepper.step({}, state).taken);
    states.push_back(state);
  }
  const double moved = (states[0].q - model->start.q).norm();
  EXPECT_LT((states[1].q - states[0].q).norm(), 1e-9 * moved);
  EXPECT_LT((states[2].q - states[0].q).norm(), 1e-3 * moved) << "conjugate gradients to their tolerance";
}

}  // namespace
}  // namespace glenoid
