// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>

#include "simcore/base/Error.h"
#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// How fine tetrahedra of a part itself are. Metres; what is 0 is chosen by the part.
struct TetSize {
  double edge = 0;      ///< about the length of an edge; 0: two thirds of the part's thickness, 2 V / A
  double distance = 0;  ///< how far the middle of a boundary face may lie from the surface; 0: a tenth of the edge

  bool operator==(const TetSize&) const = default;
};

/// The sizes that are meant for a closed surface, none of them 0.
TetSize chosenSize(const TriMesh& surface, const TetSize& wish);

/// Tetrahedra of what a surface encloses, their boundary on the surface: for solvers, which know of no tissue that fills its
/// elements in part. The simulation has no use for them. Creases are kept (see SharpCurves.h). Same surface and size, same mesh.
/// Frame and unit: the surface's; all tetrahedra have positive volume, every node is in one.
/// Fails as requireClosed does; with BadMesh where the surface cuts itself, has triangles without area, or no sound mesh of it
/// comes out; with OutOfRange where an edge would ask for more than `kMostTetNodes` nodes or is longer than the part; with
/// Cancelled once `stop` is set. `part` fills the place.
/// Source: Jamin, Alliez, Yvinec and Boissonnat, "CGALmesh: a generic framework for Delaunay mesh generation", ACM TOMS 2015.
Result<TetMesh> conformingMesh(const TriMesh& surface, const TetSize& wish, const std::string& part = {},
                               const std::atomic<bool>* stop = nullptr);
inline constexpr long kMostTetNodes = 500'000;

}  // namespace glenoid
