// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/TetTools.h"

#include <gtest/gtest.h>

#include "simcore/mesh/Cleanup.h"
#include "simcore/mesh/MeshHealth.h"

using namespace glenoid;

namespace {

/// Unit cube as five tetrahedra; corner i has the bits of its coordinates.
TetMesh cube() {
  TetMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.nodes.push_back(Vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
  mesh.tets = {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}};
  for (auto& t : mesh.tets) {
    TetMesh one{mesh.nodes, {t}};
    if (tetVolume(one, 0) < 0) std::swap(t[0], t[1]);
  }
  return mesh;
}

}  // namespace

TEST(TetTools, cubeOfFive) {
  const TetMesh mesh = cube();
  EXPECT_NEAR(totalVolume(mesh), 1, 1e-15);
  const TetHealth health = healthOf(mesh);
  EXPECT_TRUE(health.healthy());
  EXPECT_EQ(health.components, 1);
  const TriMesh surface = boundaryOf(mesh);
  EXPECT_EQ(surface.triangles.size(), 12u);
  EXPECT_TRUE(healthOf(surface).healthy());
  EXPECT_NEAR(enclosedVolume(surface), 1, 1e-15);
  // The middle one is regular, the corners are 12·(1/2)^(2/3)/9.
  EXPECT_NEAR(qualityOf(mesh).max, 1, 1e-14);
  EXPECT_NEAR(qualityOf(mesh).min, 12 * std::pow(0.5, 2.0 / 3) / 9, 1e-14);
}

TEST(TetTools, defectsAreCounted) {
  TetMesh turned = cube();
  std::swap(turned.tets[4][0], turned.tets[4][1]);
  EXPECT_EQ(healthOf(turned).badTets, 1);
  EXPECT_EQ(healthOf(turned).misorientedFaces, 4);
  EXPECT_LT(tetQuality(turned, 4), 0);

  TetMesh twice = cube();
  twice.tets.push_back(twice.tets[4]);
  EXPECT_EQ(healthOf(twice).overusedFaces, 4);

  TetMesh index = cube();
  index.tets[0][2] = 99;
  EXPECT_EQ(healthOf(index).badIndices, 1);

  TetMesh apart = cube();
  apart.tets.erase(apart.tets.begin() + 4);  // the corners touch each other along edges only
  EXPECT_EQ(healthOf(apart).components, 4);
  EXPECT_EQ(faceComponents(apart), (std::vector<int>{0, 1, 2, 3}));
}
