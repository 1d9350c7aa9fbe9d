// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/CollisionSurface.h"

#include <algorithm>
#include <cassert>

namespace glenoid {
namespace {

/// One side of a triangle, seen from its edge.
struct Side {
  std::array<int, 2> vertices;  ///< ascending
  int triangle, corner;         ///< the side joins corners corner and corner + 1
  bool empty;                   ///< of a triangle that carries nothing
  bool reversed;                ///< the triangle runs from the larger vertex to the smaller
};

/// Triangles that carry nothing: without area, or with the corners of an earlier one.
std::vector<char> emptyTriangles(const TriMesh& mesh) {
  std::vector<char> empty(mesh.triangles.size(), 0);
  std::vector<std::array<int, 4>> corners;  // ascending, then the triangle
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    std::array<int, 3> c = mesh.triangles[t];
    if (isFlatTriangle(mesh.vertices[c[0]], mesh.vertices[c[1]], mesh.vertices[c[2]])) empty[t] = 1;
    std::sort(c.begin(), c.end());
    corners.push_back({c[0], c[1], c[2], t});
  }
  std::sort(corners.begin(), corners.end());
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (std::equal(corners[i].begin(), corners[i].begin() + 3, corners[i - 1].begin())) empty[corners[i][3]] = 1;
  return empty;
}

void measure(const TriMesh& mesh, CollisionSurface& surface) {
  Box3 box;
  for (const Vec3& x : mesh.vertices) box.extend(x);
  if (mesh.vertices.empty()) return;
  surface.size = box.diagonal().norm();
  double volume = 0, area = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 a = mesh.vertices[i] - box.center(), across = (mesh.vertices[j] - mesh.vertices[i]).cross(mesh.vertices[k] - mesh.vertices[i]);
    volume += a.dot(across) / 6;
    area += across.norm() / 2;
  }
  const double shortest = box.sizes().minCoeff();
  surface.thickness = volume > 0 ? std::min(2 * volume / area, shortest) : shortest;
}

/// Rows of a table from (row, entry) pairs that come in ascending order of entry.
void makeRows(int rows, const std::vector<std::array<int, 2>>& entries, std::vector<int>& start,
              std::vector<int>& list) {
  start.assign(rows + 1, 0);
  for (const auto& [row, entry] : entries) ++start[row + 1];
  for (int i = 0; i < rows; ++i) start[i + 1] += start[i];
  list.resize(entries.size());
  std::vector<int> next(start.begin(), start.end() - 1);
  for (const auto& [row, entry] : entries) list[next[row]++] = entry;
}

}  // namespace

bool isFlatTriangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  // Ten digits below its size nothing is left of the direction of its normal.
  return !((b - a).cross(c - a).norm() > 1e-10 * longest);
}

std::shared_ptr<const CollisionSurface> makeCollisionSurface(const TriMesh& mesh, bool deforms) {
  auto surface = std::make_shared<CollisionSurface>();
  surface->vertexCount = static_cast<int>(mesh.vertices.size());
  surface->triangles = mesh.triangles;
  surface->restVertices = mesh.vertices;
  surface->deforms = deforms;

  surface->empty = emptyTriangles(mesh);
  measure(mesh, *surface);

  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  std::vector<std::array<int, 2>> entries;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      assert(a >= 0 && a < surface->vertexCount);
      sides.push_back({{std::min(a, b), std::max(a, b)}, t, k, surface->empty[t] != 0, a > b});
      if (!surface->empty[t]) entries.push_back({a, t});
    }
  }
  makeRows(surface->vertexCount, entries, surface->triangleStart, surface->triangleList);

  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    if (x.vertices != y.vertices) return x.vertices < y.vertices;
    return x.empty != y.empty ? y.empty : x.triangle < y.triangle;
  });
  surface->closed = !sides.empty();
  surface->triangleEdges.resize(mesh.triangles.size());
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].vertices == sides[first].vertices) ++last;
    CollisionSurface::Edge edge{sides[first].vertices, {-1, -1}, {-1, -1}};
    for (std::size_t i = first; i < last; ++i) {
      const Side& side = sides[i];
      surface->triangleEdges[side.triangle][side.corner] = static_cast<int>(surface->edges.size());
      if (i - first >= 2) continue;
      edge.triangles[i - first] = side.triangle;
      edge.opposite[i - first] = mesh.triangles[side.triangle][(side.corner + 2) % 3];
    }
    if (last - first != 2 || sides[first].reversed == sides[first + 1].reversed) surface->closed = false;
    surface->edges.push_back(edge);
    first = last;
  }

  entries.clear();
  for (int e = 0; e < static_cast<int>(surface->edges.size()); ++e) {
    for (const int v : surface->edges[e].vertices) entries.push_back({v, e});
  }
  makeRows(surface->vertexCount, entries, surface->edgeStart, surface->edgeList);
  return surface;
}

}  // namespace glenoid
