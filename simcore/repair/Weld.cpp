// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/Weld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "simcore/mesh/Cleanup.h"
#include "simcore/repair/Edges.h"

namespace glenoid {
namespace {

using Cell = std::array<std::int64_t, 3>;
struct HashOfCell {
  std::size_t operator()(const Cell& c) const { return hashBytes(c.data(), sizeof c).low; }
};

std::array<int, 3> sorted(std::array<int, 3> t) {
  std::sort(t.begin(), t.end());
  return t;
}

bool repeats(const std::array<int, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Faces by their corners: first the sorted corners, then the index.
std::vector<std::pair<std::array<int, 3>, int>> facesByCorners(const TriMesh& mesh) {
  std::vector<std::pair<std::array<int, 3>, int>> faces;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    if (!repeats(mesh.triangles[t])) faces.push_back({sorted(mesh.triangles[t]), t});
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Whether the corners of a face turn as the sorted ones do.
bool even(const std::array<int, 3>& t) { return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2; }

/// Gives flat faces whose corner lies on the opposite side to the neighbour across that side. Answers how many.
long flipCaps(TriMesh& mesh, double flat) {
  const auto sides = sidesOf(mesh.triangles);
  std::vector<int> caps;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    if (isDegenerate(mesh, t, flat)) caps.push_back(t);
  if (caps.empty()) return 0;
  const auto trianglesAt = [&](int a, int b) {
    const TriangleSide key{std::min(a, b), std::max(a, b), -1, false};
    std::vector<int> list;
    for (auto at = std::lower_bound(sides.begin(), sides.end(), key); at != sides.end() && at->sameEdge(key); ++at) list.push_back(at->triangle);
    return list;
  };
  std::vector<char> touched(mesh.triangles.size(), 0);
  long flipped = 0;
  for (const int t : caps) {
    auto c = mesh.triangles[t];
    if (touched[t] || repeats(c)) continue;
    int longest = 0;
    double length = -1;
    for (int i = 0; i < 3; ++i)
      if (const double l = (mesh.vertices[c[i]] - mesh.vertices[c[(i + 1) % 3]]).norm(); l > length) length = l, longest = i;
    const int a = c[longest], b = c[(longest + 1) % 3], tip = c[(longest + 2) % 3];
    const std::vector<int> pair = trianglesAt(a, b);
    if (pair.size() != 2) continue;
    const int other = pair[0] == t ? pair[1] : pair[0];
    if (touched[other] || isDegenerate(mesh, other, flat)) continue;
    const auto& o = mesh.triangles[other];
    int far = -1;
    for (int i = 0; i < 3; ++i)
      if (o[i] == b && o[(i + 1) % 3] == a) far = o[(i + 2) % 3];
    if (far < 0 || far == tip || !trianglesAt(far, tip).empty()) continue;
    mesh.triangles[t] = {a, far, tip};
    mesh.triangles[other] = {far, b, tip};
    touched[t] = touched[other] = 1;
    ++flipped;
  }
  return flipped;
}

/// Draws sides together that are short beside their flat face. Answers how many.
long collapseNeedles(TriMesh& mesh, double flat) {
  DisjointSets sets(mesh.vertices.size());
  long drawn = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    if (!isDegenerate(mesh, t, flat)) continue;
    const auto& c = mesh.triangles[t];
    for (int i = 0; i < 3; ++i)
      if (c[i] != c[(i + 1) % 3] && (mesh.vertices[c[i]] - mesh.vertices[c[(i + 1) % 3]]).norm() <= flat) drawn += sets.join(c[i], c[(i + 1) % 3]);
  }
  if (drawn > 0)
    for (auto& t : mesh.triangles)
      for (int& v : t) v = sets.root(v);
  return drawn;
}

}  // namespace

std::vector<int> nearestRepresentatives(const TriMesh& mesh, double tolerance) {
  const std::size_t n = mesh.vertices.size();
  DisjointSets sets(n);
  const double cell = tolerance > 0 ? tolerance : 1;
  std::unordered_map<Cell, std::vector<int>, HashOfCell> grid;
  grid.reserve(n);
  const auto cellOf = [&](const Vec3& p) {
    Cell c{};
    // With no tolerance the bits themselves: −0 is 0.
    for (int k = 0; k < 3; ++k) c[k] = tolerance > 0 ? static_cast<std::int64_t>(std::floor(p[k] / cell)) : std::bit_cast<std::int64_t>(p[k] + 0.0);
    return c;
  };
  const int reach = tolerance > 0 ? 1 : 0;
  for (std::size_t v = 0; v < n; ++v) {
    const Cell home = cellOf(mesh.vertices[v]);
    for (int x = -reach; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y)
        for (int z = -reach; z <= reach; ++z) {
          const auto found = grid.find({home[0] + x, home[1] + y, home[2] + z});
          if (found == grid.end()) continue;
          for (const int o : found->second)
            if ((mesh.vertices[o] - mesh.vertices[v]).norm() <= tolerance) sets.join(o, static_cast<int>(v));
        }
    grid[home].push_back(static_cast<int>(v));
  }
  std::vector<int> first(n);
  for (std::size_t v = 0; v < n; ++v) first[v] = sets.root(static_cast<int>(v));
  return first;
}

bool isDegenerate(const TriMesh& mesh, int triangle, double flat) {
  const auto& t = mesh.triangles[triangle];
  if (repeats(t)) return true;
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return !((b - a).cross(c - a).norm() > flat * longest);
}

std::vector<int> duplicateFaces(const TriMesh& mesh) {
  const auto faces = facesByCorners(mesh);
  std::vector<int> list;
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].first == faces[i - 1].first) list.push_back(faces[i].second);
  std::sort(list.begin(), list.end());
  return list;
}

TriMesh welded(const TriMesh& mesh, double tolerance, long& changed) {
  const std::vector<int> first = nearestRepresentatives(mesh, tolerance);
  changed = 0;
  for (std::size_t v = 0; v < first.size(); ++v) changed += first[v] != static_cast<int>(v);
  TriMesh out = mesh;
  for (auto& t : out.triangles)
    for (int& v : t) v = first[v];
  return compact(out);
}

TriMesh withoutDegenerate(const TriMesh& mesh, long& changed, long& left) {
  const double flat = 1e-9 * boundsOf(mesh).diagonal().norm();
  const auto count = [&](const TriMesh& m) {
    long n = 0;
    for (int t = 0; t < static_cast<int>(m.triangles.size()); ++t) n += isDegenerate(m, t, flat);
    return n;
  };
  const long before = count(mesh);
  TriMesh out = compact(mesh);
  const auto unused = static_cast<long>(mesh.vertices.size() - out.vertices.size());
  for (int round = 0; round < 10; ++round) {
    const long drawn = collapseNeedles(out, flat);
    if (drawn > 0) out = compact(out);
    if (flipCaps(out, flat) + drawn == 0) break;
  }
  left = count(out);
  changed = before - left + (before == left ? unused : 0);
  return out;
}

namespace {

/// Of faces that lie back to back (`paired`: the first of those on each other, −1 for all other faces) those that belong to a fin: a patch of them whose whole border hangs on other faces,
/// two or more at each edge. A patch with a free border, or with none at all, is a surface that has two sides.
std::vector<char> finsAmong(const TriMesh& mesh, const std::vector<int>& paired) {
  DisjointSets patches(mesh.triangles.size());
  std::vector<char> hangs(mesh.triangles.size(), 0), isFree(mesh.triangles.size(), 0);
  const auto sides = sidesOf(mesh.triangles);
  forEachEdge(sides, [&](std::span<const TriangleSide> edge) {
    int first = -1;
    long others = 0;
    bool goesOn = false;
    for (const TriangleSide& side : edge) {
      if (paired[side.triangle] < 0) {
        ++others;
        continue;
      }
      if (first >= 0) patches.join(first, side.triangle);
      else first = side.triangle;
      goesOn = goesOn || paired[side.triangle] != paired[first];
    }
    if (first < 0 || goesOn) return;
    (others >= 2 ? hangs : isFree)[first] = 1;
  });
  std::vector<char> patchHangs(hangs.size(), 0), patchFree(hangs.size(), 0);
  for (int t = 0; t < static_cast<int>(hangs.size()); ++t) {
    const int patch = patches.root(t);
    patchHangs[patch] = patchHangs[patch] || hangs[t];
    patchFree[patch] = patchFree[patch] || isFree[t];
  }
  std::vector<char> fins(hangs.size(), 0);
  for (int t = 0; t < static_cast<int>(fins.size()); ++t) {
    const int patch = patches.root(t);
    fins[t] = paired[t] >= 0 && patchHangs[patch] && !patchFree[patch];
  }
  return fins;
}

}  // namespace

TriMesh withoutDuplicates(const TriMesh& mesh, long& changed) {
  const auto faces = facesByCorners(mesh);
  std::vector<char> keep(mesh.triangles.size(), 1);
  std::vector<int> paired(mesh.triangles.size(), -1);
  const auto forEachSet = [&](const auto& visit) {
    for (std::size_t i = 0, end; i < faces.size(); i = end) {
      for (end = i + 1; end < faces.size() && faces[end].first == faces[i].first;) ++end;
      if (end - i < 2) continue;
      long turns = 0;
      for (std::size_t k = i; k < end; ++k) turns += even(mesh.triangles[faces[k].second]) ? 1 : -1;
      visit(i, end, turns);
    }
  };
  forEachSet([&](std::size_t i, std::size_t end, long turns) {
    for (std::size_t k = i; k < end && turns == 0; ++k) paired[faces[k].second] = faces[i].second;
  });
  const std::vector<char> fins = finsAmong(mesh, paired);
  forEachSet([&](std::size_t i, std::size_t end, long turns) {
    bool kept = fins[faces[i].second];
    for (std::size_t k = i; k < end; ++k) {
      const bool majority = turns == 0 || even(mesh.triangles[faces[k].second]) == (turns > 0);
      keep[faces[k].second] = !kept && majority;
      kept = kept || majority;
    }
  });
  changed = static_cast<long>(std::count(keep.begin(), keep.end(), 0));
  return withTriangles(mesh, keep);
}

TriMesh withTriangles(const TriMesh& mesh, const std::vector<char>& keep) {
  TriMesh out;
  out.vertices = mesh.vertices;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (keep[t]) out.triangles.push_back(mesh.triangles[t]);
  return compact(out);
}

}  // namespace glenoid
