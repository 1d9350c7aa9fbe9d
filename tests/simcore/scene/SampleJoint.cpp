// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/scene/SampleJoint.h"

#include <gtest/gtest.h>

namespace glenoid {
namespace {

std::shared_ptr<const TriMesh> corner(const Vec3& at, double size) {
  TriMesh mesh;
  mesh.vertices = {at, at + Vec3(size, 0, 0), at + Vec3(0, size, 0), at + Vec3(0, 0, size)};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return std::make_shared<const TriMesh>(mesh);
}

std::shared_ptr<const TetMesh> filled(const TriMesh& surface) {
  TetMesh mesh;
  mesh.nodes = surface.vertices;
  mesh.tets = {{0, 1, 2, 3}};
  return std::make_shared<const TetMesh>(mesh);
}

}  // namespace

Joint sampleJoint() {
  Joint joint;
  joint.id = "sample";
  joint.name = "Sample \"joint\" — Schulter";
  joint.description = "Two parts.\nSecond line";
  joint.side = JointSide::Left;
  joint.axes_W << 0, 1, 0, 0.6, 0, 0.8, 0.8, 0, -0.6;
  joint.provenance = {"A. Author", "CC0-1.0", "drawn by hand", "2010-09-09"};
  Material bone;
  bone.id = "bone";
  bone.density = 1.0 / 3.0 * 1e4;
  bone.youngsModulus = 1e9;
  bone.poissonRatio = 0;
  Material tendon;
  tendon.id = "tendon";
  tendon.name = "Tendon";
  tendon.appearance = Appearance::Tendon;
  tendon.friction = 0.1;
  tendon.massDamping = 0.7;
  tendon.literatureYoungsModulus = 1.2e9;
  tendon.reason = "too stiff for interaction";
  tendon.source = "a book";
  joint.materials = {bone, tendon};

  Part humerus;
  humerus.id = "humerus";
  humerus.number = 3;
  humerus.name = "Humerus";
  humerus.color = {0.1f, 0.7f, 1.0f};
  humerus.materials = {{"bone", ""}};
  humerus.visual = corner({0, 0, 0}, 0.1);
  humerus.collision = humerus.visual;
  humerus.regions = {{"head", "Head", "cartilage", SurfaceKind::Collision, {{0, 1}, {2, 2}}}};
  humerus.landmarks = {{"tip", "Tip", {0.1, 1.0 / 3.0, -0.0}}};

  Part cuff;
  cuff.id = "cuff";
  cuff.number = 5;
  cuff.name = "Cuff";
  cuff.kind = PartKind::Soft;
  cuff.materials = {{"tendon", ""}, {"bone", "insertion"}};
  cuff.visual = corner({0.2, 0.1, 0.3}, 0.05);
  cuff.collision = corner({0.2, 0.1, 0.3}, 0.04);
  cuff.volume = filled(*cuff.visual);
  cuff.cellSize = 0.0075;
  cuff.elements = Elements::Cells;
  cuff.dents = std::make_shared<const DentTable>(
      DentTable{{0.0015, 0.003, 0.1 / 3}, {{Vec3(0.01, 0.02, -0.03), 5e4 / 3, {3e-4, 2e-4, 1e-5 / 7}, 1e-3}, {Vec3(-0.01, 0, 0.125), 1e9, {1e-4, 1e-5, 1e-9}, 0}}, "of-something"});
  cuff.regions = {{"insertion", "", "footprint", SurfaceKind::Visual, {{1, 3}}},
                  {"empty", "", "", SurfaceKind::Visual, {}}};
  joint.parts = {humerus, cuff};
  joint.couplings = {{"cuff-humerus", "cuff", "humerus", "insertion", 2e7, 1e-3, "grown together"}};
  joint.exclusions = {{"humerus", "cuff", "grown together"}};
  joint.bursae = {{"sac", "Sac", {{"cuff", "empty"}}, {{"humerus", ""}}, 1e-3 / 3.0, 4e3, 2e-3, 0.01, "a guess"}};
  Cage cage;
  cage.id = "cuff-cage";
  cage.part = "cuff";
  cage.triangles = cuff.visual->triangles;
  cage.rest_W = cage.moved_W = cuff.visual->vertices;
  cage.moved_W[1].y() += 1e-3 / 3.0;
  joint.cages = {cage};
  joint.startProof = StartProof{std::string(32, 'a'), 1, 0, 2, 1.0 / 3.0};
  return joint;
}

void expectSame(const Joint& a, const Joint& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.side, b.side);
  EXPECT_EQ(a.axes_W, b.axes_W);
  EXPECT_EQ(a.materials, b.materials);
  EXPECT_EQ(a.couplings, b.couplings);
  EXPECT_EQ(a.exclusions, b.exclusions);
  EXPECT_EQ(a.bursae, b.bursae);
  EXPECT_EQ(a.cages, b.cages);
  EXPECT_EQ(a.startProof, b.startProof);
  EXPECT_EQ(a.provenance, b.provenance);
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    const Part &p = a.parts[i], &q = b.parts[i];
    EXPECT_EQ(p.id, q.id);
    EXPECT_EQ(p.number, q.number);
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.kind, q.kind);
    EXPECT_EQ(p.color, q.color);
    EXPECT_EQ(p.materials, q.materials);
    EXPECT_EQ(p.regions, q.regions);
    EXPECT_EQ(p.landmarks, q.landmarks);
    EXPECT_EQ(p.cellSize, q.cellSize);
    EXPECT_EQ(p.elements, q.elements);
    ASSERT_EQ(p.dents == nullptr, q.dents == nullptr);
    if (p.dents) EXPECT_EQ(*p.dents, *q.dents);
    EXPECT_EQ(*p.visual, *q.visual);
    EXPECT_EQ(*p.collision, *q.collision);
    ASSERT_EQ(bool(p.volume), bool(q.volume));
    if (p.volume) {
      EXPECT_EQ(*p.volume, *q.volume);
    }
  }
}

}  // namespace glenoid
