// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/author/BuildJoint.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid::test {

inline PartRecipe partOf(const std::string& id, int number, PartKind kind, TriMesh mesh, int tetrahedra = 0) {
  PartRecipe part;
  part.id = id;
  part.number = number;
  part.kind = kind;
  part.visual = std::make_shared<const TriMesh>(std::move(mesh));
  part.collisionTriangles = 300;
  part.tetrahedra = tetrahedra;
  part.materials = {{kind == PartKind::Rigid ? "bone" : "muscle", ""}};
  return part;
}

inline Pose shiftedBy(double x, double y, double z) {
  Pose pose;
  pose.p_WB = Vec3(x, y, z);
  return pose;
}

/// A ball of bone of 24 mm, a band of muscle that lies up to 4 mm deep in it, and a thin strap half inside the band.
inline JointRecipe overlappingParts() {
  JointRecipe recipe;
  recipe.id = recipe.name = "overlapping";
  recipe.materials.resize(2);
  recipe.materials[0].id = "bone";
  recipe.materials[1].id = "muscle";
  recipe.parts = {
      partOf("ball", 1, PartKind::Rigid, shapes::sphere(0.024)),
      partOf("band", 2, PartKind::Soft, shapes::moved(shapes::sheet(0.09, 0.03, 0.008, 0.5), shiftedBy(0, 0, 0.024)), 400),
      partOf("strap", 3, PartKind::Soft, shapes::moved(shapes::sheet(0.04, 0.012, 0.002, 0.3), shiftedBy(0.004, 0.01, 0.0275)), 200),
  };
  return recipe;
}

}  // namespace glenoid::test
