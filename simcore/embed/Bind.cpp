// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/Bind.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <optional>

#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

constexpr double kInside = -1e-12;

/// Every face of every tetrahedron, four in a row: triangle / 4 is the tetrahedron.
TriMesh allFaces(const TetMesh& mesh) {
  TriMesh faces;
  faces.vertices = mesh.nodes;
  for (const auto& t : mesh.tets)
    for (const std::array<int, 3> f : {std::array{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}})
      faces.triangles.push_back({t[f[0]], t[f[1]], t[f[2]]});
  return faces;
}

}  // namespace

std::array<double, 4> barycentricOf(const TetMesh& mesh, int tet, const Vec3& p) {
  const auto& t = mesh.tets[tet];
  const Vec3& x0 = mesh.nodes[t[0]];
  Mat3 D;
  for (int k = 0; k < 3; ++k) D.col(k) = mesh.nodes[t[k + 1]] - x0;
  const Mat3 inverse = D.inverse();
  Vec3 w = inverse * (p - x0);
  w += inverse * (p - x0 - D * w);  // one refinement: far points in flat elements keep their digits
  return {1 - w.x() - w.y() - w.z(), w.x(), w.y(), w.z()};
}

std::vector<int> tetsOf(const TetMesh& mesh, std::span<const Vec3> points_W) {
  const int n = static_cast<int>(mesh.tets.size());
  assert(n > 0);
  std::vector<Box3> boxes(n);
  Box3 all;
  for (int t = 0; t < n; ++t) {
    for (const int v : mesh.tets[t]) boxes[t].extend(mesh.nodes[v]);
    all.extend(boxes[t]);
  }
  const Vec3 margin = Vec3::Constant(1e-9 * all.diagonal().norm());
  for (Box3& box : boxes) box = Box3(box.min() - margin, box.max() + margin);
  std::optional<TriangleTree> faces;  // only when a point lies outside
  std::vector<int> found;
  found.reserve(points_W.size());
  for (const Vec3& p : points_W) {
    int best = -1;
    double bestWeight = kInside;
    for (int t = 0; t < n; ++t) {
      if (!boxes[t].contains(p)) continue;
      const auto w = barycentricOf(mesh, t, p);
      const double least = *std::min_element(w.begin(), w.end());
      if (least > bestWeight || (best < 0 && least >= kInside)) best = t, bestWeight = least;
    }
    if (best < 0) {
      if (!faces) faces.emplace(allFaces(mesh));
      best = std::max(faces->closest(p).triangle, 0) / 4;
    }
    found.push_back(best);
  }
  return found;
}

std::vector<VertexBinding> bindToTets(const TetMesh& mesh, std::span<const Vec3> points_W) {
  const std::vector<int> tets = tetsOf(mesh, points_W);
  std::vector<VertexBinding> bindings(points_W.size());
  for (std::size_t i = 0; i < points_W.size(); ++i) {
    bindings[i].node = mesh.tets[tets[i]];
    bindings[i].weight = barycentricOf(mesh, tets[i], points_W[i]);
  }
  return bindings;
}

std::vector<VertexBinding> bindToRigid(std::span<const Vec3> points_W, const Vec3& origin_W) {
  std::vector<VertexBinding> bindings(points_W.size());
  for (std::size_t i = 0; i < points_W.size(); ++i) bindings[i].r_B = points_W[i] - origin_W;
  return bindings;
}

Vec3 boundPosition(const VertexBinding& binding, std::span<const Vec3> nodes) {
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < 4; ++i) p += binding.weight[i] * nodes[binding.node[i]];
  return p;
}

std::vector<int> labelTets(const TetMesh& mesh, const TriMesh& visual, std::span<const int> labelOfTriangle) {
  assert(labelOfTriangle.size() == visual.triangles.size());
  const TriangleTree tree(visual);
  std::vector<int> labels;
  labels.reserve(mesh.tets.size());
  for (const auto& t : mesh.tets) {
    const Vec3 centroid = (mesh.nodes[t[0]] + mesh.nodes[t[1]] + mesh.nodes[t[2]] + mesh.nodes[t[3]]) / 4;
    const int nearest = tree.closest(centroid).triangle;
    labels.push_back(nearest < 0 ? -1 : labelOfTriangle[nearest]);
  }
  return labels;
}

}  // namespace glenoid
