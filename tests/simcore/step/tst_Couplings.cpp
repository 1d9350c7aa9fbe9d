// SPDX-License-Identifier: GPL-3.0-or-later
// Bonds that are pulled and turned in a run, against k ∫ dA and k ∫ r² dA.
#include <gtest/gtest.h>

#include <cmath>

#include "simcore/body/RigidObject.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/step/Measures.h"

namespace glenoid {
namespace {

constexpr double kSide = 0.02, kPerArea = 1e6;
constexpr double kTilt = kPerArea * kSide * kSide * kSide * kSide / 12;  // N m/rad: 0.01333

Part block(const std::string& id, int number, PartKind kind, double top, int squares, double cell) {
  const Vec3 low(-kSide / 2, top - kSide, -kSide / 2), high(kSide / 2, top, kSide / 2);
  Part part = scenes::boxPart(id, number, kind, low, high);
  part.visual = std::make_shared<TriMesh>(scenes::boxSurface(low, high, squares));
  if (kind == PartKind::Soft) {
    // A lattice of whole cells about the middle, as the author's: it stands over where the cell does not fit.
    const int n = static_cast<int>(std::ceil(kSide / cell - 1e-9));
    const Vec3 middle = (low + high) / 2, half = Vec3::Constant(n * cell / 2);
    part.volume = std::make_shared<TetMesh>(scenes::boxVolume(middle - half, middle + half, n, n, n));
    part.cellSize = cell;
    part.materials = {{"stiff", ""}};
  }
  part.regions.push_back(scenes::regionIn(part, "top", Box3(Vec3(-1, top - 1e-6, -1), Vec3(1, top + 1e-6, 1))));
  part.regions.push_back(scenes::regionIn(part, "bottom", Box3(Vec3(-1, top - kSide - 1e-6, -1), Vec3(1, top - kSide + 1e-6, 1))));
  return part;
}

struct Hanging {
  Joint joint;
  Scenario scenario;
};

/// A fixed wall, a middle block bonded below it with kPerArea, and a rigid one glued below that.
Hanging hanging(PartKind middle, PartKind wall, int squares, double cell) {
  Hanging made;
  Joint& joint = made.joint;
  joint.id = joint.name = "hanging";
  scenes::addMaterials(joint);
  Material stiff = joint.materials[1];
  stiff.id = stiff.name = "stiff";
  stiff.youngsModulus = 1e10;
  stiff.poissonRatio = 0.3;
  joint.materials.push_back(stiff);
  joint.parts = {block("wall", 1, wall, 0.03, squares, cell), block("middle", 2, middle, 0.01, squares, cell),
                 block("low", 3, PartKind::Rigid, -0.01, squares, cell)};
  joint.couplings = {{"bond", "middle", "wall", "top", kPerArea, 0.02, ""}, {"glue", "middle", "low", "bottom", 1e12, 1e-3, ""}};
  for (const auto& [a, b] : {std::pair("wall", "middle"), std::pair("middle", "low"), std::pair("wall", "low")})
    joint.exclusions.push_back({a, b, "glued"});
  made.scenario.id = made.scenario.name = "hanging";
  made.scenario.dt = 0.01;
  made.scenario.fixedParts = {"wall"};
  made.scenario.effects.gravity = Wish::Off;
  return made;
}

/// Pose of the lowest block after three seconds, from where it was, with its own rest as the frame. The bond damps with
/// 20 ms: what swings at 30 1/s has decayed by e⁻²⁰ and more.
Pose movedAfter(const Hanging& scene) {
  const auto model = compileModel(scene.joint, scene.scenario);
  EXPECT_TRUE(model.ok()) << toLogLine(model.error());
  State state = (*model)->start;
  Stepper stepper(*model, {});
  for (int i = 0; i < 300; ++i) EXPECT_TRUE(stepper.step({}, state).taken);
  const int q = (*model)->objects[2].layout.qOffset;
  const Pose start = poseAt((*model)->start.q, q), end = poseAt(state.q, q);
  return {end.p_WB - start.p_WB, end.q_WB * start.q_WB.conjugate()};
}

double angleOf(const Pose& pose) { return Eigen::AngleAxisd(pose.q_WB).angle(); }

struct Way {
  const char* name;
  PartKind wall, middle;
  int squares;
  double cell;
};

class ABondedBlock : public testing::TestWithParam<Way> {};

TEST_P(ABondedBlock, tiltsByItsMomentOverTheSecondMomentOfTheArea) {
  const Way& way = GetParam();
  Hanging scene = hanging(way.middle, way.wall, way.squares, way.cell);
  const double moment = 1e-4;  // N m
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.6, 0, 0.8)}) {
    scene.scenario.loads = {{"low", Vec3::Zero(), moment * axis}};
    const Pose moved = movedAfter(scene);
    // A square tilts alike about every line in it; about its normal twice as stiffly. Springs of no length give
    // M = K sin θ. What is left: the tissue's own give, E/h = 5e11 N/m³ beside 1e6, and the glue's.
    const double stiffness = axis.y() == 1 ? 2 * kTilt : kTilt;
    EXPECT_NEAR(angleOf(moved), std::asin(moment / stiffness), 1e-4 * moment / stiffness) << axis.transpose();
    // About the middle of the bond: the block's own middle hangs 30 mm below it.
    const Vec3 arm(0, -0.03, 0);
    EXPECT_LT((moved.p_WB - (moved.q_WB * arm - arm)).norm(), 1e-4 * 0.03 * moment / stiffness) << axis.transpose();
  }
}

TEST_P(ABondedBlock, dropsStraightByItsWeightOverTheArea) {
  const Way& way = GetParam();
  Hanging scene = hanging(way.middle, way.wall, way.squares, way.cell);
  const Vec3 pull(3e-3, -0.2, -2e-3);  // N, through the middle of the bond
  scene.scenario.loads = {{"low", pull, Vec3(0, 0.01, 0).cross(pull)}};
  const Pose moved = movedAfter(scene);
  EXPECT_LT((moved.p_WB - pull / (kPerArea * kSide * kSide)).norm(), 1e-4 * pull.norm() / (kPerArea * kSide * kSide));
  EXPECT_LT(angleOf(moved), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(
    Ways, ABondedBlock,
    testing::Values(Way{"softOfCells20", PartKind::Rigid, PartKind::Soft, 8, 0.020},
                    Way{"softOfCells13", PartKind::Rigid, PartKind::Soft, 8, 0.0133},
                    Way{"softOfCells10", PartKind::Rigid, PartKind::Soft, 8, 0.010},
                    Way{"softOfCells7", PartKind::Rigid, PartKind::Soft, 8, 0.007},
                    Way{"softOfCells5", PartKind::Rigid, PartKind::Soft, 8, 0.005},
                    Way{"softOfTwoTriangles", PartKind::Rigid, PartKind::Soft, 1, 0.007},
                    Way{"softOfThousandTriangles", PartKind::Rigid, PartKind::Soft, 23, 0.007},
                    Way{"rigidOfTwoTriangles", PartKind::Rigid, PartKind::Rigid, 1, 1},
                    Way{"rigidOf8Triangles", PartKind::Rigid, PartKind::Rigid, 2, 1},
                    Way{"rigidOf32Triangles", PartKind::Rigid, PartKind::Rigid, 4, 1},
                    Way{"rigidOf512Triangles", PartKind::Rigid, PartKind::Rigid, 16, 1},
                    Way{"softOnSoft", PartKind::Soft, PartKind::Soft, 4, 0.010}),
    [](const auto& way) { return way.param.name; });

}  // namespace
}  // namespace glenoid
