// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Joint.h"

/// Measures on the surfaces of the shoulder that ships; nothing here knows how the surfaces were made. mm,
/// degrees.
namespace glenoid::test {

/// The joint that ships, loaded once. Fails the calling test when it cannot be loaded.
const Joint& shippedShoulder();

const Part& partOf(const Joint& joint, const std::string& id);
Vec3 landmark(const Part& part, const std::string& id);
/// Vertices of a region, each once, mm.
std::vector<Vec3> verticesOf(const Part& part, const std::string& region);

struct Sphere {
  Vec3 centre;
  double radius, rms;
};
/// Least squares on |p|² = 2 c·p + (r² − |c|²).
Sphere fitSphere(const std::vector<Vec3>& points);

/// Middle of the outline that a horizontal plane cuts from the shaft, mm.
Vec3 shaftMiddle(const TriMesh& humerus, double y);
/// Unit, proximal: line through the middles of slices of the shaft between two heights.
Vec3 shaftAxis(const TriMesh& humerus, double yLow, double yHigh);

/// Cut across the bicipital groove at a height: how deep below the line over its lips, and how wide at half
/// depth.
struct GrooveCut {
  double depth, width;
};
GrooveCut grooveAt(const TriMesh& humerus, double y);

double angleBetween(const Vec3& a, const Vec3& b);

}  // namespace glenoid::test
