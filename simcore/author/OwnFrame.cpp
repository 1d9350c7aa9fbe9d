// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/OwnFrame.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace glenoid {
namespace {

/// What is smaller than this beside the size is taken for rounding, the author's program's included (float files).
constexpr double kEven = 1e-5;
constexpr int kGridBits = 24;  ///< of the size: 7 nm for a joint of 10 cm

/// A place on a surface and the share of the area that stands for it.
struct Sample {
  Vec3 x;
  double area;
  double part;  ///< place in the list, from 1
};

/// Midpoints of edges: exact for second moments.
std::vector<Sample> samplesOf(const std::vector<std::shared_ptr<const TriMesh>>& surfaces) {
  std::vector<Sample> samples;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (!surfaces[s]) continue;
    const auto& v = surfaces[s]->vertices;
    for (const auto& t : surfaces[s]->triangles) {
      const double third = (v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]).norm() / 6;
      for (int k = 0; k < 3; ++k) samples.push_back({(v[t[k]] + v[t[(k + 1) % 3]]) / 2, third, static_cast<double>(s + 1)});
    }
  }
  return samples;
}

/// Without negative zeros, which are the other side of a rounding.
Vec3 roundedTo(double grid, const Vec3& x) { return grid > 0 ? Vec3((x / grid).array().round() * grid + 0.0) : x; }

/// The principal axes, largest extent first. Where extents are alike any axes of their plane or space would do: then those
/// that point to what is lopsided, else those nearest to the axes of W.
Mat3 axesOf(const Mat3& spread, const std::vector<Vec3>& hints) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(spread);
  Mat3 axes = solver.eigenvectors().rowwise().reverse();
  const Vec3 extent = solver.eigenvalues().reverse();
  const double size = std::sqrt(spread.trace());
  for (int first = 0, last = 0; first < 3; first = ++last) {
    while (last < 2 && extent[last] - extent[last + 1] < kEven * size * size) ++last;
    if (last == first) continue;
    const MatX alike = axes.block(0, first, 3, last - first + 1);
    int next = first;
    const auto offer = [&](const Vec3& wish, double least) {
      Vec3 axis = alike * (alike.transpose() * wish);
      for (int k = first; k < next; ++k) axis -= axes.col(k) * axes.col(k).dot(axis);
      if (next <= last && axis.norm() > least) axes.col(next++) = axis.normalized();
    };
    for (const Vec3& hint : hints) offer(hint, kEven * size);
    for (int k = 0; k < 3; ++k) offer(Vec3::Unit(k), 0.1);  // the squares of what is left of them sum to one or more
  }
  return axes;
}

}  // namespace

OwnFrame ownFrameOf(const std::vector<std::shared_ptr<const TriMesh>>& surfaces) {
  const std::vector<Sample> samples = samplesOf(surfaces);
  double area = 0;
  Vec3 centre = Vec3::Zero();
  for (const Sample& s : samples) area += s.area, centre += s.area * s.x;
  if (!(area > 0) || !centre.allFinite()) return {};
  centre /= area;
  double parts = 0;
  Mat3 spread = Mat3::Zero();
  Vec3 byPart = Vec3::Zero(), outwards = Vec3::Zero();
  for (const Sample& s : samples) parts += s.area * s.part / area;
  for (const Sample& s : samples) {
    const Vec3 d = s.x - centre;
    spread += s.area / area * d * d.transpose();
    byPart += s.area / area * (s.part - parts) * d;
    outwards += s.area / area * d.squaredNorm() * d;
  }
  const double size = std::sqrt(spread.trace());
  if (!(size > 0)) return {};
  outwards /= size * size;
  const Mat3 axes = axesOf(spread, {byPart, outwards});
  OwnFrame frame;
  for (int k = 0; k < 3; ++k) {
    Vec3 axis = axes.col(k);
    double lopsided = axis.dot(byPart);
    if (std::abs(lopsided) < kEven * size) {
      lopsided = 0;
      for (const Sample& s : samples) {
        const double d = axis.dot(s.x - centre) / size;
        lopsided += s.area / area * d * d * d * size;
      }
    }
    if (std::abs(lopsided) < kEven * size) {  // alike on both sides
      int largest = 0;
      axis.cwiseAbs().maxCoeff(&largest);
      lopsided = axis[largest];
    }
    frame.own_W.R.row(k) = (lopsided < 0 ? -axis : axis).transpose();
  }
  frame.own_W.t = -(frame.own_W.R * centre);
  int exponent = 0;
  std::frexp(size, &exponent);
  frame.grid = std::ldexp(1.0, exponent - kGridBits);
  return frame;
}

OwnFrame ownFrameOf(const Joint& joint) {
  std::vector<std::shared_ptr<const TriMesh>> surfaces;
  for (const Part& part : joint.parts) surfaces.push_back(part.visual);
  return ownFrameOf(surfaces);
}

TriMesh OwnFrame::toOwn(const TriMesh& mesh_W) const {
  TriMesh own = movedMesh(mesh_W, own_W);
  for (Vec3& vertex : own.vertices) vertex = roundedTo(grid, vertex);
  return own;
}

Joint OwnFrame::toOwn(const Joint& joint) const {
  Joint own = joint;
  own.startProof.reset();
  for (Part& part : own.parts) part.dents.reset();
  own = movedJoint(own, own_W);
  for (Part& part : own.parts) {
    for (auto* surface : {&part.visual, &part.collision}) {
      if (!*surface) continue;
      TriMesh rounded = **surface;
      for (Vec3& vertex : rounded.vertices) vertex = roundedTo(grid, vertex);
      *surface = std::make_shared<const TriMesh>(std::move(rounded));
    }
    if (!part.volume) continue;
    TetMesh rounded = *part.volume;
    for (Vec3& node : rounded.nodes) node = roundedTo(grid, node);
    part.volume = std::make_shared<const TetMesh>(std::move(rounded));
  }
  for (Cage& cage : own.cages)
    for (auto* handles : {&cage.rest_W, &cage.moved_W})
      for (Vec3& handle : *handles) handle = roundedTo(grid, handle);
  return own;
}

TriMesh inOwnOrder(const TriMesh& mesh) {
  std::vector<int> order(mesh.vertices.size()), place(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  });
  TriMesh out;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = static_cast<int>(i);
    out.vertices.push_back(mesh.vertices[order[i]]);
  }
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> own{place[t[0]], place[t[1]], place[t[2]]};
    std::rotate(own.begin(), std::min_element(own.begin(), own.end()), own.end());
    out.triangles.push_back(own);
  }
  std::sort(out.triangles.begin(), out.triangles.end());
  return out;
}

}  // namespace glenoid
