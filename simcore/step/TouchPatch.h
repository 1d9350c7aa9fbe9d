// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "simcore/step/StepModel.h"
#include "simcore/step/StepWork.h"

namespace glenoid {

/// A patch of a part's visual surface: points round a middle, at rest and as they lie now. Its slopes are the mean change of
/// position for each metre along two directions at rest, so their cross product is the patch's normal at either time.
struct TouchPatch {
  Vec3 middle = Vec3::Zero();                      ///< at rest
  MaterialPoint middlePoint, back;                 ///< back: where the normal at rest comes out of the part again
  bool hasBack = false;
  int tissue = 0;                                  ///< which use of a material its middle shows
  std::array<MaterialPoint, Touch::kPoints> points;  ///< with kTouchWeights
  Vec3 e1 = Vec3::UnitX(), e2 = Vec3::UnitY();     ///< at rest, unit, across the patch
  Vec3 rest = Vec3::Zero(), now = Vec3::Zero();    ///< weighted means of the points
  Vec3 restNormal = Vec3::UnitZ();                 ///< unit, outwards
  std::array<Vec3, 2> slopes{Vec3::UnitX(), Vec3::UnitY()};      ///< now
  std::array<std::array<double, Touch::kPoints>, 2> slopeWeights{};  ///< of the points in each slope, 1/m
};

/// About the point of the surface at rest nearest to `near`.
TouchPatch makeTouchPatch(const DentModel& dent, const SceneObject& object, const Vec3& near, double radius, const VecX& q);

/// Tissue below a place of the surface at rest, m; 0 where the normal into it comes out nowhere.
double depthAt(const DentModel& dent, const Vec3& place, const Vec3& normal);

/// Finds the back of a patch.
void findBack(const DentModel& dent, const SceneObject& object, TouchPatch& patch);

/// Where a point of an object's visual surface lies now.
Vec3 placeOf(const SceneObject& object, const MaterialPoint& point, const VecX& q);

}  // namespace glenoid
