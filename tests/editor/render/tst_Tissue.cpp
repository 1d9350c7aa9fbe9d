// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Tissue.h"

#include <gtest/gtest.h>

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
  const Tissue tissue = tissueOf(muscle.mesh, &muscle.part);
  ASSERT_EQ(tissue.vertices.size(), muscle.mesh.vertices.size());
  for (std::size_t v = 0; v < tissue.vertices.size(); ++v) {
    const double x = muscle.mesh.vertices[v].x();
    // Rows of triangles are up to 7 mm apart; the border is spread over two of them.
    EXPECT_TRUE(x < 0.046 || tissue.vertices[v].tendon > 0.8) << x;
    EXPECT_TRUE(x > 0.01 || tissue.vertices[v].tendon == 0) << x;
    EXPECT_EQ(tissue.vertices[v].cartilage, 0);
  }
}

TEST(Tissue, fibresRunTowardsTheTendon) {
  const Muscle muscle;
  const Tissue tissue = tissueOf(muscle.mesh, &muscle.part);
  ASSERT_TRUE(tissue.fibres);
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

TEST(Tissue, boneAndToolsHaveNoFibres) {
  Muscle muscle;
  EXPECT_FALSE(tissueOf(muscle.mesh, nullptr).fibres);
  muscle.part.kind = PartKind::Rigid;
  const Tissue bone = tissueOf(muscle.mesh, &muscle.part);
  EXPECT_FALSE(bone.fibres);
  EXPECT_FLOAT_EQ(bone.vertices[7].across, static_cast<float>(muscle.mesh.vertices[7].x()));
  muscle.part.kind = PartKind::Soft;
  muscle.part.regions.clear();
  EXPECT_FALSE(tissueOf(muscle.mesh, &muscle.part).fibres);
}

}  // namespace
}  // namespace glenoid::test
