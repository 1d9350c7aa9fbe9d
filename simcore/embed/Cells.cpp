// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/Cells.h"

#include <algorithm>
#include <cmath>

#include "simcore/embed/Lattice.h"
#include "simcore/embed/TriangleInTet.h"
#include "simcore/mesh/MeshHealth.h"

namespace glenoid {
namespace {

constexpr double kMostCells = 1e6;
constexpr double kTouch = 1e-9;  // of a cell's edge

using Tet4 = std::array<Vec3, 4>;

Tet4 tetOf(const Lattice& lattice, const Vec3& cell, const std::array<int, 3>& at, int which) {
  const int parity = (at[0] + at[1] + at[2]) % 2;
  Tet4 tet;
  for (int i = 0; i < 4; ++i) {
    const int corner = kFive[parity][which][i];
    for (int k = 0; k < 3; ++k) tet[i][k] = lattice.origin[k] + cell[k] * (at[k] + ((corner >> k) & 1));
  }
  return tet;
}

int cellIndex(const Lattice& lattice, int x, int y, int z) {
  return x + lattice.cells[0] * (y + lattice.cells[1] * z);
}

/// Keeps the tetrahedra that the triangles of one surface reach into.
void keepCut(const TriMesh& surface, const Mat3& R_BW, const Vec3& cell, Lattice& lattice) {
  const double tolerance = kTouch * cell.minCoeff();
  for (const auto& t : surface.triangles) {
    std::array<Vec3, 3> p;
    Box3 box;
    for (int i = 0; i < 3; ++i) p[i] = R_BW * surface.vertices[t[i]], box.extend(p[i]);
    std::array<int, 3> low, high, at;
    for (int k = 0; k < 3; ++k) {
      low[k] = std::clamp(static_cast<int>(std::floor((box.min()[k] - lattice.origin[k]) / cell[k])), 0,
                          lattice.cells[k] - 1);
      high[k] = std::clamp(static_cast<int>(std::floor((box.max()[k] - lattice.origin[k]) / cell[k])), 0,
                           lattice.cells[k] - 1);
    }
    for (at[2] = low[2]; at[2] <= high[2]; ++at[2])
      for (at[1] = low[1]; at[1] <= high[1]; ++at[1])
        for (at[0] = low[0]; at[0] <= high[0]; ++at[0])
          for (int five = 0; five < 5; ++five) {
            char& kept = lattice.kept[5 * cellIndex(lattice, at[0], at[1], at[2]) + five];
            if (!kept && triangleReachesInto(p, tetOf(lattice, cell, at, five), tolerance)) kept = 1;
          }
  }
}

/// What no triangle reaches into is wholly inside or wholly outside: its centroid tells.
void keepInside(const EmbeddedSurfaces& surfaces, const Mat3& R_WB, const Vec3& cell, Lattice& lattice) {
  std::array<Box3, 2> bounds{boundsOf(surfaces.trees[0].mesh()), boundsOf(surfaces.trees[1].mesh())};
  std::array<int, 3> at;
  for (at[2] = 0; at[2] < lattice.cells[2]; ++at[2])
    for (at[1] = 0; at[1] < lattice.cells[1]; ++at[1])
      for (at[0] = 0; at[0] < lattice.cells[0]; ++at[0])
        for (int five = 0; five < 5; ++five) {
          char& kept = lattice.kept[5 * cellIndex(lattice, at[0], at[1], at[2]) + five];
          if (kept) continue;
          const Tet4 tet = tetOf(lattice, cell, at, five);
          const Vec3 centroid = R_WB * ((tet[0] + tet[1] + tet[2] + tet[3]) / 4);
          for (int s = 0; s < 2 && !kept; ++s)
            kept = bounds[s].contains(centroid) && surfaces.trees[s].inside(centroid);
        }
}

}  // namespace

EmbeddedSurfaces::EmbeddedSurfaces(const TriMesh& visual, const TriMesh& collision)
    : trees{TriangleTree(visual), TriangleTree(collision)} {}

std::optional<Lattice> cutLattice(const EmbeddedSurfaces& surfaces, const CellGrid& grid) {
  const Mat3 R_WB = grid.frame.q_WB.toRotationMatrix(), R_BW = R_WB.transpose();
  Box3 box;
  for (const TriangleTree& tree : surfaces.trees)
    for (const auto& t : tree.mesh().triangles)
      for (const int v : t) box.extend(R_BW * tree.mesh().vertices[v]);
  Lattice lattice;
  double cells = 1;
  for (int k = 0; k < 3; ++k) {
    const double h = grid.cell[k], extent = box.max()[k] - box.min()[k];
    const double n = std::max(1.0, std::ceil(extent / h - kTouch));
    lattice.origin[k] = box.center()[k] - h * (n / 2 + grid.shift[k]);
    // A shifted box leaves part of the upper side uncovered: one more layer of cells.
    const double all = n + (lattice.origin[k] + n * h < box.max()[k] - kTouch * h ? 1 : 0);
    cells *= all;
    if (!(cells <= kMostCells)) return std::nullopt;
    lattice.cells[k] = static_cast<int>(all);
  }
  lattice.kept.assign(5 * static_cast<std::size_t>(cells), 0);
  for (const TriangleTree& tree : surfaces.trees) keepCut(tree.mesh(), R_BW, grid.cell, lattice);
  keepInside(surfaces, R_WB, grid.cell, lattice);
  lattice.count = static_cast<int>(std::count(lattice.kept.begin(), lattice.kept.end(), 1));
  return lattice;
}

TetMesh meshOf(const Lattice& lattice, const CellGrid& grid) {
  const Mat3 R_WB = grid.frame.q_WB.toRotationMatrix();
  const std::array<int, 3> nodes{lattice.cells[0] + 1, lattice.cells[1] + 1, lattice.cells[2] + 1};
  std::vector<int> number(static_cast<std::size_t>(nodes[0]) * nodes[1] * nodes[2], -1);
  TetMesh mesh;
  mesh.tets.reserve(lattice.count);
  std::array<int, 3> at;
  for (at[2] = 0; at[2] < lattice.cells[2]; ++at[2])
    for (at[1] = 0; at[1] < lattice.cells[1]; ++at[1])
      for (at[0] = 0; at[0] < lattice.cells[0]; ++at[0])
        for (int five = 0; five < 5; ++five) {
          if (!lattice.kept[5 * cellIndex(lattice, at[0], at[1], at[2]) + five]) continue;
          std::array<int, 4> tet;
          for (int i = 0; i < 4; ++i) {
            const int corner = kFive[(at[0] + at[1] + at[2]) % 2][five][i];
            tet[i] = at[0] + (corner & 1) +
                     nodes[0] * (at[1] + (corner >> 1 & 1) + nodes[1] * (at[2] + (corner >> 2)));
            number[tet[i]] = 0;
          }
          mesh.tets.push_back(tet);
        }
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(mesh.nodes.size());
    const Vec3 at_B(static_cast<double>(i % nodes[0]), static_cast<double>(i / nodes[0] % nodes[1]),
                    static_cast<double>(i / nodes[0] / nodes[1]));
    mesh.nodes.push_back(R_WB * (lattice.origin + grid.cell.cwiseProduct(at_B)));
  }
  for (auto& tet : mesh.tets)
    for (int& i : tet) i = number[i];
  return mesh;
}

Result<TetMesh> embedInCells(const TriMesh& visual, const TriMesh& collision, const CellGrid& grid) {
  for (const TriMesh* surface : {&visual, &collision})
    if (const auto closed = requireClosed(*surface); !closed) return closed.error();
  const auto outOfRange = [&](const char* detail) {
    return Error{Fault::OutOfRange, {}, {std::to_string(grid.cell.minCoeff()), "0", "inf"}, detail};
  };
  if (!grid.cell.allFinite() || !(grid.cell.minCoeff() > 0)) return outOfRange("cell size");
  if (!grid.shift.allFinite() || grid.shift.minCoeff() < 0 || grid.shift.maxCoeff() >= 1)
    return outOfRange("shift of the cells");
  const auto lattice = cutLattice(EmbeddedSurfaces(visual, collision), grid);
  if (!lattice) return outOfRange("cell size makes more than a million cells");
  return meshOf(*lattice, grid);
}

Result<TetMesh> embedInCells(const TriMesh& visual, const TriMesh& collision, double cellSize) {
  CellGrid grid;
  grid.cell = Vec3::Constant(cellSize);
  return embedInCells(visual, collision, grid);
}

}  // namespace glenoid
