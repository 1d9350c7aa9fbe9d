// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "simcore/scene/Joint.h"

/// Moments of surfaces by numbers alone, to judge the closed forms: another way than the one under test.
namespace glenoid::test {

struct SurfaceIntegral {
  double area = 0;
  Vec3 centre = Vec3::Zero();
  Mat3 second = Mat3::Zero();  ///< about the centre
};

/// ∫ over the region by a product of three Gauss points a side on the unit square folded onto each triangle (Duffy):
/// exact for polynomials of degree four.
SurfaceIntegral integrated(const TriMesh& mesh, const std::vector<int>& triangles);

/// k ∫ ((n × r)·(n × r)) dA about the centre: N m a radian about the unit vector n, for one N/m per m².
double turning(const SurfaceIntegral& integral, const Vec3& n);

}  // namespace glenoid::test
