// SPDX-License-Identifier: GPL-3.0-or-later
// From cells that meet a part to tetrahedra that fill it: what lies mostly outside goes, and the nodes of the new
// boundary move onto the surface as far as their tetrahedra bear it. Near a point load this matters: the nearly empty
// elements of an embedding are nearly without stiffness, and the load would stand on them.
#include <algorithm>

#include "simcore/author/StaticPart.h"
#include "simcore/embed/Fill.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

namespace {

constexpr double kHalf = 0.5;        ///< fill from which a tetrahedron stays
constexpr double kVolumeLeast = 0.2; ///< of what a tetrahedron had before its nodes moved
constexpr double kQualityLeast = 0.15;

/// The tetrahedra marked, with the nodes they use in their old order.
TetMesh kept(const TetMesh& mesh, const std::vector<char>& keep) {
  TetMesh part;
  std::vector<int> number(mesh.nodes.size(), -1);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (keep[t])
      for (const int node : mesh.tets[t]) number[static_cast<std::size_t>(node)] = 0;
  for (std::size_t n = 0; n < number.size(); ++n) {
    if (number[n] < 0) continue;
    number[n] = static_cast<int>(part.nodes.size());
    part.nodes.push_back(mesh.nodes[n]);
  }
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (!keep[t]) continue;
    std::array<int, 4> tet = mesh.tets[t];
    for (int& node : tet) node = number[static_cast<std::size_t>(node)];
    part.tets.push_back(tet);
  }
  return part;
}

/// The largest piece that is joined by faces.
TetMesh largestPiece(const TetMesh& mesh) {
  int count = 0;
  const std::vector<int> piece = faceComponents(mesh, &count);
  std::vector<int> size(static_cast<std::size_t>(count), 0);
  for (const int p : piece) ++size[static_cast<std::size_t>(p)];
  const int largest = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  std::vector<char> keep;
  for (const int p : piece) keep.push_back(p == largest);
  return kept(mesh, keep);
}

}  // namespace

TetMesh fitToSurface(const TetMesh& cells, const TriMesh& surface) {
  const std::vector<double> inside = enclosedVolumes(cells, surface);
  std::vector<char> keep;
  for (std::size_t t = 0; t < cells.tets.size(); ++t) keep.push_back(inside[t] > kHalf * tetVolume(cells, static_cast<int>(t)));
  TetMesh mesh = largestPiece(kept(cells, keep));
  std::vector<std::vector<int>> around(mesh.nodes.size());
  std::vector<double> before;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    before.push_back(tetVolume(mesh, static_cast<int>(t)));
    for (const int node : mesh.tets[t]) around[static_cast<std::size_t>(node)].push_back(static_cast<int>(t));
  }
  std::vector<char> outer(mesh.nodes.size(), 0);
  for (const auto& face : boundaryOf(mesh).triangles)
    for (const int node : face) outer[static_cast<std::size_t>(node)] = 1;
  const TriangleTree tree(surface);
  const auto sound = [&](std::size_t node) {
    return std::all_of(around[node].begin(), around[node].end(), [&](int t) {
      return tetVolume(mesh, t) > kVolumeLeast * before[static_cast<std::size_t>(t)] && tetQuality(mesh, t) > kQualityLeast;
    });
  };
  for (int round = 0; round < 3; ++round) {  // one that was stopped may go on when its neighbours have moved
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
      if (!outer[node]) continue;
      const Vec3 from = mesh.nodes[node], to = tree.closest(from).point;
      for (const double way : {1.0, 0.5, 0.25}) {
        mesh.nodes[node] = from + way * (to - from);
        if (sound(node)) break;
        mesh.nodes[node] = from;
      }
    }
  }
  return mesh;
}

}  // namespace glenoid
