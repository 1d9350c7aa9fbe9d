// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/Penetration.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "simcore/collide/SelfPenetration.h"
#include "simcore/spatial/BoxTree.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/RayParity.h"
#include "simcore/spatial/TrianglePoint.h"

namespace glenoid {
namespace {

bool flagged(const std::vector<char>& skip, int triangle) {
  return triangle < static_cast<int>(skip.size()) && skip[triangle];
}

/// Surface as it lies now, with a tree of its own.
struct Body {
  std::shared_ptr<const CollisionSurface> surface;
  BoxTree tree;
  std::span<const Vec3> x;
  bool finite = false;

  explicit Body(std::shared_ptr<const CollisionSurface> s) : surface(std::move(s)) {
    std::vector<Box3> boxes(surface->triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t) {
      for (const int v : surface->triangles[t]) boxes[t].extend(surface->restVertices[v]);
    }
    tree = BoxTree(boxes);
  }

  std::array<Vec3, 3> corners(int t) const {
    const auto [i, j, k] = surface->triangles[t];
    return {x[i], x[j], x[k]};
  }

  void update(std::span<const Vec3> positions) {
    assert(static_cast<int>(positions.size()) == surface->vertexCount);
    x = positions;
    double sum = 0;
    for (const Vec3& p : x) sum += p.sum();
    finite = std::isfinite(sum) && !tree.empty();
    if (!finite) return;
    for (int t = 0; t < tree.itemCount(); ++t) {
      const auto c = corners(t);
      tree.setBox(t, c[0].cwiseMin(c[1]).cwiseMin(c[2]), c[0].cwiseMax(c[1]).cwiseMax(c[2]));
    }
    tree.refit();
  }

  bool encloses(const Vec3& p) const {
    const BoxTree::Node& root = tree.nodes()[0];
    for (int k = 0; k < 3; ++k) {
      if (p[k] < root.low[k] || p[k] > root.high[k]) return false;
    }
    return enclosedBy(tree, p, [this](int t) { return corners(t); });
  }

  struct Nearest {
    double distance;
    int triangle;
  };
  /// Any triangle that is not further than `enough` will do instead of the nearest.
  Nearest nearest(const Vec3& p, double enough) const {
    int triangle = -1;
    const double best = tree.nearest(
        p, std::numeric_limits<double>::infinity(),
        [&](int t, double bestSoFar) {
          const auto c = corners(t);
          const Vec3 w = nearestBarycentric(p, c[0], c[1], c[2]);
          const double d = (w[0] * c[0] + w[1] * c[1] + w[2] * c[2] - p).squaredNorm();
          if (d < bestSoFar || (d == bestSoFar && t < triangle)) triangle = t;
          return d;
        },
        enough * enough);
    return {std::sqrt(best), triangle};
  }
};

/// Where along an edge (0 at its first vertex, 1 at its second) it passes through the other surface.
struct Crossing {
  int edge;
  double t;
};

/// Which vertices and edges of one side of a pair count.
struct Part {
  std::vector<char> vertex, edge;
};

Part partOf(const CollisionSurface& surface, const std::vector<char>& skip) {
  Part part{std::vector<char>(surface.vertexCount, 0), std::vector<char>(surface.edges.size(), 0)};
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (flagged(skip, t)) continue;
    for (int k = 0; k < 3; ++k)
      part.vertex[surface.triangles[t][k]] = part.edge[surface.triangleEdges[t][k]] = 1;
  }
  return part;
}

}  // namespace

struct PenetrationCheck::Work {
  std::vector<Body> bodies;
  std::vector<CollisionPair> pairs;
  std::vector<std::array<Part, 2>> parts;  ///< by pair
  std::vector<char> used, inside;
  std::array<std::vector<Crossing>, 2> crossings;
  SelfPenetration self;
  Penetration worst;
  std::span<const double> allowed;

  void update(std::span<const std::span<const Vec3>> positions, std::span<const double> free);
  void pair(int index);
  void probe(int pair, const Body& other, const std::vector<char>& skipOther, const Vec3& p);
  void side(int pair, const Body& mine, const Part& part, const Body& other,
            const std::vector<char>& skipOther, std::vector<Crossing>& found);
};

/// Depth of a point that is known to be inside.
void PenetrationCheck::Work::probe(int pair, const Body& other, const std::vector<char>& skipOther,
                                   const Vec3& p) {
  const double free = allowed.empty() ? 0.0 : allowed[static_cast<std::size_t>(pair)];
  const Body::Nearest nearest = other.nearest(p, worst.depth + free);
  if (nearest.distance <= worst.depth + free || flagged(skipOther, nearest.triangle)) return;
  worst = {nearest.distance - free, pair, p};
}

void PenetrationCheck::Work::side(int pair, const Body& mine, const Part& part, const Body& other,
                                  const std::vector<char>& skipOther, std::vector<Crossing>& found) {
  const CollisionSurface& surface = *mine.surface;
  inside.assign(surface.vertexCount, 0);
  for (int v = 0; v < surface.vertexCount; ++v) {
    inside[v] = other.encloses(mine.x[v]);
    if (inside[v] && part.vertex[v]) probe(pair, other, skipOther, mine.x[v]);
  }
  std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.t < b.t;
  });
  std::size_t next = 0;
  for (int e = 0; e < static_cast<int>(surface.edges.size()); ++e) {
    const std::size_t first = next;
    while (next < found.size() && found[next].edge == e) ++next;
    const auto& ends = surface.edges[e].vertices;
    if (!part.edge[e] || (first == next && !(inside[ends[0]] && inside[ends[1]]))) continue;
    const Vec3 &x0 = mine.x[ends[0]], &x1 = mine.x[ends[1]];
    double from = 0;
    for (std::size_t i = first; i <= next; ++i) {
      const double to = i < next ? found[i].t : 1;
      const auto at = [&](double share) -> Vec3 { return x0 + (from + share * (to - from)) * (x1 - x0); };
      if (to > from && other.encloses(at(0.5))) {
        for (const double share : {0.25, 0.5, 0.75}) probe(pair, other, skipOther, at(share));
      }
      from = to;
    }
  }
}

void PenetrationCheck::Work::pair(int index) {
  const CollisionPair& pair = pairs[index];
  const Body &a = bodies[pair.surfaceA], &b = bodies[pair.surfaceB];
  if (pair.self()) {
    if (a.finite) self.look(*a.surface, a.tree, a.x, [&](const Vec3& p, double depth) {
      const double beyond = depth - (allowed.empty() ? 0.0 : allowed[static_cast<std::size_t>(index)]);
      if (beyond > worst.depth) worst = {beyond, index, p};
    });
    return;
  }
  if (!a.finite || !b.finite || !BoxTree::overlap(a.tree.nodes()[0], b.tree.nodes()[0])) return;
  for (auto& list : crossings) list.clear();
  // An edge is tried from its first triangle only, and that may be a skipped one: parts decide afterwards.
  const auto edgesThrough = [](const Body& mine, int tm, const Body& other, int to,
                               std::vector<Crossing>& found) {
    const auto c = other.corners(to);
    for (const int e : mine.surface->triangleEdges[tm]) {
      const CollisionSurface::Edge& edge = mine.surface->edges[e];
      if (edge.triangles[0] != tm) continue;
      const Vec3 &p = mine.x[edge.vertices[0]], &q = mine.x[edge.vertices[1]];
      if (!segmentMeetsTriangle(p, q, c)) continue;
      const Vec3 n = (c[1] - c[0]).cross(c[2] - c[0]);
      const double hp = n.dot(p - c[0]), hq = n.dot(q - c[0]);
      if (hp != hq) found.push_back({e, std::clamp(hp / (hp - hq), 0.0, 1.0)});
    }
  };
  BoxTree::walkPairs(a.tree, b.tree, [&](int ta, int tb) {
    edgesThrough(a, ta, b, tb, crossings[0]);
    edgesThrough(b, tb, a, ta, crossings[1]);
  });
  side(index, a, parts[index][0], b, pair.skipTriangleB, crossings[0]);
  side(index, b, parts[index][1], a, pair.skipTriangleA, crossings[1]);
}

PenetrationCheck::PenetrationCheck(std::vector<std::shared_ptr<const CollisionSurface>> surfaces,
                                   std::vector<CollisionPair> pairs)
    : m_work(std::make_unique<Work>()) {
  Work& w = *m_work;
  w.pairs = std::move(pairs);
  w.used.assign(surfaces.size(), 0);
  for (const auto& surface : surfaces) w.bodies.emplace_back(surface);
  for (const CollisionPair& pair : w.pairs) {
    w.used[pair.surfaceA] = w.used[pair.surfaceB] = 1;
    w.parts.push_back({partOf(*surfaces[pair.surfaceA], pair.skipTriangleA),
                       partOf(*surfaces[pair.surfaceB], pair.skipTriangleB)});
  }
}

PenetrationCheck::~PenetrationCheck() = default;
PenetrationCheck::PenetrationCheck(PenetrationCheck&&) noexcept = default;
PenetrationCheck& PenetrationCheck::operator=(PenetrationCheck&&) noexcept = default;

void PenetrationCheck::Work::update(std::span<const std::span<const Vec3>> positions, std::span<const double> free) {
  assert(positions.size() == bodies.size());
  for (std::size_t s = 0; s < bodies.size(); ++s) {
    if (used[s]) bodies[s].update(positions[s]);
  }
  assert(free.empty() || free.size() == pairs.size());
  allowed = free;
  worst = {};
}

Penetration PenetrationCheck::deepest(std::span<const std::span<const Vec3>> positions, std::span<const double> allowed) {
  Work& w = *m_work;
  w.update(positions, allowed);
  for (int p = 0; p < static_cast<int>(w.pairs.size()); ++p) w.pair(p);
  return w.worst;
}

void PenetrationCheck::eachPair(std::span<const std::span<const Vec3>> positions, std::span<const double> allowed,
                                std::vector<Penetration>& found) {
  Work& w = *m_work;
  w.update(positions, allowed);
  found.resize(w.pairs.size());
  for (int p = 0; p < static_cast<int>(w.pairs.size()); ++p) {
    w.worst = {};
    w.pair(p);
    found[static_cast<std::size_t>(p)] = w.worst;
  }
}

Penetration deepestPenetration(std::span<const std::shared_ptr<const CollisionSurface>> surfaces,
                               std::span<const CollisionPair> pairs,
                               std::span<const std::span<const Vec3>> positions) {
  return PenetrationCheck({surfaces.begin(), surfaces.end()}, {pairs.begin(), pairs.end()})
      .deepest(positions);
}

std::vector<PairIntersections> startIntersections(
    std::span<const std::shared_ptr<const CollisionSurface>> surfaces, std::span<const CollisionPair> pairs,
    std::span<const std::span<const Vec3>> positions) {
  const auto meshOf = [&](int s) {
    return TriMesh{{positions[s].begin(), positions[s].end()}, surfaces[s]->triangles};
  };
  std::vector<PairIntersections> result;
  for (int p = 0; p < static_cast<int>(pairs.size()); ++p) {
    PairIntersections found{p, {}};
    if (pairs[p].self()) {
      found.triangles = selfIntersections(meshOf(pairs[p].surfaceA));
      if (!found.triangles.empty()) result.push_back(std::move(found));
      continue;
    }
    for (const auto& both : intersectingTriangles(meshOf(pairs[p].surfaceA), meshOf(pairs[p].surfaceB))) {
      if (flagged(pairs[p].skipTriangleA, both[0]) || flagged(pairs[p].skipTriangleB, both[1])) continue;
      found.triangles.push_back(both);
    }
    if (!found.triangles.empty()) result.push_back(std::move(found));
  }
  return result;
}

}  // namespace glenoid
