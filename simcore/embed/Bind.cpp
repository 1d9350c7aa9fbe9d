// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/Bind.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <optional>

#include "simcore/spatial/BoxTree.h"
#include "simcore/spatial/TrianglePoint.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

constexpr double kInside = -1e-12;

/// The tetrahedron with the face nearest to a point; of equals the first.
int nearestTet(const TetMesh& mesh, const BoxTree& tree, const Vec3& p) {
  int best = 0, bestFace = -1;
  tree.nearest(p, std::numeric_limits<double>::infinity(), [&](int tet, double least) {
    const auto& t = mesh.tets[static_cast<std::size_t>(tet)];
    double nearest = least;
    int face = 4 * tet;
    for (const std::array<std::size_t, 3> f : {std::array<std::size_t, 3>{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}) {
      const Vec3 &a = mesh.nodes[t[f[0]]], &b = mesh.nodes[t[f[1]]], &c = mesh.nodes[t[f[2]]];
      const Vec3 w = nearestBarycentric(p, a, b, c);
      const double d = (w[0] * a + w[1] * b + w[2] * c - p).squaredNorm();
      if (d < nearest || (d == nearest && bestFace >= 0 && face < bestFace)) {
        nearest = d;
        best = tet;
        bestFace = face;
      }
      ++face;
    }
    return nearest;
  });
  return best;
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
  std::vector<Box3> boxes(static_cast<std::size_t>(n));
  Box3 all;
  for (int t = 0; t < n; ++t) {
    for (const int v : mesh.tets[t]) boxes[t].extend(mesh.nodes[v]);
    all.extend(boxes[t]);
  }
  const Vec3 margin = Vec3::Constant(1e-9 * all.diagonal().norm());
  for (Box3& box : boxes) box = Box3(box.min() - margin, box.max() + margin);
  constexpr std::size_t kFew = 50;  // points: looking at every box is quicker than building a tree of them
  std::optional<BoxTree> tree;
  if (points_W.size() > kFew) tree.emplace(boxes);
  std::vector<int> found, near(boxes.size());
  std::iota(near.begin(), near.end(), 0);
  found.reserve(points_W.size());
  for (const Vec3& p : points_W) {
    if (tree) {
      near.clear();
      tree->walk([&](const BoxTree::Node& node) { return BoxTree::squaredDistance(node, p) == 0; },
                 [&](int t) { near.push_back(t); });
      std::sort(near.begin(), near.end());
    }
    int best = -1;
    double bestWeight = kInside;
    for (const int t : near) {
      if (!boxes[t].contains(p)) continue;
      const auto w = barycentricOf(mesh, t, p);
      const double least = *std::min_element(w.begin(), w.end());
      if (least > bestWeight || (best < 0 && least >= kInside)) best = t, bestWeight = least;
    }
    if (best < 0) {
      if (!tree) tree.emplace(boxes);
      best = nearestTet(mesh, *tree, p);
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
