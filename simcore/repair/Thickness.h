// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// How thick the walls of a surface are, by rays from its triangles through to the opposite wall, which count where
/// that wall faces away within 60 degrees: at a rim there is no thickness. Weighted by area. At most `most` triangles
/// are asked, spread evenly. Works on surfaces wound either way, as long as each shell is wound one way.
/// Source of the measure: Shapira, Shamir and Cohen-Or, "Consistent mesh partitioning … shape diameter function", 2008,
/// with one ray instead of a cone.
struct ThicknessReport {
  double least = 0, median = 0;  ///< 1 % and 50 % of the area that has a wall behind it; 0 when none has
  double thinShare = 0;          ///< of that area, thinner than the limit
  std::vector<int> thin;         ///< triangles asked and found thinner, ascending
};
ThicknessReport measureThickness(const TriMesh& mesh, double limit, std::size_t most = 4000);

/// Distance to the wall behind each vertex along its normal, HUGE_VAL where there is none.
std::vector<double> wallBehindVertices(const TriMesh& mesh, const std::vector<Vec3>& normals);

/// Normals of the vertices, weighted by the angles at them; zero where a vertex has no triangle.
std::vector<Vec3> vertexNormals(const TriMesh& mesh);

}  // namespace glenoid
