// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "simcore/base/PlainMath.h"
#include "simcore/embed/Bind.h"
#include "simcore/embed/CageWeights.h"
#include "simcore/embed/Cells.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

/// Barycentric coordinates of a point of a triangle, made positive.
Vec3 inTriangle(const TriMesh& mesh, int triangle, const Vec3& p) {
  const auto& t = mesh.triangles[triangle];
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const Vec3 n = (b - a).cross(c - a);
  const double area = n.squaredNorm();
  if (!(area > 0)) return Vec3(1, 0, 0);
  Vec3 w((b - p).cross(c - p).dot(n), (c - p).cross(a - p).dot(n), (a - p).cross(b - p).dot(n));
  w = (w / area).cwiseMax(0);
  return w / w.sum();
}

/// ∇ of the four hat functions of a tetrahedron, as columns.
Mat34 gradientsOf(const TetMesh& mesh, int tet) {
  const auto& t = mesh.tets[tet];
  Mat3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = mesh.nodes[t[i + 1]] - mesh.nodes[t[0]];
  const Mat3 inverse = edges.inverse().transpose();
  Mat34 gradients;
  gradients.rightCols<3>() = inverse;
  gradients.col(0) = -inverse.rowwise().sum();
  return gradients;
}

}  // namespace

Result<MatX> harmonicCoordinates(const TriMesh& cage, std::span<const Vec3> points) {
  // About fourteen cells across the mean extent resolve what a hundred handles can say.
  const Vec3 extent = boundsOf(cage).sizes();
  auto grid = embedInCells(cage, cage, plain::cubeRoot(extent.prod()) / 14);
  if (!grid) return grid.error();
  const int n = static_cast<int>(grid->nodes.size()), handles = static_cast<int>(cage.vertices.size());

  const TriangleTree tree(cage);
  std::vector<char> onBoundary(n, 0);
  for (const auto& t : boundaryOf(*grid).triangles)
    for (const int node : t) onBoundary[node] = 1;
  std::vector<int> unknown(n, -1);
  int unknowns = 0;
  for (int i = 0; i < n; ++i)
    if (!onBoundary[i] && tree.inside(grid->nodes[i])) unknown[i] = unknowns++;
  MatX values = MatX::Zero(n, handles);
  for (int i = 0; i < n; ++i) {
    if (unknown[i] >= 0) continue;
    const auto near = tree.closest(grid->nodes[i]);
    const Vec3 w = inTriangle(cage, near.triangle, near.point);
    for (int k = 0; k < 3; ++k) values(i, cage.triangles[near.triangle][k]) += w[k];
  }

  std::vector<Eigen::Triplet<double>> entries;
  MatX right = MatX::Zero(unknowns, handles);
  for (int tet = 0; tet < static_cast<int>(grid->tets.size()); ++tet) {
    const Mat34 g = gradientsOf(*grid, tet);
    const Eigen::Matrix4d k = g.transpose() * g * tetVolume(*grid, tet);
    const auto& t = grid->tets[tet];
    for (int i = 0; i < 4; ++i) {
      if (unknown[t[i]] < 0) continue;
      for (int j = 0; j < 4; ++j) {
        if (unknown[t[j]] >= 0)
          entries.emplace_back(unknown[t[i]], unknown[t[j]], k(i, j));
        else
          right.row(unknown[t[i]]) -= k(i, j) * values.row(t[j]);
      }
    }
  }
  if (unknowns > 0) {
    Eigen::SparseMatrix<double> laplacian(unknowns, unknowns);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplacian);
    if (solver.info() != Eigen::Success)
      return Error{Fault::BadMesh, {}, {"the cage encloses no volume"}, "harmonic coordinates"};
    const MatX inside = solver.solve(right);
    for (int i = 0; i < n; ++i)
      if (unknown[i] >= 0) values.row(i) = inside.row(unknown[i]);
  }

  const std::vector<VertexBinding> bound = bindToTets(*grid, points);
  MatX weights = MatX::Zero(static_cast<Eigen::Index>(points.size()), handles);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto row = static_cast<Eigen::Index>(p);
    for (int k = 0; k < 4; ++k)  // a point outside the cage takes what is at its edge: extrapolation could turn it over
      weights.row(row) += std::max(0.0, bound[p].weight[k]) * values.row(bound[p].node[k]);
    weights.row(row) /= weights.row(row).sum();
  }
  return weights;
}

}  // namespace glenoid
