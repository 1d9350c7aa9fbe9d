// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/PeerBlocks.h"

#include <algorithm>
#include <bit>
#include <map>

namespace glenoid::peers {

const std::array<BlockShape, 7>& blockShapes() {
  constexpr int kXY = 3, kXZ = 5, kYZ = 6, kXYZ = 7;
  static const std::array<BlockShape, 7> shapes{{
      {"muscle-1", {3, 2, 3}, 0.030, 0.050, false, {{{2, 1, 2}, kYZ}, {{2, 0, 2}, kXYZ}, {{2, 1, 1}, kXYZ}}, 87},
      {"muscle-2", {3, 3, 3}, 0.040, 0.050, true, {{{2, 1, 2}, kYZ}}, 129},
      {"muscle-3", {4, 2, 4}, 0.030, 0.060, false, {{{3, 1, 3}, kYZ}, {{3, 0, 3}, kXYZ}}, 158},
      {"tendon", {7, 1, 2}, 0.010, 0.020, true, {}, 65},
      {"ligament", {6, 1, 3}, 0.012, 0.030, false,
       {{{5, 0, 2}, kXZ}, {{5, 0, 2}, kYZ}, {{5, 0, 0}, kXZ}, {{3, 0, 0}, kXY}}, 86},
      {"muscle-4", {5, 2, 2}, 0.025, 0.030, false,
       {{{4, 1, 1}, kXYZ}, {{4, 1, 0}, kYZ}, {{3, 1, 1}, kYZ}, {{3, 1, 0}, kXYZ}}, 96},
      {"muscle-5", {5, 1, 5}, 0.015, 0.060, false, {{{4, 0, 4}, kXYZ}, {{4, 0, 2}, kXYZ}, {{4, 0, 0}, kXYZ}}, 122},
  }};
  return shapes;
}

TetMesh makeBlock(const BlockShape& shape, const Vec3& corner, double length) {
  TetMesh mesh;
  std::map<std::array<int, 3>, int> known;
  const auto node = [&](const std::array<int, 3>& cell, int bits) {
    std::array<int, 3> at;
    Vec3 fraction;
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = cell[axis] + (bits >> axis & 1);
      fraction[axis] = static_cast<double>(at[axis]) / shape.cells[axis];
    }
    const auto [it, isNew] = known.try_emplace(at, static_cast<int>(mesh.nodes.size()));
    if (isNew) mesh.nodes.push_back(corner + fraction.cwiseProduct(Vec3(length, shape.height, shape.width)));
    return it->second;
  };
  const auto add = [&](const std::array<int, 3>& cell, const std::array<int, 4>& bits) {
    std::array<int, 4> tet;
    for (int k = 0; k < 4; ++k) tet[k] = node(cell, bits[k]);
    mesh.tets.push_back(tet);
    if (tetVolume(mesh, static_cast<int>(mesh.tets.size()) - 1) < 0) std::swap(mesh.tets.back()[2], mesh.tets.back()[3]);
  };
  const auto isLeftOut = [&](const std::array<int, 3>& cell, int bits) {
    return std::any_of(shape.leftOut.begin(), shape.leftOut.end(),
                       [&](const LeftOut& left) { return left.cell == cell && left.corner == bits; });
  };
  for (int x = 0; x < shape.cells[0]; ++x)
    for (int z = 0; z < shape.cells[2]; ++z)
      for (int y = 0; y < shape.cells[1]; ++y) {
        const std::array<int, 3> cell{x, y, z};
        const bool last = x + 1 == shape.cells[0] && y + 1 == shape.cells[1] && z + 1 == shape.cells[2];
        if (last && shape.lastMissing) continue;
        // Every second corner of the cube, with its three neighbours; the other four make the inner tetrahedron.
        // Cells that share a face keep opposite corners, so that its diagonal is the same from both.
        const int parity = 1 - (x + y + z) % 2;
        std::array<int, 4> inner{};
        int count = 0;
        for (int bits = 0; bits < 8; ++bits) {
          if (std::popcount(static_cast<unsigned>(bits)) % 2 != parity)
            inner[count++] = bits;
          else if (!isLeftOut(cell, bits))
            add(cell, {bits, bits ^ 1, bits ^ 2, bits ^ 4});
        }
        add(cell, inner);
      }
  return mesh;
}

TriMesh boxSurface(const Vec3& low, const Vec3& high) {
  TriMesh mesh;
  for (int bits = 0; bits < 8; ++bits)
    mesh.vertices.push_back({(bits & 1 ? high : low).x(), (bits & 2 ? high : low).y(), (bits & 4 ? high : low).z()});
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    for (const int side : {0, 1 << axis}) {
      // u, v and the axis are right-handed: counter-clockwise seen from the axis' positive side.
      const std::array<int, 3> first{side, side + u, side + u + v}, second{side, side + u + v, side + v};
      for (auto triangle : {first, second}) {
        if (!side) std::swap(triangle[1], triangle[2]);
        mesh.triangles.push_back(triangle);
      }
    }
  }
  return mesh;
}

}  // namespace glenoid::peers
