// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/TetTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace glenoid {
namespace {

/// Faces opposite to each corner, counter-clockwise seen from outside a positive tetrahedron.
constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

struct Face {
  std::array<int, 3> key;     ///< sorted
  std::array<int, 3> corner;  ///< as its tetrahedron sees it
  int tet;
  bool even;  ///< corner is an even permutation of key
  bool operator<(const Face& o) const { return std::tie(key, tet) < std::tie(o.key, o.tet); }
};

std::vector<Face> facesOf(const TetMesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(4 * mesh.tets.size());
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t)
    for (const auto& f : kFaces) {
      const std::array<int, 3> c{mesh.tets[t][f[0]], mesh.tets[t][f[1]], mesh.tets[t][f[2]]};
      const int swaps = (c[0] > c[1]) + (c[0] > c[2]) + (c[1] > c[2]);
      std::array<int, 3> key = c;
      std::sort(key.begin(), key.end());
      faces.push_back({key, c, t, swaps % 2 == 0});
    }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

double totalVolume(const TetMesh& mesh) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) sum += tetVolume(mesh, t);
  return sum;
}

TriMesh boundaryOf(const TetMesh& mesh) {
  const std::vector<Face> faces = facesOf(mesh);
  std::vector<Face> outer;
  for (std::size_t i = 0, end; i < faces.size(); i = end) {
    for (end = i + 1; end < faces.size() && faces[end].key == faces[i].key;) ++end;
    if (end - i == 1) outer.push_back(faces[i]);
  }
  std::sort(outer.begin(), outer.end(),
            [](const Face& a, const Face& b) { return std::tie(a.tet, a.key) < std::tie(b.tet, b.key); });
  TriMesh surface;
  surface.vertices = mesh.nodes;
  for (const Face& f : outer) surface.triangles.push_back(f.corner);
  return surface;
}

double tetQuality(const TetMesh& mesh, int tet) {
  const auto& t = mesh.tets[tet];
  double squares = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) squares += (mesh.nodes[t[i]] - mesh.nodes[t[j]]).squaredNorm();
  const double volume = tetVolume(mesh, tet);
  if (!(squares > 0)) return 0;
  const double root = std::cbrt(3 * std::abs(volume));
  return std::copysign(12 * root * root / squares, volume);
}

QualityRange qualityOf(const TetMesh& mesh) {
  QualityRange range;
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
    const double q = tetQuality(mesh, t);
    range = t == 0 ? QualityRange{q, q} : QualityRange{std::min(range.min, q), std::max(range.max, q)};
  }
  return range;
}

std::vector<int> faceComponents(const TetMesh& mesh, int* count) {
  const std::vector<Face> faces = facesOf(mesh);
  std::vector<int> parent(mesh.tets.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].key == faces[i - 1].key) {
      const int a = root(faces[i].tet), b = root(faces[i - 1].tet);
      parent[std::max(a, b)] = std::min(a, b);
    }
  std::vector<int> component(mesh.tets.size());
  int found = 0;
  for (int t = 0; t < static_cast<int>(component.size()); ++t)
    component[t] = root(t) == t ? found++ : component[root(t)];
  if (count) *count = found;
  return component;
}

TetHealth healthOf(const TetMesh& mesh) {
  TetHealth health;
  const int n = static_cast<int>(mesh.nodes.size());
  TetMesh good;
  good.nodes = mesh.nodes;
  std::vector<char> used(n, 0);
  for (const auto& t : mesh.tets)
    if (std::all_of(t.begin(), t.end(), [n](int i) { return i >= 0 && i < n; })) {
      good.tets.push_back(t);
      for (const int i : t) used[i] = 1;
    } else {
      ++health.badIndices;
    }
  for (int t = 0; t < static_cast<int>(good.tets.size()); ++t) health.badTets += !(tetVolume(good, t) > 0);
  health.unusedNodes = static_cast<int>(std::count(used.begin(), used.end(), 0));
  const std::vector<Face> faces = facesOf(good);
  for (std::size_t i = 0, end; i < faces.size(); i = end) {
    for (end = i + 1; end < faces.size() && faces[end].key == faces[i].key;) ++end;
    if (end - i > 2) ++health.overusedFaces;
    if (end - i == 2 && faces[i].even == faces[i + 1].even) ++health.misorientedFaces;
  }
  faceComponents(good, &health.components);
  return health;
}

}  // namespace glenoid
