// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/RegionAnchors.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "simcore/embed/Bind.h"
#include "simcore/scene/JointFile.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/coupling/Integrals.h"

namespace glenoid {
namespace {

constexpr double kSide = 0.02;

/// A cube of 20 mm whose upper face is a region of `squares`² squares; soft: in cells of `cell` that need not fit it.
Part cube(PartKind kind, int squares, double cell, bool above = false) {
  Part part = scenes::boxPart(above ? "upper" : "lower", above ? 2 : 1, kind, Vec3(0, above ? kSide : 0, 0),
                              Vec3(kSide, above ? 2 * kSide : kSide, kSide));
  part.visual = std::make_shared<TriMesh>(scenes::boxSurface(Vec3(0, above ? kSide : 0, 0), Vec3(kSide, above ? 2 * kSide : kSide, kSide), squares));
  if (kind == PartKind::Soft) {
    const int n = static_cast<int>(std::ceil(kSide / cell - 1e-9));
    const Vec3 middle(kSide / 2, above ? 1.5 * kSide : kSide / 2, kSide / 2), half = Vec3::Constant(n * cell / 2);
    part.volume = std::make_shared<TetMesh>(scenes::boxVolume(middle - half, middle + half, n, n, n));
  }
  if (!above) part.regions = {scenes::regionIn(part, "face", Box3(Vec3(-1, kSide - 1e-6, -1), Vec3(1, kSide + 1e-6, 1)))};
  return part;
}

Joint bonded(Part lower, Part upper) {
  Joint joint;
  scenes::addMaterials(joint);
  joint.parts = {std::move(lower), std::move(upper)};
  joint.couplings = {{"bond", "lower", "upper", "face", 1e8, 1e-3, ""}};
  return joint;
}

std::vector<CoupledPart> partsOf(const Joint& joint) {
  std::vector<CoupledPart> parts;
  for (const Part& part : joint.parts) parts.push_back({&part, boundsOf(*part.visual).center()});
  return parts;
}

/// Where an end of a spring lies at rest, W.
Vec3 placeOf(const CoupledPart& part, const VertexBinding& end) {
  return part.part->kind == PartKind::Soft ? boundPosition(end, part.part->volume->nodes) : part.centre + end.r_B;
}

/// What the springs do when one part stays and the other moves as a rigid body: K = Σ k, the centre, and the second
/// moments about it, by the ends on `side`.
test::SurfaceIntegral ofSprings(const Joint& joint, int coupling, bool sideA) {
  const auto parts = partsOf(joint);
  const auto springs = deriveSprings(joint, coupling, parts);
  test::SurfaceIntegral sum;
  if (!springs) return sum;
  const auto end = [&](const CouplingSpring& spring) {
    return sideA ? placeOf(parts[spring.objectA], spring.a) : placeOf(parts[spring.objectB], spring.b);
  };
  for (const CouplingSpring& spring : *springs) {
    sum.area += spring.stiffness;
    sum.centre += spring.stiffness * end(spring);
  }
  sum.centre /= sum.area;
  for (const CouplingSpring& spring : *springs) {
    const Vec3 r = end(spring) - sum.centre;
    sum.second += spring.stiffness * r * r.transpose();
  }
  return sum;
}

struct Pairing {
  const char* name;
  PartKind lower, upper;
};

class BondOfASquare : public testing::TestWithParam<Pairing> {};

TEST_P(BondOfASquare, pullsTiltsAndTwistsAsItsAreaWhateverTheMesh) {
  // k a⁴/12 against tilt, k a⁴/6 against torsion, with its centre in the middle of the square.
  const double k = 1e8, tilt = k * std::pow(kSide, 4) / 12;
  for (const int squares : {1, 2, 4, 8, 16})  // 2, 8, 32, 128, 512 triangles
    for (const double cell : {0.020, 0.0133, 0.010, 0.007, 0.005, 0.003}) {
      const Joint joint = bonded(cube(GetParam().lower, squares, cell), cube(GetParam().upper, squares, 0.8 * cell, true));
      for (const bool sideA : {true, false}) {
        const test::SurfaceIntegral springs = ofSprings(joint, 0, sideA);
        // Round-off, and a point near a corner of a cell extrapolates from it by 1e-12 of weight at most.
        EXPECT_NEAR(springs.area, k * kSide * kSide, 1e-12 * k * kSide * kSide);
        EXPECT_LT((springs.centre - Vec3(kSide / 2, kSide, kSide / 2)).norm(), 1e-14) << squares << " " << cell;
        EXPECT_NEAR(turning(springs, Vec3::UnitX()), tilt, 1e-11 * tilt) << squares << " " << cell;
        EXPECT_NEAR(turning(springs, Vec3::UnitZ()), tilt, 1e-11 * tilt) << squares << " " << cell;
        EXPECT_NEAR(turning(springs, Vec3::UnitY()), 2 * tilt, 1e-11 * tilt) << squares << " " << cell;
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Parts, BondOfASquare,
                         testing::Values(Pairing{"rigidOnRigid", PartKind::Rigid, PartKind::Rigid},
                                         Pairing{"softOnRigid", PartKind::Soft, PartKind::Rigid},
                                         Pairing{"rigidOnSoft", PartKind::Rigid, PartKind::Soft},
                                         Pairing{"softOnSoft", PartKind::Soft, PartKind::Soft}),
                         [](const auto& pairing) { return pairing.param.name; });

TEST(RegionAnchors, crookedRegionsKeepTheirMoments) {
  // Scattered triangles of a bumpy cube: regions that are bent over edges, full of holes and in several pieces.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> bump(-4e-4, 4e-4);
  for (const PartKind kind : {PartKind::Rigid, PartKind::Soft}) {
    Part lower = cube(kind, 8, 0.0071), upper = cube(PartKind::Soft, 8, 0.004, true);
    TriMesh bumpy = *lower.visual;
    for (Vec3& v : bumpy.vertices) v += Vec3(bump(random), bump(random), bump(random));
    lower.visual = std::make_shared<TriMesh>(bumpy);
    for (int trial = 0; trial < 12; ++trial) {
      const int count = 1 << trial % 8;
      std::vector<int> triangles;
      for (int i = 0; i < count; ++i) triangles.push_back(static_cast<int>(random() % bumpy.triangles.size()));
      lower.regions[0].triangles = runsOf(triangles);
      const std::vector<int> taken = trianglesOf(lower.regions[0]);
      const Joint joint = bonded(lower, upper);
      const test::SurfaceIntegral exact = test::integrated(bumpy, taken);
      for (const bool sideA : {true, false}) {
        const test::SurfaceIntegral springs = ofSprings(joint, 0, sideA);
        // As of one surface, but the other part's points stand centimetres off its cells and extrapolate.
        EXPECT_NEAR(springs.area, 1e8 * exact.area, 1e-12 * 1e8 * exact.area);
        EXPECT_LT((springs.centre - exact.centre).norm(), 1e-12);
        EXPECT_LT((springs.second - 1e8 * exact.second).norm(), 1e-6 * 1e8 * exact.second.norm()) << count;
      }
    }
  }
}

TEST(RegionAnchors, theCellsOfTissueSayHowMany) {
  const auto count = [](const Part& part, const Part* other) {
    return regionAnchors({&part, Vec3::Zero()}, part.regions[0], other).size();
  };
  const Part upper = cube(PartKind::Soft, 1, 0.005, true), bone = cube(PartKind::Rigid, 16, 1, true);
  for (const int squares : {1, 16}) {
    const Part rigid = cube(PartKind::Rigid, squares, 1), coarse = cube(PartKind::Soft, squares, 0.02),
               fine = cube(PartKind::Soft, squares, 0.0025);
    EXPECT_EQ(count(rigid, &bone), 4u) << "a rigid body knows no more of a region than its moments";
    EXPECT_EQ(count(coarse, &bone), 4u) << "one cell: its 2 × 2 Gauss points";
    EXPECT_EQ(count(coarse, &upper), count(rigid, &upper));
    EXPECT_GE(count(rigid, &upper), 4u * 16) << "four to each cell's face of the finer part";
    EXPECT_GE(count(fine, &bone), 4u * 64);
    EXPECT_LE(count(fine, &bone), 4u * 256) << "in pieces that are no smaller than half a cell";
  }
}

TEST(RegionAnchors, everyNodeOfABondedFaceIsHeld) {
  // Fewer points than that would leave tissue that flaps between them: the springs' matrix, restricted to the nodes of
  // the face, must be regular.
  for (const double cell : {0.01, 0.005, 0.0025}) {
    const Part part = cube(PartKind::Soft, 3, cell);
    const auto anchors = regionAnchors({&part, Vec3::Zero()}, part.regions[0]);
    MatX matrix = MatX::Zero(static_cast<Eigen::Index>(part.volume->nodes.size()), static_cast<Eigen::Index>(part.volume->nodes.size()));
    for (const RegionAnchor& anchor : anchors)
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          matrix(anchor.binding.node[i], anchor.binding.node[j]) += anchor.share * anchor.binding.weight[i] * anchor.binding.weight[j];
    std::vector<int> face;
    for (std::size_t n = 0; n < part.volume->nodes.size(); ++n)
      if (std::abs(part.volume->nodes[n].y() - kSide) < 1e-9) face.push_back(static_cast<int>(n));
    MatX onFace(face.size(), face.size());
    for (std::size_t i = 0; i < face.size(); ++i)
      for (std::size_t j = 0; j < face.size(); ++j) onFace(i, j) = matrix(face[i], face[j]);
    // Of linear triangles the mass matrix has eigenvalues of area/12 … area/3 or so by node; a third of that at worst.
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatX>(onFace).eigenvalues()(0), cell * cell / 72) << cell;
  }
}

TEST(RegionAnchors, goAlongWithThePartAndItsAxes) {
  // Three faces around a corner, of which no two triangles lie alike: what is bent shows on which side the points lie.
  Part part = cube(PartKind::Soft, 3, 0.007);
  part.regions = {scenes::regionIn(part, "bent", Box3(Vec3(-1, -1, -1), Vec3(1, 1, 1)))};
  part.regions[0].triangles = runsOf({0, 3, 7, 20, 41, 42, 60, 77, 78});
  const auto placed = [&](const Mat3& R) {
    Part other = part;
    TriMesh surface = *part.visual;
    for (Vec3& x : surface.vertices) x = R * x;
    other.visual = std::make_shared<const TriMesh>(surface);
    TetMesh volume = *part.volume;
    for (Vec3& x : volume.nodes) x = R * x;
    if (R.determinant() < 0)
      for (auto& tet : volume.tets) std::swap(tet[2], tet[3]);
    other.volume = std::make_shared<const TetMesh>(volume);
    return other;
  };
  const auto anchorsOf = [](const Part& of, const Mat3& axes_W) { return regionAnchors({&of, Vec3::Zero()}, of.regions[0], nullptr, axes_W); };
  const auto here = anchorsOf(part, Mat3::Identity());
  ASSERT_GE(here.size(), 8u);
  const auto farthest = [&](const std::vector<RegionAnchor>& there, const Mat3& R) {
    EXPECT_EQ(there.size(), here.size());
    double most = 0;
    for (std::size_t i = 0; i < std::min(here.size(), there.size()); ++i) {
      most = std::max(most, (R * here[i].rest_W - there[i].rest_W).norm());
    }
    return most;
  };
  const Mat3 mirror = Vec3(1, 1, -1).asDiagonal(), turn = Eigen::AngleAxisd(0.35, Vec3(2, -1, 3).normalized()).toRotationMatrix();
  for (const Mat3& R : {mirror, turn, Mat3(turn * mirror)}) {
    const auto there = anchorsOf(placed(R), R.transpose());
    EXPECT_LT(farthest(there, R), 1e-9);
    for (std::size_t i = 0; i < std::min(here.size(), there.size()); ++i) EXPECT_NEAR(there[i].share, here[i].share, 1e-12 * here[i].share);
  }
  EXPECT_GT(farthest(anchorsOf(placed(mirror), Mat3::Identity()), mirror), 1e-4) << "along W they are others";
}

TEST(RegionAnchors, oneTriangleHolds) {
  Part lower = cube(PartKind::Soft, 16, 0.005);
  lower.regions[0].triangles = {{trianglesOf(lower.regions[0])[0], 1}};
  const auto springs = deriveSprings(bonded(lower, cube(PartKind::Rigid, 1, 1, true)), 0, partsOf(bonded(lower, cube(PartKind::Rigid, 1, 1, true))));
  ASSERT_TRUE(springs.ok());
  EXPECT_EQ(springs->size(), 4u);
}

TEST(RegionAnchors, onlyALineCannotHold) {
  const auto strip = [](double length, double width) {
    const Triangle a{Vec3(0, 0, 0), Vec3(length, length, 0), Vec3(length, length, width)};
    return momentsOf({{a}});
  };
  EXPECT_TRUE(canHold(strip(0.05, 0.05)));
  EXPECT_TRUE(canHold(strip(0.05, 5e-4))) << "a hundred times as long as wide is thin, and holds";
  EXPECT_FALSE(canHold(strip(0.05, 5e-6)));
  EXPECT_FALSE(canHold(AreaMoments{}));
}

TEST(RegionAnchors, shippedCouplingsTurnAsTheirRegions) {
  for (const char* name : {"shoulder", "shoulder-superficial", "shoulder-capsule"}) {
    const auto joint = loadJoint(std::string(GLENOID_SOURCE_DIR "/resources/joints/") + name + ".joint");
    ASSERT_TRUE(joint.ok());
    std::size_t springs = 0;
    for (std::size_t c = 0; c < joint->couplings.size(); ++c) {
      const Coupling& coupling = joint->couplings[c];
      const Part& part = joint->parts[findPart(*joint, coupling.partA)];
      const Region& region = *findRegion(part, coupling.regionA);
      const TriMesh& mesh = region.surface == SurfaceKind::Visual ? *part.visual : *part.collision;
      const test::SurfaceIntegral exact = test::integrated(mesh, trianglesOf(region));
      for (const bool sideA : {true, false}) {
        const test::SurfaceIntegral found = ofSprings(*joint, static_cast<int>(c), sideA);
        EXPECT_NEAR(found.area / (coupling.stiffnessPerArea * exact.area), 1, 1e-9) << coupling.id;
        EXPECT_LT((found.centre - exact.centre).norm(), 1e-9) << coupling.id;
        // The goal is 3 %. What is left is round-off, of points that extrapolate.
        EXPECT_LT((found.second / coupling.stiffnessPerArea - exact.second).norm(), 1e-6 * exact.second.norm()) << coupling.id;
      }
      springs += deriveSprings(*joint, static_cast<int>(c), partsOf(*joint))->size();
    }
    RecordProperty(name, static_cast<int>(springs));
    EXPECT_LT(springs, 1500u) << name << ": so many that a step feels them";
  }
}

}  // namespace
}  // namespace glenoid
