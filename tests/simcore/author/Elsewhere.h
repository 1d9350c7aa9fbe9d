// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/author/MoveJoint.h"
#include "simcore/scene/Recipe.h"

/// The same anatomy where another author's coordinates would have it.
namespace glenoid::test {

struct Place {
  const char* name;
  Isometry motion;
};

inline Isometry shiftedBy1mm() { return {Mat3::Identity(), Vec3(1e-3, 0, 0)}; }
inline Isometry mirroredInZ() { return {Vec3(1, 1, -1).asDiagonal(), Vec3::Zero()}; }
/// About an oblique axis.
inline Isometry turnedBy20Degrees() {
  return {Eigen::AngleAxisd(M_PI / 9, Vec3(2, -1, 3).normalized()).toRotationMatrix(), Vec3::Zero()};
}
inline Isometry then(const Isometry& first, const Isometry& second) { return {second.R * first.R, second * first.t}; }

inline std::vector<Place> elsewhere() {
  return {{"shifted by 1 mm", shiftedBy1mm()},
          {"mirrored", mirroredInZ()},
          {"turned by 20 degrees", turnedBy20Degrees()},
          {"all of it", then(then(shiftedBy1mm(), mirroredInZ()), turnedBy20Degrees())}};
}

/// Everything of a recipe that has a place.
inline JointRecipe movedRecipe(JointRecipe recipe, const Isometry& motion) {
  for (PartRecipe& part : recipe.parts) {
    for (auto* mesh : {&part.visual, &part.collision})
      if (*mesh) *mesh = std::make_shared<const TriMesh>(movedMesh(**mesh, motion));
    for (Landmark& landmark : part.landmarks) landmark.position_W = motion * landmark.position_W;
  }
  for (NearCoupling& near : recipe.nearCouplings) near.centre_W = motion * near.centre_W;
  return recipe;
}

}  // namespace glenoid::test
