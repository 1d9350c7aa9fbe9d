// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/Fill.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "simcore/embed/SignedPrisms.h"

namespace glenoid {

namespace {

/// Gives `take(tet, sign, corners, piece)` all signed pieces of all tetrahedra, relative to a point near the part.
template <class Take>
void forEachPiece(const TetMesh& mesh, const TriMesh& closed, Take&& take) {
  if (mesh.tets.empty()) return;
  const Vec3 origin = mesh.nodes[mesh.tets[0][0]];  // near the part, to keep digits
  SignedPrisms prisms(closed, origin);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    Tet4 tet;
    for (int k = 0; k < 4; ++k) tet[k] = mesh.nodes[mesh.tets[i][k]] - origin;
    prisms.visit(tet, [&](double sign, const Tet4& piece) { take(i, sign, tet, piece); });
  }
}

}  // namespace

std::vector<double> enclosedVolumes(const TetMesh& mesh, const TriMesh& closed) {
  std::vector<double> volumes(mesh.tets.size(), 0.0);
  forEachPiece(mesh, closed, [&](std::size_t i, double sign, const Tet4&, const Tet4& piece) { volumes[i] += sign * volumeOf(piece); });
  return volumes;
}

std::vector<Eigen::Matrix4d> enclosedMoments(const TetMesh& mesh, const TriMesh& closed) {
  // Second moments (1, y) (1, y)ᵀ in y = D⁻¹ (x − x0), the last three barycentric coordinates.
  std::vector<Eigen::Matrix4d> moments(mesh.tets.size(), Eigen::Matrix4d::Zero());
  std::vector<Mat3> inverse(mesh.tets.size());
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    Mat3 D;
    for (int k = 0; k < 3; ++k) D.col(k) = mesh.nodes[mesh.tets[i][k + 1]] - mesh.nodes[mesh.tets[i][0]];
    inverse[i] = D.inverse();
  }
  forEachPiece(mesh, closed, [&](std::size_t i, double sign, const Tet4& tet, const Tet4& piece) {
    // Over a tetrahedron with corners b_k: ∫ f fᵀ = V/20 (Σ f(b_k) f(b_k)ᵀ + (Σ f(b_k)) (Σ f(b_k))ᵀ) for affine f.
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    Vec4 all = Vec4::Zero();
    for (const Vec3& corner : piece) {
      Vec4 f;
      f << 1, inverse[i] * (corner - tet[0]);
      sum += f * f.transpose();
      all += f;
    }
    moments[i] += sign * volumeOf(piece) / 20 * (sum + all * all.transpose());
  });
  Eigen::Matrix4d toWeights = Eigen::Matrix4d::Identity();
  toWeights.block<1, 3>(0, 1).setConstant(-1);
  for (Eigen::Matrix4d& m : moments) m = (toWeights * m * toWeights.transpose()).eval();
  return moments;
}

std::vector<double> fillFractions(const TetMesh& mesh, const TriMesh& closed) {
  return fillFractions(mesh, enclosedVolumes(mesh, closed));
}

std::vector<double> fillFractions(const TetMesh& mesh, std::span<const double> enclosed) {
  const std::size_t n = mesh.tets.size();
  std::vector<double> fill(n), whole(n);
  double wanted = 0;
  for (std::size_t i = 0; i < n; ++i) {
    whole[i] = std::abs(tetVolume(mesh, static_cast<int>(i)));
    fill[i] = whole[i] > 0 ? std::clamp(enclosed[i] / whole[i], 0.0, 1.0) : 0.0;
    wanted += fill[i] * whole[i];
  }
  // Scaling the rest down may push further ones below the floor, hence the loop; each turn fixes one at
  // least.
  std::vector<char> floored(n, 0);
  double scale = 1;
  for (bool changed = true; changed;) {
    changed = false;
    double fixed = 0, rest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!floored[i] && scale * fill[i] < kFillFloor) floored[i] = 1, changed = true;
      (floored[i] ? fixed : rest) += floored[i] ? kFillFloor * whole[i] : fill[i] * whole[i];
    }
    scale = rest > 0 ? std::clamp((wanted - fixed) / rest, 0.0, 1.0) : 0.0;
  }
  for (std::size_t i = 0; i < n; ++i) fill[i] = floored[i] ? kFillFloor : scale * fill[i];
  return fill;
}

}  // namespace glenoid
