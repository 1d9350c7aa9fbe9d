// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/SeparateStart.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "simcore/author/CagedPart.h"
#include "simcore/author/MakeCage.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

constexpr double kStep = 2e-3;        ///< m: no constraint asks for more in one sweep
constexpr double kLook = 3e-3;        ///< m: what is nearer than this to another surface is kept from it
// Penalty of a constraint, against a stiffness whose mean diagonal is one: small at first, so that a part moves as a whole
// before it is dented.
constexpr double kFirstPenalty = 5, kLastPenalty = 2e3;
constexpr int kPenaltySweeps = 12;
constexpr double kRatioKept = 0.2;    ///< volume ratio below which a step is cut short
constexpr double kRatioHardened = 0.4;

/// A wish of one point of a part's surface: n · Δx ≥ amount.
struct Wish {
  std::array<int, 3> vertex;
  Vec3 weight;
  Vec3 normal;
  double amount;
};

/// One part while things are moved.
struct Body {
  const Part* part = nullptr;
  TriMesh surface;
  std::unique_ptr<TriangleTree> tree;
  Box3 box;
  std::vector<std::array<int, 2>> edges;
  std::optional<CagedPart> caged;  ///< only where the cage may move
  std::vector<double> hardness;
  MatX stiffness;

  void refresh() {
    tree = std::make_unique<TriangleTree>(surface);
    box = boundsOf(surface);
  }
};

std::vector<std::array<int, 2>> edgesOf(const TriMesh& mesh) {
  std::vector<std::array<int, 2>> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] < t[(i + 1) % 3]) edges.push_back({t[i], t[(i + 1) % 3]});
  return edges;
}

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

/// What the surface of `body` must do to keep `clearance` to `other`; `share`: the part of it that it does itself.
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

/// Ways by which a thin body that another cuts through can come to lie on one side of it: out of `other` on the side of
/// most of the body's points near it, and the opposite; the one with less to go first.
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

/// As wishesAgainst, but all points go the same way: each whose path along `side` still meets the other's surface within
/// kFar goes to where that path leaves it.
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

/// Handle shifts of least energy that fulfil the wishes, as far as the penalty goes: Newton on ½ uᵀ K u + ½ µ Σ max(0, …)².
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

/// Takes the step as far as no tetrahedron is squeezed too much; what is squeezed gets harder.
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

class Separation {
 public:
  Separation(Joint& joint, const StartWishes& wishes, const SeparationProgress& progress)
      : m_joint(joint), m_wishes(wishes), m_progress(progress), m_pairs(pairsThatMayCollide(joint)) {}

  Result<SeparationOutcome> run() {
    if (const auto made = begin(); !made) return made.error();
    SeparationOutcome outcome;
    std::vector<Overlap> overlaps = measure();
    outcome.overlapsBefore = static_cast<int>(overlaps.size());
    for (const Overlap& overlap : overlaps) outcome.depthBefore = std::max(outcome.depthBefore, overlap.depth);
    int handles = m_wishes.handles;
    for (int round = 0; round <= m_wishes.refinements && !overlaps.empty(); ++round, handles *= 2) {
      if (const auto caged = cageThose(overlaps, handles, round > 0); !caged) return caged.error();
      for (int sweep = 0; sweep < m_wishes.iterations && !overlaps.empty(); ++sweep, ++outcome.sweeps) {
        const double done = static_cast<double>(outcome.sweeps) / (m_wishes.iterations * (1 + m_wishes.refinements));
        if (m_progress && !m_progress(done, static_cast<int>(overlaps.size())))
          return Error{Fault::Cancelled, {}, {}, "separating the start"};
        if (!sweepOnce(std::min(kLastPenalty, kFirstPenalty * std::pow(kLastPenalty / kFirstPenalty, sweep / double(kPenaltySweeps))))) break;
        overlaps = measure();
        chooseSides(overlaps);
        // Whoever was pushed into a part without a cage gets company.
        if (const auto caged = cageThose(overlaps, handles, false); !caged) return caged.error();
      }
    }
    finish(outcome);
    auto check = checkStart(m_joint);
    if (!check) return check.error();
    outcome.check = std::move(*check);
    m_joint.startProof = outcome.check.proof;
    return outcome;
  }

 private:
  bool mayMove(const Part& part) const {
    if (part.kind != PartKind::Soft) return false;
    return m_wishes.parts.empty() || std::find(m_wishes.parts.begin(), m_wishes.parts.end(), part.id) != m_wishes.parts.end();
  }

  Result<Done> begin() {
    for (const std::string& id : m_wishes.parts)
      if (findPart(m_joint, id) < 0) return Error{Fault::UnknownId, {}, {id, "part"}, "separating the start"};
    m_bodies.resize(m_joint.parts.size());
    auto surfaces = startSurfaces(m_joint, SurfaceKind::Collision);
    if (!surfaces) return surfaces.error();
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
      Body& body = m_bodies[i];
      body.part = &m_joint.parts[i];
      body.surface = std::move((*surfaces)[i]);
      body.edges = edgesOf(body.surface);
      body.refresh();
      const Cage* cage = findCage(m_joint, body.part->id);
      if (!cage || !mayMove(*body.part)) continue;
      if (const auto put = putInCage(body, *cage); !put) return put.error();
    }
    return Done{};
  }

  std::vector<Overlap> measure() const {
    std::vector<TriMesh> surfaces;
    for (const Body& body : m_bodies) surfaces.push_back(body.surface);
    return findOverlaps(m_joint, surfaces);
  }

  /// Gives parts of overlaps a cage; with `finer` also those that have one. A finer cage begins at rest: what the
  /// coarse one did would stay in it as a form that nothing asks for.
  Result<Done> cageThose(const std::vector<Overlap>& overlaps, int handles, bool finer) {
    std::vector<char> wanted(m_bodies.size(), 0);
    for (const Overlap& overlap : overlaps) wanted[overlap.partA] = wanted[overlap.partB] = 1;
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
      Body& body = m_bodies[i];
      if (!wanted[i] || !mayMove(*body.part) || (body.caged && !finer)) continue;
      if (body.caged && findCage(m_joint, body.part->id)) continue;  // the author's own stays as it was drawn
      const auto cage = makeCage(*body.part, std::min(handles, 2000));
      if (!cage) return cage.error();
      if (const auto put = putInCage(body, *cage); !put) return put.error();
    }
    return Done{};
  }

  /// False when nothing could move.
  bool sweepOnce(double penalty) {
    bool any = false;
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
      Body& body = m_bodies[i];
      if (!body.caged) continue;
      std::vector<Wish> wishes;
      for (const auto& [a, b] : m_pairs) {
        if (a != static_cast<int>(i) && b != static_cast<int>(i)) continue;
        const int o = a == static_cast<int>(i) ? b : a;
        const Body& other = m_bodies[o];
        const auto stuck = m_stuck.find({a, b});
        if (stuck != m_stuck.end() && stuck->second.mover == o) continue;
        if (stuck != m_stuck.end() && stuck->second.mover == static_cast<int>(i)) {
          const std::size_t before = wishes.size();
          wishesToward(body, other, stuck->second.side, m_wishes.clearance, wishes);
          if (wishes.size() > before) continue;
        }
        wishesAgainst(body, other, m_wishes.clearance, other.caged ? 0.5 : 1.0, wishes);
      }
      if (wishes.empty()) continue;
      any = true;
      take(body, leastEnergy(body, wishes, penalty));
    }
    return any;
  }

  /// Of two soft parts that stay in each other's way the thinner one has to come to one side of the other: first to the
  /// side to which there is less to go, then to the opposite one.
  void chooseSides(const std::vector<Overlap>& overlaps) {
    constexpr int kPatience = 10, kTry = 30;
    std::map<std::array<int, 2>, Stuck> still;
    for (const Overlap& overlap : overlaps) {
      const std::array<int, 2> pair{overlap.partA, overlap.partB};
      Stuck stuck = m_stuck[pair];
      ++stuck.sweeps;
      const Body &a = m_bodies[pair[0]], &b = m_bodies[pair[1]];
      if (a.caged && b.caged && stuck.sweeps % kTry == kPatience) {
        const bool first = thicknessOf(*a.part->collision) < thicknessOf(*b.part->collision);
        const auto sides = first ? sidesOf(a, b) : sidesOf(b, a);
        if (sides[0].norm() > 0) {
          stuck.side = stuck.tries++ == 0 ? sides[0] : Vec3(-stuck.side);
          stuck.mover = pair[first ? 0 : 1];
        }
      }
      still[pair] = stuck;
    }
    m_stuck = std::move(still);
  }
  static double thicknessOf(const TriMesh& mesh) { return 2 * enclosedVolume(mesh) / healthOf(mesh).area; }

  void finish(SeparationOutcome& outcome) {
    for (const Body& body : m_bodies) {
      if (!body.caged) continue;
      double most = 0;
      for (std::size_t v = 0; v < body.surface.vertices.size(); ++v)
        most = std::max(most, (body.surface.vertices[v] - body.part->collision->vertices[v]).norm());
      if (most < 1e-9 && !findCage(m_joint, body.part->id)) continue;
      outcome.maxShift = std::max(outcome.maxShift, most);
      outcome.movedParts.push_back(body.part->id);
      outcome.shifts.push_back(most);
      putCage(m_joint, body.caged->cage());
    }
  }

  /// A pair that overlaps for some sweeps by now.
  struct Stuck {
    int sweeps = 0, tries = 0;
    int mover = -1;  ///< body that goes to one side; −1: both as it comes
    Vec3 side = Vec3::Zero();
  };

  Joint& m_joint;
  const StartWishes& m_wishes;
  const SeparationProgress& m_progress;
  std::vector<std::array<int, 2>> m_pairs;
  std::vector<Body> m_bodies;
  std::map<std::array<int, 2>, Stuck> m_stuck;
};

}  // namespace

Result<SeparationOutcome> separateStart(Joint& joint, const StartWishes& wishes, const SeparationProgress& progress) {
  if (!(wishes.clearance > 0) || !std::isfinite(wishes.clearance))
    return Error{Fault::OutOfRange, {}, {std::to_string(wishes.clearance), "0", "inf"}, "clearance of the start"};
  Joint copy = joint;
  auto outcome = Separation(copy, wishes, progress).run();
  if (outcome) joint = std::move(copy);
  return outcome;
}

}  // namespace glenoid
