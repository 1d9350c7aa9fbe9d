// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Tissue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/editor/render/TestScene.h"

namespace glenoid::test {
namespace {

/// A long ball along X whose triangles with x > 30 mm are tendon.
struct Muscle {
  TriMesh mesh = sphereMesh(Vec3::Zero(), 1, 24);
  Part part;
  Muscle() {
    for (Vec3& x : mesh.vertices) x = Vec3(0.05 * x.x(), 0.02 * x.y(), 0.008 * x.z());
    Region region{"tendon", "Tendon", "tendon", SurfaceKind::Visual, {}};
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      double x = 0;
      for (const int v : mesh.triangles[t]) x += mesh.vertices[v].x() / 3;
      if (x > 0.03) region.triangles.push_back({t, 1});
    }
    part.kind = PartKind::Soft;
    part.regions.push_back(region);
  }
};

TEST(Tissue, tendonIsWhereItsRegionIs) {
  const Muscle muscle;
  const Tissue tissue = tissueOf(muscle.mesh, &muscle.part, Appearance::Muscle);
  ASSERT_EQ(tissue.vertices.size(), muscle.mesh.vertices.size());
  for (std::size_t v = 0; v < tissue.vertices.size(); ++v) {
    const double x = muscle.mesh.vertices[v].x();
    // Rows of triangles are up to 7 mm apart; the border is spread over 11 mm to either side.
    EXPECT_TRUE(x < 0.046 || tissue.vertices[v].tendon > 0.8) << x;
    EXPECT_TRUE(x > 0.01 || tissue.vertices[v].tendon == 0) << x;
    EXPECT_EQ(tissue.vertices[v].cartilage, 0);
  }
}

TEST(Tissue, fibresRunTowardsTheTendon) {
  const Muscle muscle;
  const Tissue tissue = tissueOf(muscle.mesh, &muscle.part, Appearance::Muscle);
  ASSERT_EQ(tissue.grain, Grain::Muscle);
  for (std::size_t v = 0; v < tissue.vertices.size(); ++v) {
    const Vec3& x = muscle.mesh.vertices[v];
    const TissueVertex& t = tissue.vertices[v];
    EXPECT_NEAR(std::abs(t.through), std::abs(x.z()), 2e-4);  // thin direction Z, to the mesh's asymmetry
    EXPECT_TRUE(std::abs(x.y()) < 0.005 || std::abs(t.across) > 0.5 * std::abs(x.y()));
  }
  const auto along = [&](double sign) {
    double best = -1e9, at = 0;
    for (std::size_t v = 0; v < tissue.vertices.size(); ++v)
      if (sign * muscle.mesh.vertices[v].x() > best)
        best = sign * muscle.mesh.vertices[v].x(), at = tissue.vertices[v].along;
    return at;
  };
  EXPECT_NEAR(along(-1) - along(1), 0.1, 1e-3);  // from the tendon's end to the belly's
}

TEST(Tissue, withoutATendonFibresRunToTheSmallerFootprint) {
  Muscle muscle;
  Region tendon = muscle.part.regions[0], origin{"origin", "Origin", "footprint", SurfaceKind::Visual, {}};
  for (int t = 0; t < static_cast<int>(muscle.mesh.triangles.size()); ++t)
    if (muscle.mesh.vertices[muscle.mesh.triangles[t][0]].x() < -0.01) origin.triangles.push_back({t, 1});
  tendon.kind = "footprint";
  ASSERT_LT(tendon.triangles.size(), origin.triangles.size());
  muscle.part.regions = {tendon, origin};
  const Tissue tissue = tissueOf(muscle.mesh, &muscle.part, Appearance::Muscle);
  ASSERT_EQ(tissue.grain, Grain::Muscle);
  for (std::size_t v = 0; v < tissue.vertices.size(); ++v)
    for (std::size_t w = 0; w < v; ++w)
      if (muscle.mesh.vertices[v].x() > muscle.mesh.vertices[w].x() + 1e-3) {
        EXPECT_LT(tissue.vertices[v].along, tissue.vertices[w].along) << "the fan's point lies beyond the insertion";
        break;
      }
}

TEST(Tissue, theBorderOfATendonIsHalfAndFeathersAway) {
  const Muscle muscle;
  const Tissue tissue = tissueOf(muscle.mesh, &muscle.part, Appearance::Muscle);
  double least = 1, most = 0;
  for (std::size_t v = 0; v < tissue.vertices.size(); ++v)
    if (std::abs(muscle.mesh.vertices[v].x() - 0.03) < 0.004) {
      least = std::min<double>(least, tissue.vertices[v].tendon);
      most = std::max<double>(most, tissue.vertices[v].tendon);
    }
  EXPECT_GT(least, 0.2);
  EXPECT_LT(most, 0.8);
}

TEST(Tissue, fibresFollowAMuscleThatBends) {
  constexpr double kRadius = 0.06;  // round a joint by 57 degrees to either side
  Muscle muscle;
  const TriMesh straight = muscle.mesh;
  for (Vec3& x : muscle.mesh.vertices) {
    const double angle = x.x() / 0.05, out = kRadius + x.z();
    x = Vec3(out * std::sin(angle), x.y(), out * std::cos(angle));
  }
  Region insertion = muscle.part.regions[0], origin{"origin", "Origin", "footprint", SurfaceKind::Visual, {}};
  for (int t = 0; t < static_cast<int>(straight.triangles.size()); ++t)
    if (straight.vertices[straight.triangles[t][0]].x() < -0.025) origin.triangles.push_back({t, 1});
  insertion.kind = "footprint";
  muscle.part.regions = {insertion, origin};
  const Tissue tissue = tissueOf(muscle.mesh, &muscle.part, Appearance::Muscle);
  ASSERT_EQ(tissue.grain, Grain::Muscle);
  double lift = 0;  // of the chord's plane the middle stands 28 mm off
  for (std::size_t v = 0; v < tissue.vertices.size(); ++v) lift = std::max<double>(lift, std::abs(tissue.vertices[v].through));
  EXPECT_LT(lift, 0.016) << "half the muscle is 8 mm thick";
  for (std::size_t v = 0; v < tissue.vertices.size(); ++v)
    for (std::size_t w = 0; w < v; ++w)
      if (straight.vertices[v].x() > straight.vertices[w].x() + 0.008) {
        EXPECT_LT(tissue.vertices[v].along, tissue.vertices[w].along);
        break;
      }
}

TEST(Tissue, aCutThroughSkinShowsHowDeepItIs) {
  Muscle layer;
  Region skin = layer.part.regions[0];
  skin.id = "skin", skin.kind = "other";
  layer.part.regions = {skin};
  layer.part.materials = {{"fat", ""}, {"skin", "skin"}};
  const Tissue tissue = tissueOf(layer.mesh, &layer.part, Appearance::Skin);
  EXPECT_EQ(tissue.grain, Grain::Skin);
  for (std::size_t v = 0; v < tissue.vertices.size(); ++v) {
    const double x = layer.mesh.vertices[v].x();
    EXPECT_TRUE(x < 0.036 || tissue.vertices[v].fat == 0) << x;
    EXPECT_TRUE(x > 0.024 || tissue.vertices[v].fat == 1) << x;
  }
  layer.part.materials.resize(1);
  EXPECT_EQ(tissueOf(layer.mesh, &layer.part, Appearance::Skin).vertices[0].fat, 0) << "one material: skin throughout";
}

TEST(Tissue, strandsOfABandAreParallel) {
  Muscle band;
  Region end = band.part.regions[0], other{"other", "Other end", "footprint", SurfaceKind::Visual, {}};
  for (int t = 0; t < static_cast<int>(band.mesh.triangles.size()); ++t)
    if (band.mesh.vertices[band.mesh.triangles[t][0]].x() < -0.03) other.triangles.push_back({t, 1});
  end.kind = "footprint";
  band.part.regions = {end, other};
  const Tissue tissue = tissueOf(band.mesh, &band.part, Appearance::Ligament);
  ASSERT_EQ(tissue.grain, Grain::Collagen);
  for (std::size_t v = 0; v < tissue.vertices.size(); ++v)  // the far point of the fan moves them by a few per cent
    EXPECT_NEAR(std::abs(tissue.vertices[v].across), std::abs(band.mesh.vertices[v].y()), 0.1 * 0.02);
}

TEST(Tissue, boneAndToolsHaveNoFibres) {
  Muscle muscle;
  EXPECT_EQ(tissueOf(muscle.mesh, nullptr, Appearance::Plain).grain, Grain::None);
  const Tissue bone = tissueOf(muscle.mesh, &muscle.part, Appearance::Bone);
  EXPECT_EQ(bone.grain, Grain::Bone);
  EXPECT_FLOAT_EQ(bone.vertices[7].across, static_cast<float>(muscle.mesh.vertices[7].x()));
  muscle.part.regions.clear();
  EXPECT_EQ(tissueOf(muscle.mesh, &muscle.part, Appearance::Muscle).grain, Grain::None) << "nothing to run to";
}

}  // namespace
}  // namespace glenoid::test
