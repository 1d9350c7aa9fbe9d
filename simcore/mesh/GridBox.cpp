// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/GridBox.h"

#include <map>

namespace glenoid {

TriMesh gridBox(const Vec3& low, const Vec3& high, const std::array<int, 3>& cells) {
  TriMesh mesh;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [it, isNew] = index.try_emplace(at, static_cast<int>(mesh.vertices.size()));
    const Vec3 share(double(at[0]) / cells[0], double(at[1]) / cells[1], double(at[2]) / cells[2]);
    if (isNew) mesh.vertices.push_back(low + (high - low).cwiseProduct(share));
    return it->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true})
      for (int i = 0; i < cells[(axis + 1) % 3]; ++i)
        for (int j = 0; j < cells[(axis + 2) % 3]; ++j) {
          const auto at = [&](int u, int v) {
            std::array<int, 3> place{};
            place[axis] = far ? cells[axis] : 0;
            place[(axis + 1) % 3] = u;
            place[(axis + 2) % 3] = v;
            return vertex(place);
          };
          const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
          if (far) {
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
          } else {
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({a, d, c});
          }
        }
  return mesh;
}

}  // namespace glenoid
