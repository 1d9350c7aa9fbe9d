// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <set>
#include <unordered_set>

#include "simcore/repair/Cracks.h"
#include "simcore/repair/Edges.h"
#include "simcore/repair/Topology.h"
#include "simcore/repair/Weld.h"

namespace glenoid {
namespace {

std::uint64_t edgeKey(int a, int b) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

/// Triangles of least area over a rim, none across an edge that the surface has already; false when there is no way.
bool leastArea(const TriMesh& mesh, const std::vector<int>& loop, const std::unordered_set<std::uint64_t>& edges, Triangles& lid) {
  const int n = static_cast<int>(loop.size());
  std::vector<double> cost(static_cast<std::size_t>(n) * n, 0);
  std::vector<int> split(static_cast<std::size_t>(n) * n, -1);
  const auto at = [n](int i, int j) { return static_cast<std::size_t>(i) * n + j; };
  const auto free = [&](int i, int j) {  // a side of the rim, or a new edge
    return j == i + 1 || (i == 0 && j == n - 1) || !edges.count(edgeKey(loop[i], loop[j]));
  };
  const auto area = [&](int i, int k, int j) {
    const Vec3 &a = mesh.vertices[loop[i]], &b = mesh.vertices[loop[k]], &c = mesh.vertices[loop[j]];
    return (b - a).cross(c - a).norm() / 2;
  };
  for (int span = 2; span < n; ++span)
    for (int i = 0; i + span < n; ++i) {
      const int j = i + span;
      cost[at(i, j)] = HUGE_VAL;
      if (!free(i, j)) continue;
      for (int k = i + 1; k < j; ++k) {
        const double c = cost[at(i, k)] + cost[at(k, j)] + area(i, k, j);
        if (c < cost[at(i, j)]) cost[at(i, j)] = c, split[at(i, j)] = k;
      }
    }
  if (cost[at(0, n - 1)] == HUGE_VAL) return false;
  std::vector<std::array<int, 2>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) continue;
    const int k = split[at(i, j)];
    lid.push_back({loop[i], loop[k], loop[j]});
    open.push_back({i, k});
    open.push_back({k, j});
  }
  return true;
}

}  // namespace

TriMesh withoutHoles(const TriMesh& mesh, double longest, long& changed, long& left, double& longestLeft, bool zip) {
  // Rims that share a vertex come apart first; each is then a simple loop.
  long doubled = 0, joined = 0;
  const TriMesh apart = withoutCrowdedEdges(mesh, doubled);
  TriMesh out = zip ? zipped(apart, joined) : apart;
  const auto sides = sidesOf(out.triangles);
  const Shells shells = findShells(out, sides);
  std::vector<int> shellOf(out.vertices.size(), -1);
  for (std::size_t t = 0; t < out.triangles.size(); ++t)
    for (const int v : out.triangles[t]) shellOf[v] = shells.ofTriangle[t];
  std::unordered_set<std::uint64_t> edges;
  for (const TriangleSide& side : sides) edges.insert(edgeKey(side.low, side.high));
  const OpenLoops rims = openLoops(out, sides);
  const std::size_t rimsBefore = joined > 0 ? openLoops(apart, sidesOf(apart.triangles)).loops.size() : rims.loops.size();
  changed = static_cast<long>(rimsBefore > rims.loops.size() ? rimsBefore - rims.loops.size() : 0);
  left = rims.unchained > 0 ? 1 : 0;
  longestLeft = 0;
  for (const auto& loop : rims.loops) {
    const double length = lengthOf(out, loop);
    if (shells.list[shellOf[loop[0]]].sheet()) continue;
    const bool crack = zip && isCrack(out, loop, shells.list[shellOf[loop[0]]].area);
    if (longest > 0 && length > longest && !crack) {
      ++left;
      longestLeft = std::max(longestLeft, length);
      continue;
    }
    Triangles lid;
    if (crack && loop.size() > 150) {
      lid = lidOfEars(out, loop).triangles;
    } else if (loop.size() > 150 || !leastArea(out, loop, edges, lid)) {
      lid.clear();
      Vec3 middle = Vec3::Zero();
      for (const int v : loop) middle += out.vertices[v] / static_cast<double>(loop.size());
      const int centre = static_cast<int>(out.vertices.size());
      out.vertices.push_back(middle);
      for (std::size_t i = 0; i < loop.size(); ++i) lid.push_back({loop[i], loop[(i + 1) % loop.size()], centre});
    }
    for (const auto& t : lid) {
      out.triangles.push_back(t);
      for (int i = 0; i < 3; ++i) edges.insert(edgeKey(t[i], t[(i + 1) % 3]));
    }
    ++changed;
  }
  if (changed == 0 && joined == 0) return mesh;
  return out;
}

namespace {

/// What of a surface a repair may not eat.
struct Measure {
  double area = 0, volume = 0;  ///< the volume about the middle of its box, whether it is closed or not
  Vec3 size = Vec3::Zero();

  bool isMuchOf(const Measure& before) const {
    constexpr double kMostArea = 0.1, kMostVolume = 0.02, kMostSize = 0.01;  // shares that may go, or come
    const double noVolume = 1e-6 * before.area * before.size.norm();         // of a sheet, whose volume says nothing
    return area >= (1 - kMostArea) * before.area && std::abs(volume - before.volume) <= kMostVolume * std::abs(before.volume) + noVolume &&
           (size - before.size).cwiseAbs().maxCoeff() <= kMostSize * before.size.norm();
  }
};

Measure measureOf(const TriMesh& mesh) {
  Measure measure;
  const Box3 box = boundsOf(mesh);
  if (box.isEmpty()) return measure;
  const Vec3 middle = box.center();
  measure.size = box.sizes();
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - middle, b = mesh.vertices[t[1]] - middle, c = mesh.vertices[t[2]] - middle;
    measure.area += 0.5 * (b - a).cross(c - a).norm();
    measure.volume += a.dot(b.cross(c)) / 6;
  }
  return measure;
}

}  // namespace

TriMesh withoutSelfCuts(const TriMesh& mesh, long& changed, long& left) {
  TriMesh best = mesh;
  std::size_t bestCuts = selfCuts(mesh).size();
  const std::size_t before = bestCuts;
  const auto openIn = [](const TriMesh& m) {
    long open = 0;
    forEachEdge(sidesOf(m.triangles), [&](std::span<const TriangleSide> edge) { open += edge.size() != 2; });
    return open;
  };
  const long openBefore = openIn(mesh);
  const Measure whole = measureOf(mesh);
  for (int round = 0; round < 6 && bestCuts > 0; ++round) {
    TriMesh tried = best;
    // The cut triangles and as many rings around them as rounds have gone by.
    std::vector<char> bad(tried.triangles.size(), 0);
    for (const auto& pair : selfCuts(tried)) bad[pair[0]] = bad[pair[1]] = 1;
    for (int ring = 0; ring < round; ++ring) {
      std::vector<char> touched(tried.vertices.size(), 0);
      for (std::size_t t = 0; t < bad.size(); ++t)
        if (bad[t])
          for (const int v : tried.triangles[t]) touched[v] = 1;
      for (std::size_t t = 0; t < bad.size(); ++t)
        for (const int v : tried.triangles[t]) bad[t] = bad[t] || touched[v];
    }
    std::vector<char> keep(bad.size());
    for (std::size_t t = 0; t < bad.size(); ++t) keep[t] = !bad[t];
    if (std::count(keep.begin(), keep.end(), 1) * 2 < static_cast<long>(keep.size())) break;  // more hole than surface
    tried = withTriangles(tried, keep);
    // Islands that the cutting left are scraps.
    const Shells shells = findShells(tried, sidesOf(tried.triangles));
    double largest = 0;
    for (const Shell& shell : shells.list) largest = std::max(largest, shell.area);
    keep.assign(tried.triangles.size(), 1);
    for (std::size_t t = 0; t < keep.size(); ++t) {
      const Shell& shell = shells.list[shells.ofTriangle[t]];
      keep[t] = shell.openEdges == 0 || shell.area >= 0.01 * largest;
    }
    tried = withTriangles(tried, keep);
    long filled = 0, holes = 0;
    double length = 0;
    tried = withoutHoles(tried, 0, filled, holes, length, false);
    long flat = 0, flatLeft = 0;
    tried = withoutDegenerate(tried, flat, flatLeft);
    const std::size_t cuts = selfCuts(tried).size();
    if (cuts < bestCuts && openIn(tried) <= openBefore && measureOf(tried).isMuchOf(whole)) {
      best = tried;
      bestCuts = cuts;
      round = -1;  // from the small ring again
    }
  }
  changed = static_cast<long>(before - bestCuts);
  left = static_cast<long>(bestCuts);
  return best;
}

}  // namespace glenoid
