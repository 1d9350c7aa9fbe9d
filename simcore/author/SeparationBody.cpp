// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/SeparationBody.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "simcore/spatial/Intersect.h"

namespace glenoid::separation {

namespace {

constexpr double kStep = 2e-3;        ///< m: no constraint asks for more in one sweep
constexpr double kLook = 3e-3;        ///< m: what is nearer than this to another surface is kept from it
constexpr double kRatioKept = 0.2;    ///< volume ratio below which a step is cut short
constexpr double kRatioHardened = 0.4;

}  // namespace

std::vector<std::array<int, 2>> edgesOf(const TriMesh& mesh) {
  std::vector<std::array<int, 2>> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] < t[(i + 1) % 3]) edges.push_back({t[i], t[(i + 1) % 3]});
  return edges;
}

namespace {

Vec3 normalOf(const TriMesh& mesh, int triangle) {
  const auto& t = mesh.triangles[triangle];
  return (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).normalized();
}

/// Gap and outward direction of a solid at a point near it.
struct Near {
  double gap;  ///< m, negative inside
  Vec3 away;   ///< unit, the way out
  TriangleTree::Closest closest;
};
std::optional<Near> nearOf(const Body& solid, const Vec3& x, double reach) {
  const Box3 wide(solid.box.min().array() - reach, solid.box.max().array() + reach);
  if (!wide.contains(x)) return {};
  const bool inside = solid.box.contains(x) && solid.tree->inside(x);
  const auto closest = inside ? solid.tree->closest(x) : solid.tree->closest(x, reach);
  if (closest.triangle < 0) return {};
  Vec3 away = inside ? Vec3(closest.point - x) : Vec3(x - closest.point);
  if (closest.distance < 1e-9) away = normalOf(solid.surface, closest.triangle);
  return Near{inside ? -closest.distance : closest.distance, away.normalized(), closest};
}

}  // namespace

void wishesAgainst(const Body& body, const Body& other, double clearance, double share, std::vector<Wish>& wishes) {
  const double reach = clearance + kLook;
  const Box3 wide(other.box.min().array() - reach, other.box.max().array() + reach);
  if (!wide.intersects(body.box)) return;
  const auto wish = [&](const std::array<int, 3>& vertex, const Vec3& weight, const Vec3& normal, double gap) {
    wishes.push_back({vertex, weight, normal, std::min(share * (clearance - gap), kStep)});
  };
  // Points of the body against the other as a solid …
  const auto own = [&](const std::array<int, 3>& vertex, const Vec3& weight) {
    Vec3 x = Vec3::Zero();
    for (int k = 0; k < 3; ++k) x += weight[k] * body.surface.vertices[vertex[k]];
    if (const auto near = nearOf(other, x, reach)) wish(vertex, weight, near->away, near->gap);
  };
  for (int v = 0; v < static_cast<int>(body.surface.vertices.size()); ++v) own({v, v, v}, Vec3(1, 0, 0));
  for (const auto& [a, b] : body.edges) own({a, b, b}, Vec3(0.5, 0.5, 0));
  // … and the other's points against the body.
  const auto theirs = [&](const Vec3& y) {
    const auto near = nearOf(body, y, reach);
    if (near) wish(body.surface.triangles[near->closest.triangle], near->closest.barycentric, -near->away, near->gap);
  };
  for (const Vec3& y : other.surface.vertices) theirs(y);
  for (const auto& [a, b] : other.edges) theirs(0.5 * (other.surface.vertices[a] + other.surface.vertices[b]));
  // Triangles that cut each other between all those points.
  if (!other.box.intersects(body.box)) return;
  for (const auto& [mine, its] : intersectingTriangles(body.surface, other.surface))
    wish(body.surface.triangles[mine], Vec3::Constant(1.0 / 3), normalOf(other.surface, its), 0.5 * clearance);
}

namespace {

/// How far a path leads until it leaves a surface for the last time within kFar; −1 where it never does.
constexpr double kFar = 8e-3;
double wayOut(const Body& other, const Vec3& x, const Vec3& side) {
  double exit = -1;
  for (double from = 0; from < kFar;) {
    const auto hit = other.tree->cast(x + from * side, side, kFar - from);
    if (!hit) break;
    from += hit->distance + 1e-6;
    if (hit->normal.dot(side) > 0) exit = from;  // a way out, not a way in
  }
  return exit;
}

}  // namespace

std::array<Vec3, 2> sidesOf(const Body& body, const Body& other) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : body.surface.vertices)
    if (const auto near = nearOf(other, x, kLook); near && near->gap > 0) sum += near->away;
  if (sum.norm() < 1e-9)
    for (const Vec3& x : body.surface.vertices)
      if (const auto near = nearOf(other, x, kLook)) sum += near->away;
  if (sum.norm() < 1e-9) return {Vec3::Zero(), Vec3::Zero()};
  const Vec3 side = sum.normalized();
  double there = 0, back = 0;
  for (const Vec3& x : body.surface.vertices) {
    there += std::max(0.0, wayOut(other, x, side));
    back += std::max(0.0, wayOut(other, x, -side));
  }
  if (back < there) return {-side, side};
  return {side, -side};
}

void wishesToward(const Body& body, const Body& other, const Vec3& side, double clearance, std::vector<Wish>& wishes) {
  const auto own = [&](const std::array<int, 3>& vertex, const Vec3& weight) {
    Vec3 x = Vec3::Zero();
    for (int k = 0; k < 3; ++k) x += weight[k] * body.surface.vertices[vertex[k]];
    const double exit = wayOut(other, x, side);
    if (exit >= 0) wishes.push_back({vertex, weight, side, std::min(exit + clearance, kStep)});
  };
  for (int v = 0; v < static_cast<int>(body.surface.vertices.size()); ++v) own({v, v, v}, Vec3(1, 0, 0));
  for (const auto& [a, b] : body.edges) own({a, b, b}, Vec3(0.5, 0.5, 0));
}

// Newton on ½ uᵀ K u + ½ µ Σ max(0, …)².
VecX leastEnergy(const Body& body, const std::vector<Wish>& wishes, double penalty) {
  const VecX now = body.caged->shifts();
  const auto rows = static_cast<Eigen::Index>(wishes.size());
  MatX J(rows, now.size());
  VecX goal(rows);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const Wish& wish = wishes[r];
    Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(body.caged->handleCount());
    for (int k = 0; k < 3; ++k)
      if (wish.weight[k] != 0) weights += wish.weight[k] * body.caged->collisionWeights(wish.vertex[k]);
    for (int j = 0; j < body.caged->handleCount(); ++j) J.block<1, 3>(r, 3 * j) = weights[j] * wish.normal.transpose();
    goal[r] = J.row(r).dot(now) + wish.amount;
  }
  VecX u = now;
  std::vector<char> active(rows, 0);
  for (int iteration = 0; iteration < 8; ++iteration) {
    const VecX reached = J * u;
    bool same = iteration > 0;
    Eigen::Index count = 0;
    for (Eigen::Index r = 0; r < rows; ++r) {
      const char on = reached[r] < goal[r];
      same = same && on == active[r];
      active[r] = on;
      count += on;
    }
    if (same) break;
    if (count == 0) {
      u.setZero();
      continue;
    }
    MatX some(count, now.size());
    VecX wanted(count);
    for (Eigen::Index r = 0, k = 0; r < rows; ++r)
      if (active[r]) some.row(k) = J.row(r), wanted[k++] = goal[r];
    MatX A = body.stiffness;
    A.selfadjointView<Eigen::Lower>().rankUpdate(some.transpose(), penalty);
    u = A.selfadjointView<Eigen::Lower>().llt().solve(penalty * some.transpose() * wanted);
    if (!u.allFinite()) return now;
  }
  return u;
}

void take(Body& body, const VecX& goal) {
  const VecX now = body.caged->shifts();
  for (double share = 1; share > 0.05; share *= 0.5) {
    body.caged->setShifts(now + share * (goal - now));
    const std::vector<double> ratios = body.caged->volumeRatios();
    const double least = *std::min_element(ratios.begin(), ratios.end());
    if (least < kRatioHardened) {
      for (std::size_t t = 0; t < ratios.size(); ++t)
        if (ratios[t] < kRatioHardened) body.hardness[t] = std::min(100.0, 1.5 * body.hardness[t]);
      body.stiffness = body.caged->stiffness(body.hardness);
    }
    if (least >= kRatioKept) {
      body.surface = body.caged->collision();
      body.refresh();
      return;
    }
  }
  body.caged->setShifts(now);
}

Result<Done> putInCage(Body& body, const Cage& cage) {
  auto caged = CagedPart::make(*body.part, cage);
  if (!caged) return caged.error();
  body.caged.emplace(std::move(*caged));
  body.hardness.assign(body.part->volume->tets.size(), 1);
  body.stiffness = body.caged->stiffness();
  body.surface = body.caged->collision();
  body.refresh();
  return Done{};
}

}  // namespace glenoid::separation
