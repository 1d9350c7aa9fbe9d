// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/RegionPoints.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "simcore/embed/Bind.h"

namespace glenoid {

namespace {

constexpr int kSplitMost = 16;
constexpr double kTrianglesMost = 4e5;  ///< after the split: bounds the memory of a region as fine as a scan

/// How often each edge is cut.
int splitOf(const TetMesh& volume, const TriMesh& surface, const std::vector<int>& triangles) {
  double edges = 0, longest = 0;
  for (const auto& tet : volume.tets)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) edges += (volume.nodes[tet[i]] - volume.nodes[tet[j]]).norm();
  const double edge = edges / (6.0 * static_cast<double>(volume.tets.size()));
  for (const int t : triangles)
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, (surface.vertices[surface.triangles[t][i]] - surface.vertices[surface.triangles[t][(i + 1) % 3]]).norm());
  const double room = std::floor(std::sqrt(kTrianglesMost / static_cast<double>(triangles.size())));
  return static_cast<int>(std::clamp(std::ceil(longest / (0.5 * edge)), 1.0, std::clamp<double>(room, 1, kSplitMost)));
}

/// The corners of the small triangles, shared along the edges of the large ones.
class Corners {
 public:
  Corners(const TriMesh& surface, int split, std::vector<Vec3>& out) : m_surface(surface), m_split(split), m_out(out) {}

  /// (i, j, k)/split of a triangle's three corners; named by the vertices that have weight, so that neighbours agree.
  int at(const std::array<int, 3>& triangle, const std::array<int, 3>& weight) {
    Key key{};
    int used = 0;
    for (int corner = 0; corner < 3; ++corner)
      if (weight[corner] > 0) {
        int place = used++;
        for (; place > 0 && key[place - 1][0] > triangle[corner] + 1; --place) key[place] = key[place - 1];
        key[place] = {triangle[corner] + 1, weight[corner]};
      }
    const auto [place, isNew] = m_index.try_emplace(key, static_cast<int>(m_out.size()));
    if (isNew) {
      Vec3 p = Vec3::Zero();
      for (int i = 0; i < used; ++i) p += static_cast<double>(key[i][1]) / m_split * m_surface.vertices[key[i][0] - 1];
      m_out.push_back(p);
    }
    return place->second;
  }

 private:
  using Key = std::array<std::array<int, 2>, 3>;
  const TriMesh& m_surface;
  int m_split;
  std::vector<Vec3>& m_out;
  std::map<Key, int> m_index;
};

}  // namespace

Result<RegionPoints> regionPoints(const SceneObject& object, const Part& part, const std::string& regionId,
                                  const Vec3& restCentre) {
  const Region* region = findRegion(part, regionId);
  if (!region) return Error{Fault::UnknownId, {"", "", part.id, {}}, {regionId, "region"}, ""};
  const TriMesh& surface = region->surface == SurfaceKind::Visual ? *part.visual : *part.collision;
  const std::vector<int> chosen = trianglesOf(*region);
  RegionPoints out;
  if (!chosen.empty()) {
    const int n = object.layout.rigid ? 1 : splitOf(*object.volume, surface, chosen);
    Corners corners(surface, n, out.rest_W);
    for (const int t : chosen) {
      const std::array<int, 3>& corner = surface.triangles[t];
      const auto at = [&](int i, int j) { return corners.at(corner, {n - i - j, i, j}); };
      for (int i = 0; i < n; ++i)
        for (int j = 0; i + j < n; ++j) {
          out.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
          if (i + j + 1 < n) out.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
  }
  double whole = 0;
  out.area.assign(out.rest_W.size(), 0);
  for (const auto& t : out.triangles) {
    const double area = 0.5 * (out.rest_W[t[1]] - out.rest_W[t[0]]).cross(out.rest_W[t[2]] - out.rest_W[t[0]]).norm();
    whole += area;
    for (const int corner : t) out.area[corner] += area / 3;
  }
  if (!(whole > 0)) return Error{Fault::Unusable, {"", "", part.id, {}}, {"the region “" + regionId + "” has no area"}, ""};
  const std::vector<VertexBinding> bindings =
      object.layout.rigid ? bindToRigid(out.rest_W, restCentre) : bindToTets(*object.volume, out.rest_W);
  for (const VertexBinding& binding : bindings) out.points.push_back(pointAt(binding, object.layout.rigid));
  return out;
}

}  // namespace glenoid
