// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/OwnFrame.h"

#include <gtest/gtest.h>

#include "tests/simcore/author/Elsewhere.h"
#include "tests/simcore/author/OverlappingParts.h"

namespace glenoid {
namespace {

using Surfaces = std::vector<std::shared_ptr<const TriMesh>>;

Surfaces lopsided() {
  Surfaces surfaces;
  for (const PartRecipe& part : test::overlappingParts().parts) surfaces.push_back(part.visual);
  return surfaces;
}

Surfaces moved(const Surfaces& surfaces, const Isometry& motion) {
  Surfaces out;
  for (const auto& mesh : surfaces) out.push_back(std::make_shared<const TriMesh>(movedMesh(*mesh, motion)));
  return out;
}

TEST(OwnFrame, goesAlongWithTheSurfacesToTheLastBit) {
  const Surfaces here = lopsided();
  const OwnFrame frame = ownFrameOf(here);
  for (const test::Place& place : test::elsewhere()) {
    SCOPED_TRACE(place.name);
    const Surfaces there = moved(here, place.motion);
    const OwnFrame other = ownFrameOf(there);
    EXPECT_EQ(other.own_W.mirrors(), frame.own_W.mirrors() != place.motion.mirrors());
    EXPECT_EQ(other.grid, frame.grid);
    for (std::size_t i = 0; i < here.size(); ++i) {
      EXPECT_EQ(frame.toOwn(*here[i]), other.toOwn(*there[i]));
      const TriMesh back = other.toW(other.toOwn(*there[i]));
      for (std::size_t v = 0; v < back.vertices.size(); ++v)  // half a grid along each axis
        EXPECT_LT((back.vertices[v] - there[i]->vertices[v]).norm(), 0.9 * frame.grid);
      EXPECT_EQ(back.triangles, there[i]->triangles);
      EXPECT_GT(enclosedVolume(other.toOwn(*there[i])), 0) << "still wound outwards";
    }
  }
}

TEST(OwnFrame, whatIsAlikeOnBothSidesStillHasARigidFrame) {
  for (const TriMesh& mesh : {shapes::box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), shapes::box(Vec3(-2, -1, -1), Vec3(2, 1, 1)), shapes::sphere(0.02),
                              shapes::box(Vec3(-3, -2, -1), Vec3(3, 2, 1))}) {
    const OwnFrame frame = ownFrameOf({std::make_shared<const TriMesh>(mesh)});
    EXPECT_LT((frame.own_W.R * frame.own_W.R.transpose() - Mat3::Identity()).norm(), 1e-12);
    // A shift alone changes nothing even where the shape has no axes of its own.
    const Isometry shift{Mat3::Identity(), Vec3(0.31, -0.17, 0.05)};
    const OwnFrame other = ownFrameOf({std::make_shared<const TriMesh>(movedMesh(mesh, shift))});
    EXPECT_LT((frame.own_W.R - other.own_W.R).norm(), 1e-5);
  }
}

TEST(OwnFrame, ofNothingItIsTheWorld) {
  const OwnFrame frame = ownFrameOf(Surfaces{nullptr, std::make_shared<const TriMesh>()});
  EXPECT_EQ(frame.own_W.R, Mat3::Identity());
  EXPECT_EQ(frame.own_W.t, Vec3::Zero());
  const TriMesh mesh = shapes::sphere(0.01);
  EXPECT_EQ(frame.toOwn(mesh), mesh);
}

TEST(OwnFrame, theOwnOrderForgetsHowTheFileWasWritten) {
  const TriMesh mesh = *lopsided()[1];
  // The same surface as another program would write it: other numbers of the vertices, other first corners.
  TriMesh other;
  const int n = static_cast<int>(mesh.vertices.size());
  for (int i = 0; i < n; ++i) other.vertices.push_back(mesh.vertices[n - 1 - i]);
  for (auto t = mesh.triangles.rbegin(); t != mesh.triangles.rend(); ++t) other.triangles.push_back({n - 1 - (*t)[1], n - 1 - (*t)[2], n - 1 - (*t)[0]});
  EXPECT_EQ(inOwnOrder(mesh), inOwnOrder(other));
  EXPECT_DOUBLE_EQ(enclosedVolume(inOwnOrder(mesh)), enclosedVolume(inOwnOrder(other)));
  EXPECT_NEAR(enclosedVolume(inOwnOrder(mesh)), enclosedVolume(mesh), 1e-12);
}

}  // namespace
}  // namespace glenoid
