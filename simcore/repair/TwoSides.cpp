// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/TwoSides.h"

#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

constexpr double kAlike = 0.05;  // bodies are not quite symmetric: of the group's size

struct Half {
  Box3 box;
  double area = 0;
  TriMesh mesh;
};

}  // namespace

std::optional<MirrorSides> findMirrorSides(const TriMesh& mesh, const Shells& shells) {
  if (shells.list.size() < 2) return std::nullopt;
  Box3 whole;
  for (const Shell& shell : shells.list) whole.extend(shell.box);
  for (int axis = 0; axis < 3; ++axis) {
    const double plane = whole.center()[axis];
    std::array<Half, 2> halves;
    bool across = false;
    for (const Shell& shell : shells.list) {
      across = across || (shell.box.min()[axis] <= plane && shell.box.max()[axis] >= plane);
      Half& half = halves[shell.box.center()[axis] > plane];
      half.box.extend(shell.box);
      half.area += shell.area;
    }
    if (across || halves[0].box.isEmpty() || halves[1].box.isEmpty()) continue;
    const double size = std::max(halves[0].box.diagonal().norm(), halves[1].box.diagonal().norm());
    if (std::abs(halves[0].area - halves[1].area) > kAlike * (halves[0].area + halves[1].area)) continue;
    const auto mirrored = [&](Vec3 p) {
      p[axis] = 2 * plane - p[axis];
      return p;
    };
    // The box of the one, mirrored, is the box of the other.
    Box3 image;
    image.extend(mirrored(halves[0].box.min())).extend(mirrored(halves[0].box.max()));
    if ((image.min() - halves[1].box.min()).norm() > kAlike * size || (image.max() - halves[1].box.max()).norm() > kAlike * size) continue;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      halves[shells.list[shells.ofTriangle[t]].box.center()[axis] > plane].mesh.triangles.push_back(mesh.triangles[t]);
    halves[1].mesh.vertices = mesh.vertices;
    const TriangleTree tree(halves[1].mesh);
    const auto& from = halves[0].mesh.triangles;
    const std::size_t step = std::max<std::size_t>(1, from.size() / 200);
    std::size_t asked = 0, near = 0;
    for (std::size_t i = 0; i < from.size(); i += step, ++asked)
      near += tree.closest(mirrored(mesh.vertices[from[i][0]]), kAlike * size).triangle >= 0;
    if (10 * near >= 9 * asked) return MirrorSides{axis, plane};
  }
  return std::nullopt;
}

}  // namespace glenoid
