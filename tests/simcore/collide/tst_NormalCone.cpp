// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/collide/NormalCone.h"
#include "tests/simcore/collide/Scene.h"

namespace glenoid {
namespace {

using namespace shapes;

/// A box of side one whose lowest corner lies at `low`, as a surface that lies still.
struct Box {
  explicit Box(const Vec3& low) : mesh(box(low, low + Vec3::Ones())), surface(makeCollisionSurface(mesh)) {
    surface.update(mesh.vertices, {}, 0.1, 0.005);
  }
  int vertexAt(const Vec3& p) const {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      if ((mesh.vertices[i] - p).norm() < 1e-9) return static_cast<int>(i);
    return -1;
  }
  int edgeAt(const Vec3& p, const Vec3& q) const {
    const int a = vertexAt(p), b = vertexAt(q);
    for (const int e : surface.topology().edgesOf(a))
      for (const int v : surface.topology().edges[e].vertices)
        if (v == b) return e;
    return -1;
  }
  NormalCone cone(FeatureKind kind, int id) {
    NormalCone result;
    result.take(surface, {kind, id}, assignOwners(surface.topology(), {}));
    return result;
  }
  TriMesh mesh;
  MovingSurface surface;
};

TEST(NormalCone, ofACornerHoldsItsThreeFacesAndNothingBeside) {
  Box cube(Vec3::Zero());
  const NormalCone cone = cube.cone(FeatureKind::Vertex, cube.vertexAt(Vec3::Ones()));
  for (const Vec3& n : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 1).normalized().eval()}) EXPECT_LE(cone.beyond(n), 1e-15);
  EXPECT_NEAR(cone.beyond(Vec3(1, -0.1, 0).normalized()), 0.1 / std::sqrt(1.01), 1e-12);
  EXPECT_GT(cone.beyond(Vec3(-1, 0, 0)), 0.9);
}

TEST(NormalCone, cornerOnCornerSharesOneRay) {
  Box lower(Vec3::Zero()), upper(Vec3(0, 1, 0));
  for (const double x : {0.0, 1.0})
    for (const double z : {0.0, 1.0}) {
      const NormalCone below = lower.cone(FeatureKind::Vertex, lower.vertexAt(Vec3(x, 1, z)));
      const NormalCone above = upper.cone(FeatureKind::Vertex, upper.vertexAt(Vec3(x, 1, z)));
      const auto n = sharedNormal(below, above, 0.03, 0.5, nullptr);
      ASSERT_TRUE(n);
      EXPECT_LT((*n - Vec3::UnitY()).norm(), 1e-15);
    }
}

TEST(NormalCone, edgeOnEdgeOfAStepSharesOneRay) {
  Box lower(Vec3::Zero()), upper(Vec3(0.5, 1, 0));  // upper's corner lies on an edge of the lower's top
  const auto n = sharedNormal(lower.cone(FeatureKind::Edge, lower.edgeAt(Vec3(0, 1, 0), Vec3(1, 1, 0))),
                              upper.cone(FeatureKind::Vertex, upper.vertexAt(Vec3(0.5, 1, 0))), 0.03, 0.5, nullptr);
  ASSERT_TRUE(n);
  EXPECT_LT((*n - Vec3::UnitY()).norm(), 1e-15);
}

TEST(NormalCone, ofAWideSetTheLastNormalOrTheMiddle) {
  Box lower(Vec3::Zero()), upper(Vec3::Ones());  // corner against corner across the diagonal: a whole octant
  const NormalCone below = lower.cone(FeatureKind::Vertex, lower.vertexAt(Vec3::Ones()));
  const NormalCone above = upper.cone(FeatureKind::Vertex, upper.vertexAt(Vec3::Ones()));
  const auto middle = sharedNormal(below, above, 0.03, 0.5, nullptr);
  ASSERT_TRUE(middle);
  EXPECT_LT((*middle - Vec3::Ones().normalized()).norm(), 1e-12);
  const Vec3 inside = Vec3(1, 2, 3).normalized();
  EXPECT_EQ(*sharedNormal(below, above, 0.03, 0.5, &inside), inside);
  const Vec3 outside = Vec3(1, 1, -0.5).normalized();  // its nearest in the octant has no z
  EXPECT_LT((*sharedNormal(below, above, 0.03, 0.5, &outside) - Vec3(1, 1, 0).normalized()).norm(), 1e-12);
}

TEST(NormalCone, whereNothingIsSharedTheLeastAngleOrNothing) {
  Box lower(Vec3::Zero()), upper(Vec3(0, 1, 0));
  const Quat lean(Eigen::AngleAxisd(-0.2, Vec3::UnitZ()));  // the upper box leans into the lower: no plane parts them
  for (Vec3& x : upper.mesh.vertices) x = Vec3(0, 1, 0) + lean * (x - Vec3(0, 1, 0));
  upper.surface.update(upper.mesh.vertices, {}, 0.1, 0.005);
  const NormalCone below = lower.cone(FeatureKind::Edge, lower.edgeAt(Vec3(0, 1, 0), Vec3(0, 1, 1)));
  const NormalCone above = upper.cone(FeatureKind::Vertex, upper.vertexAt(Vec3(0, 1, 0)));
  const auto n = sharedNormal(below, above, 0.03, 0.5, nullptr);
  ASSERT_TRUE(n);
  EXPECT_NEAR(n->norm(), 1, 1e-12);
  EXPECT_GT(n->y(), 0.9);
  // Two tops that look the same way have nothing to say to each other.
  EXPECT_FALSE(sharedNormal(lower.cone(FeatureKind::Face, 0), lower.cone(FeatureKind::Face, 0), 0.03, 0.5, nullptr));
}

}  // namespace
}  // namespace glenoid
