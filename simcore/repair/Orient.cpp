// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/Edges.h"
#include "simcore/repair/Topology.h"

namespace glenoid {

TriMesh orientedAlike(const TriMesh& mesh, long& changed, long& left) {
  const std::size_t n = mesh.triangles.size();
  const auto sides = sidesOf(mesh.triangles);
  struct Link {
    int to;
    bool contrary;
  };
  std::vector<std::vector<Link>> links(n);
  forEachEdge(sides, [&](std::span<const TriangleSide> edge) {
    if (edge.size() != 2) return;
    const bool contrary = edge[0].forward == edge[1].forward;
    links[edge[0].triangle].push_back({edge[1].triangle, contrary});
    links[edge[1].triangle].push_back({edge[0].triangle, contrary});
  });
  std::vector<signed char> turn(n, -1);
  TriMesh out = mesh;
  changed = left = 0;
  std::vector<int> piece;
  for (std::size_t start = 0; start < n; ++start) {
    if (turn[start] >= 0) continue;
    piece.assign(1, static_cast<int>(start));
    turn[start] = 0;
    double kept = 0, turned = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const int t = piece[i];
      const auto& c = mesh.triangles[t];
      (turn[t] ? turned : kept) += (mesh.vertices[c[1]] - mesh.vertices[c[0]]).cross(mesh.vertices[c[2]] - mesh.vertices[c[0]]).norm();
      for (const Link& link : links[t]) {
        const auto wanted = static_cast<signed char>(turn[t] ^ (link.contrary ? 1 : 0));
        if (turn[link.to] < 0) {
          turn[link.to] = wanted;
          piece.push_back(link.to);
        }
      }
    }
    const signed char which = turned > kept ? 0 : 1;  // the smaller part yields
    for (const int t : piece)
      if (turn[t] == which) {
        std::swap(out.triangles[t][1], out.triangles[t][2]);
        ++changed;
      }
  }
  for (std::size_t t = 0; t < n; ++t)
    for (const Link& link : links[t]) left += link.to > static_cast<int>(t) && (turn[t] ^ turn[link.to]) != (link.contrary ? 1 : 0);
  return out;
}

TriMesh turnedOutwards(const TriMesh& mesh, long& changed) {
  const Shells shells = findShells(mesh, sidesOf(mesh.triangles));
  const std::vector<int> wanted = wantedSigns(mesh, shells);
  TriMesh out = mesh;
  changed = 0;
  std::vector<char> turn(shells.list.size(), 0);
  for (std::size_t s = 0; s < turn.size(); ++s) {
    turn[s] = shells.list[s].volume * wanted[s] < 0;
    changed += turn[s];
  }
  for (std::size_t t = 0; t < out.triangles.size(); ++t)
    if (turn[shells.ofTriangle[t]]) std::swap(out.triangles[t][1], out.triangles[t][2]);
  return out;
}

}  // namespace glenoid
