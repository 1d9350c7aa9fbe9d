// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "simcore/mesh/TetMesh.h"

namespace glenoid {

/// Values at the points or cells of a grid, one after another: scalars, vectors or 3×3 tensors row by row.
struct VtuField {
  std::string name;
  int components = 1;  ///< 1, 3 or 9
  bool whole = false;  ///< written as Int32, else as Float64
  std::vector<double> values;

  void append(const Vec3& vector) { values.insert(values.end(), vector.data(), vector.data() + 3); }
  void append(const Mat3& tensor) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) values.push_back(tensor(r, c));
  }
};

/// Linear tetrahedra of one or several meshes with fields. Unit and frame are the caller's.
struct VtuGrid {
  std::vector<Vec3> points;
  std::vector<std::array<int, 4>> tets;
  std::vector<VtuField> pointFields, cellFields;

  void append(const TetMesh& mesh);
};

/// VTK XML unstructured grid, ASCII; every double reads back as it was. The first point field is the grid's vectors.
/// Source: VTK file formats, The VTK User's Guide.
std::string vtuText(const VtuGrid& grid);

}  // namespace glenoid
