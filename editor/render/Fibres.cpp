// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Fibres.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace glenoid {
namespace {

constexpr int kSlices = 12;

/// Middle of a slice, its directions (`way` along the fibres) and its half width.
struct Slice {
  Vec3 at, way, wide, thin;
  double half = 0;  ///< m
};
using Spine = std::array<Slice, kSlices>;

/// Place of a point on a line of slices, in slices from the first; beyond its ends the last leg goes on.
double placeOn(const Spine& spine, const Vec3& x) {
  double best = 1e300, place = 0;
  for (int i = 0; i + 1 < kSlices; ++i) {
    const Vec3 leg = spine[i + 1].at - spine[i].at;
    const double length2 = leg.squaredNorm();
    if (!(length2 > 0)) continue;
    const double low = i == 0 ? -1e3 : 0, high = i + 2 == kSlices ? 1e3 : 1;
    const double t = std::clamp(leg.dot(x - spine[i].at) / length2, low, high);
    const double d = (spine[i].at + t * leg - x).squaredNorm();
    if (d < best) best = d, place = i + t;
  }
  return place;
}

Slice between(const Spine& spine, double place) {
  const int i = std::clamp(static_cast<int>(std::floor(place)), 0, kSlices - 2);
  const double t = place - i, w = std::clamp(t, 0.0, 1.0);
  const Slice &a = spine[i], &b = spine[i + 1];
  return {a.at + t * (b.at - a.at), ((1 - w) * a.way + w * b.way).normalized(), ((1 - w) * a.wide + w * b.wide).normalized(), ((1 - w) * a.thin + w * b.thin).normalized(),
          (1 - w) * a.half + w * b.half};
}

/// The same with directions that turn evenly: no two places across a bend become one.
double evenPlaceOn(const Spine& spine, const Vec3& x, double place) {
  const double step = (spine[kSlices - 1].at - spine[0].at).norm() / (kSlices - 1);
  for (int round = 0; round < 60; ++round) {
    const Slice slice = between(spine, place);
    place += 0.6 * (x - slice.at).dot(slice.way) / step;
  }
  return place;
}

/// Lays the line as the parabola that fits the vertices best at their places; the places are stretched to its length first.
void fit(const TriMesh& mesh, std::vector<double>& place, Spine& spine) {
  const auto [low, high] = std::minmax_element(place.begin(), place.end());
  const double first = *low, scale = (kSlices - 1) / std::max(*high - first, 1e-9);
  Mat3 left = Mat3::Zero();
  Mat3 right = Mat3::Zero();
  const auto powers = [](double s) { return Vec3(1, s, s * s); };
  for (std::size_t v = 0; v < place.size(); ++v) {
    place[v] = (place[v] - first) * scale;
    const Vec3 p = powers(place[v] / (kSlices - 1));
    left += p * p.transpose();
    right += p * mesh.vertices[v].transpose();
  }
  left.diagonal().array() += 1e-9 * static_cast<double>(place.size());  // places may all be one
  const Mat3 parabola = left.ldlt().solve(right);
  for (int k = 0; k < kSlices; ++k) spine[k].at = parabola.transpose() * powers(k / (kSlices - 1.0));
}

void orient(const TriMesh& mesh, const std::vector<double>& place, Spine& spine) {
  for (int k = 0; k < kSlices; ++k) {
    const Vec3 way = (spine[std::min(k + 1, kSlices - 1)].at - spine[std::max(k - 1, 0)].at).normalized();
    Mat3 spread = Mat3::Zero();
    double weight = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const double w = std::max(0.0, 1 - 0.5 * std::abs(place[v] - k));
      Vec3 d = mesh.vertices[v] - spine[k].at;
      d -= d.dot(way) * way;
      spread += w * d * d.transpose();
      weight += w;
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(spread);
    Vec3 wide = solver.eigenvectors().col(2);
    if (k > 0) {
      const Vec3& last = spine[k - 1].wide;
      // A round slice has no widest direction: the last one's is carried on.
      const double round = solver.eigenvalues()[1] / std::max(solver.eigenvalues()[2], 1e-30);
      if (wide.dot(last) < 0) wide = -wide;
      wide = ((1 - round) * wide + round * last).normalized();
    }
    wide = (wide - wide.dot(way) * way).normalized();
    spine[k].way = way;
    spine[k].wide = wide;
    spine[k].thin = way.cross(wide);
    spine[k].half = weight > 0 ? std::sqrt(spread.trace() / weight) : 0;
  }
}

}  // namespace

bool layFibres(const TriMesh& mesh, const Vec3& from, const Vec3& end, double beyond, Tissue& tissue) {
  const Vec3 apex = end + beyond * (end - from);
  const double reach = (from - apex).norm();
  if (!(reach > 1e-6)) return false;
  const Vec3 axis = (from - apex) / reach;
  Mat3 spread = Mat3::Zero();
  for (const Vec3& x : mesh.vertices) {
    const Vec3 d = x - apex, aside = d - d.dot(axis) * axis;
    spread += aside * aside.transpose();
  }
  const Vec3 wide = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(2);
  const Vec3 thin = axis.cross(wide);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vec3 d = mesh.vertices[v] - apex;
    TissueVertex& out = tissue.vertices[v];
    // The angle in the fan, as an arc at the middle's distance: bundles keep their number and narrow to the end.
    out.across = static_cast<float>(reach * std::atan2(d.dot(wide), std::max(d.dot(axis), 0.05 * reach)));
    out.through = static_cast<float>(d.dot(thin));
    out.along = static_cast<float>(d.dot(axis));
  }
  return true;
}

bool layCurvedFibres(const TriMesh& mesh, const Vec3& from, const Vec3& end, Tissue& tissue) {
  const double length = (end - from).norm();
  if (!(length > 1e-6)) return false;
  Spine spine;
  for (int k = 0; k < kSlices; ++k) spine[k].at = from + (end - from) * k / (kSlices - 1);
  std::vector<double> place(mesh.vertices.size());
  for (int round = 0; round < 6; ++round) {
    for (std::size_t v = 0; v < place.size(); ++v) place[v] = placeOn(spine, mesh.vertices[v]);
    fit(mesh, place, spine);
  }
  for (std::size_t v = 0; v < place.size(); ++v) place[v] = placeOn(spine, mesh.vertices[v]);
  orient(mesh, place, spine);
  for (std::size_t v = 0; v < place.size(); ++v) place[v] = evenPlaceOn(spine, mesh.vertices[v], place[v]);
  double widest = 0, step = 0;
  for (const Slice& slice : spine) widest = std::max(widest, slice.half);
  for (int k = 0; k + 1 < kSlices; ++k) step += (spine[k + 1].at - spine[k].at).norm() / (kSlices - 1);
  for (std::size_t v = 0; v < place.size(); ++v) {
    const Slice slice = between(spine, place[v]);
    const Vec3 d = mesh.vertices[v] - slice.at;
    TissueVertex& out = tissue.vertices[v];
    out.across = static_cast<float>(d.dot(slice.wide) * widest / std::max(slice.half, 0.2 * widest));
    out.through = static_cast<float>(d.dot(slice.thin));
    out.along = static_cast<float>(-step * place[v]);
  }
  return true;
}

}  // namespace glenoid
