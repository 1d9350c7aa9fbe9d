// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/export/QuadraticTets.h"

#include <algorithm>

namespace glenoid::exporting {

QuadraticTets quadraticOf(const TetMesh& mesh) {
  QuadraticTets fine{mesh.nodes, {}, {}};
  for (const auto& tet : mesh.tets) {
    std::array<int, 10> ten{};
    std::copy(tet.begin(), tet.end(), ten.begin());
    for (int e = 0; e < 6; ++e) {
      const auto edge = std::minmax(tet[kTetEdges[e][0]], tet[kTetEdges[e][1]]);
      const auto [entry, fresh] = fine.middleOf.try_emplace(edge, static_cast<int>(fine.nodes.size()));
      if (fresh) fine.nodes.push_back(0.5 * (mesh.nodes[edge.first] + mesh.nodes[edge.second]));
      ten[4 + e] = entry->second;
    }
    fine.tets.push_back(ten);
  }
  return fine;
}

std::array<double, 10> quadraticShape(const std::array<double, 4>& weights) {
  std::array<double, 10> shape{};
  for (int k = 0; k < 4; ++k) shape[k] = weights[k] * (2 * weights[k] - 1);
  for (int e = 0; e < 6; ++e) shape[4 + e] = 4 * weights[kTetEdges[e][0]] * weights[kTetEdges[e][1]];
  return shape;
}

}  // namespace glenoid::exporting
