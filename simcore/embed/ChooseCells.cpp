// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "simcore/embed/BandShape.h"
#include "simcore/embed/Cells.h"
#include "simcore/embed/Lattice.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/mesh/TetTools.h"

namespace glenoid {
namespace {

constexpr int kMostTets = 200000, kShiftBelow = 1000;
constexpr int kLargeSurface = 50000, kStandIn = 20000;  ///< triangles

/// One grid that was tried.
struct Trial {
  CellGrid grid;
  int miss = 0;       ///< |count − wanted|
  double volume = 0;  ///< of the kept tetrahedra, m³
  bool operator<(const Trial& o) const { return miss != o.miss ? miss < o.miss : volume < o.volume; }
};

/// Edges of a cell in its size.
Vec3 shapeOf(GridAxes axes) { return axes == GridAxes::Band ? Vec3(1, kBandCellsWider, 1) : Vec3::Ones(); }

CellGrid gridOf(const Quat& frame, const Vec3& cell, const Vec3& shift) {
  CellGrid grid;
  grid.frame.q_WB = frame;
  grid.cell = cell;
  grid.shift = shift;
  return grid;
}

/// Number of tetrahedra, or a large one when the cells are too many to try.
int countOf(const EmbeddedSurfaces& surfaces, const CellGrid& grid) {
  const auto lattice = cutLattice(surfaces, grid);
  return lattice ? lattice->count : 1 << 30;
}

}  // namespace

Quat principalAxes(const TriMesh& surface) {
  // Second moments of the area, by the midpoints of the edges of each triangle (exact for quadratics).
  double area = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  const Vec3 origin = boundsOf(surface).center();
  for (const auto& t : surface.triangles) {
    const Vec3 a = surface.vertices[t[0]] - origin, b = surface.vertices[t[1]] - origin,
               c = surface.vertices[t[2]] - origin;
    const double third = (b - a).cross(c - a).norm() / 6;
    for (const Vec3& m : {Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2)}) {
      area += third, first += third * m;
      second += third * m * m.transpose();
    }
  }
  if (!(area > 0)) return Quat::Identity();
  const Mat3 spread = second / area - first * first.transpose() / (area * area);
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(spread);
  Mat3 axes;
  for (int k = 0; k < 2; ++k) {
    Vec3 axis = solver.eigenvectors().col(2 - k);
    // The eigenvector's sign is arbitrary: its largest entry is made positive.
    int largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    axes.col(k) = axis[largest] < 0 ? Vec3(-axis) : axis;
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return Quat(axes).normalized();
}

namespace {

/// Bent along a band, a cell may lose its volume where the band curves too much for it.
constexpr double kLeastBent = 0.05;  ///< of the volume that it has in a flat band

/// Moves the nodes of a flat band's cells up to the band; false where that leaves a tetrahedron too little volume.
bool bend(const BandShape& band, TetMesh& mesh) {
  TetMesh bent = mesh;
  for (Vec3& node : bent.nodes) node = band.bent(node);
  bool sound = true;
  for (int tet = 0; tet < static_cast<int>(mesh.tets.size()); ++tet) sound &= tetVolume(bent, tet) > kLeastBent * tetVolume(mesh, tet);
  mesh = std::move(bent);
  return sound;
}

/// chooseCells along given axes, in cells of a shape; with a band the surfaces are flat, and the answer lies along it.
Result<CellChoice> chooseInFrame(const TriMesh& visual, const TriMesh& collision, int targetTets, const Quat& frame, const Vec3& shape,
                                 const BandShape* band = nullptr) {
  if (targetTets < 1 || targetTets > kMostTets)
    return Error{Fault::OutOfRange,
                 {},
                 {std::to_string(targetTets), "1", std::to_string(kMostTets)},
                 "tetrahedra of a part"};
  const EmbeddedSurfaces surfaces(visual, collision);
  // Grids are tried on a stand-in for a very large surface, whose triangles are much smaller than any cell; what is
  // taken in the end is cut by the surface itself.
  std::optional<EmbeddedSurfaces> thinned;
  if (visual.triangles.size() > kLargeSurface || collision.triangles.size() > kLargeSurface) {
    const auto standIn = [](const TriMesh& mesh) {
      return mesh.triangles.size() > kLargeSurface ? roughlySimplified(mesh, kStandIn) : mesh;
    };
    thinned.emplace(standIn(visual), standIn(collision));
  }
  const EmbeddedSurfaces& tried = thinned ? *thinned : surfaces;

  // From one cell around everything downwards in steps of 2 %, so that no grid is ever much finer than
  // needed; cells that were full of tissue would need size `full`, and partly full ones more.
  const double full = std::cbrt(5 * std::max(enclosedVolume(visual), enclosedVolume(collision)) / (targetTets * shape.prod()));
  const double largest = 2 * boundsOf(visual).merged(boundsOf(collision)).diagonal().norm();
  std::vector<double> sizes;
  for (double size = largest; size > 0.9 * full; size /= 1.02) {
    const int count = countOf(tried, gridOf(frame, size * shape, Vec3::Zero()));
    if (count >= 0.6 * targetTets && count <= 1.6 * targetTets) sizes.push_back(size);
    if (count > 2.5 * targetTets) break;
  }
  // Large numbers follow the size smoothly enough without shifting.
  const int shifts = targetTets > kShiftBelow ? 1 : 27;
  std::vector<Trial> trials;
  for (const double size : sizes)
    for (int s = 0; s < shifts; ++s) {
      const Vec3 shift = Vec3(s % 3, s / 3 % 3, s / 9) / 3.0;
      const CellGrid grid = gridOf(frame, size * shape, shift);
      const int count = countOf(tried, grid);
      if (std::abs(count - targetTets) <= 0.15 * targetTets)
        trials.push_back({grid, std::abs(count - targetTets), count * size * size * size});
    }
  std::stable_sort(trials.begin(), trials.end());
  for (const Trial& trial : trials) {
    TetMesh mesh = meshOf(*cutLattice(surfaces, trial.grid), trial.grid);
    int components = 0;
    faceComponents(mesh, &components);
    if (components == 1 && (!band || bend(*band, mesh))) return CellChoice{trial.grid, std::move(mesh), trial.grid.cell.x()};
  }
  return Error{Fault::Unusable,
               {},
               {"no cell size gives one piece of about " + std::to_string(targetTets) + " tetrahedra"},
               "cells of a part"};
}

/// What a grid along a band is cut round, and the way back of its nodes.
struct FlatPart {
  explicit FlatPart(const TriMesh& visualSurface, const TriMesh& collisionSurface)
      : band(bandOf(visualSurface)), visual(flattened(band, visualSurface, kFlatness * band.length)),
        collision(flattened(band, collisionSurface, kFlatness * band.length)) {}
  static constexpr double kFlatness = 1e-4;  ///< of the length: which cells a surface meets
  BandShape band;
  TriMesh visual, collision;
};

Result<Done> requireBothClosed(const TriMesh& visual, const TriMesh& collision) {
  for (const TriMesh* surface : {&visual, &collision})
    if (const auto closed = requireClosed(*surface); !closed) return closed.error();
  return Done{};
}

}  // namespace

Result<CellChoice> chooseCells(const TriMesh& visual, const TriMesh& collision, int targetTets, GridAxes axes) {
  if (const auto closed = requireBothClosed(visual, collision); !closed) return closed.error();
  const Quat frame = axes == GridAxes::World ? Quat::Identity() : principalAxes(visual);
  if (axes != GridAxes::Band) return chooseInFrame(visual, collision, targetTets, frame, shapeOf(axes));
  const FlatPart flat(visual, collision);
  return chooseInFrame(flat.visual, flat.collision, targetTets, frame, shapeOf(axes), &flat.band);
}

Result<TetMesh> embedAlong(const TriMesh& visual, const TriMesh& collision, double cellSize, GridAxes axes) {
  CellGrid grid;
  grid.cell = cellSize * shapeOf(axes);
  if (axes != GridAxes::World) grid.frame.q_WB = principalAxes(visual);
  if (axes != GridAxes::Band) return embedInCells(visual, collision, grid);
  if (const auto closed = requireBothClosed(visual, collision); !closed) return closed.error();
  const FlatPart flat(visual, collision);
  auto mesh = embedInCells(flat.visual, flat.collision, grid);
  if (mesh && !bend(flat.band, *mesh))
    return Error{Fault::Unusable, {}, {"cells of this size along the band turn inside out where it curves; smaller ones or other axes may do"}, "cells of a part"};
  return mesh;
}

Result<double> cellSizeFor(const TriMesh& visual, const TriMesh& collision, int targetTets, GridAxes axes) {
  const auto choice = chooseCells(visual, collision, targetTets, axes);
  if (!choice) return choice.error();
  return choice->cellSize;
}

}  // namespace glenoid
