// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/mesh/TriMesh.h"
#include "simcore/scene/Part.h"

/// Measures on any closed surface, and the table they are written into. Millimetres, frame W.
namespace glenoid::test {

/// The table's lines can be taken out of the output with grep '^|'.
struct Wanted {
  double value, tolerance;  ///< one standard deviation, or a tenth of the value where none is published
  const char* source;
};
/// Prints a line and expects the measured value within the tolerance.
void expectMeasure(const std::string& quantity, double measured, const char* unit, const Wanted& wanted);
/// Prints a line and judges nothing, for the reason given.
void reportMeasure(const std::string& quantity, double measured, const char* unit, const Wanted& wanted,
                   const char* reason);
/// One standard deviation unknown: a tenth.
Wanted tenth(double value, const char* source);

TriMesh inMillimetres(const TriMesh& metres);
/// The triangles of a region as a surface of its own, mm.
TriMesh surfaceOf(const Part& part, const std::string& region);
double areaOf(const TriMesh& mesh);
Vec3 centroidOf(const TriMesh& mesh);

/// Where a plane cuts a closed surface. Only pieces within `reach` of `origin` count.
struct Cut {
  double area = 0;           ///< mm², enclosed
  std::vector<Vec3> points;  ///< of the outline
  Vec3 middle = Vec3::Zero();
};
Cut cutBy(const TriMesh& mesh, const Vec3& origin, const Vec3& normal, double reach = 1e9);

/// Extent of points along a direction.
double extentAlong(const std::vector<Vec3>& points, const Vec3& direction);
/// Extents along the principal axes of a surface, area weighted, longest first; columns of `axes` are the
/// axes.
struct Extents {
  Vec3 size;
  Mat3 axes;
};
Extents principalExtents(const TriMesh& mesh);

/// A band from one end to the other: sections across the line between the middles of its ends.
struct Band {
  double lengthA, lengthB;       ///< mm, of its two edges, between the given shares of the way
  double widthFirst, widthLast;  ///< mm, at the two ends
  double thickness;              ///< mm, mean of section area over width
};
Band measureBand(const TriMesh& mesh, const Vec3& first, const Vec3& last, const Vec3& acrossHint);

/// Diameter of the largest ball that fits inside.
double thicknessOf(const TriMesh& mesh);

}  // namespace glenoid::test
