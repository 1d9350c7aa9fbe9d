// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Repairs of how triangles hang together. Each takes a readable mesh and keeps its triangles in their order.

/// Cuts the surface apart at edges of three and more triangles and at pinched vertices. At each chain of such edges
/// either those triangles stay together that have the inside between them (two bodies which touch become two), or those
/// with the outside between them (a wall inside a body comes free), whichever leaves shorter rims and smaller scraps; a
/// triangle without partner gets an open side. Vertices are doubled where they stand. `changed`: vertices added.
/// Source of the cutting: Guéziec, Taubin, Lazarus and Horn, "Converting sets of polygons to manifold surfaces by cutting
/// and stitching", 1998.
TriMesh withoutCrowdedEdges(const TriMesh& mesh, long& changed);

/// Neighbours wound alike, by the smaller turn of each shell (by area). `changed`: triangles turned; `left`: edges
/// that cannot be satisfied, as of a Möbius band.
TriMesh orientedAlike(const TriMesh& mesh, long& changed, long& left);

/// Shells turned as wantedSigns asks. `changed`: shells turned.
TriMesh turnedOutwards(const TriMesh& mesh, long& changed);

/// Zips cracks (Cracks.h; only with `zip`: a hole that a repair has cut is none, however narrow), then puts lids over the rims of
/// open edges, at most `longest` around (0: any). Rims of up to 150 edges get the triangles of least area between their own
/// vertices, longer ones a fan from their middle, long cracks ears. Sheets keep their rims. `changed`: rims closed; `left`: those
/// that stay; `longestLeft`: length of the longest of these.
/// Source: Barequet and Sharir, "Filling gaps in the boundary of a polyhedron", 1995.
TriMesh withoutHoles(const TriMesh& mesh, double longest, long& changed, long& left, double& longestLeft, bool zip = true);

/// Cuts out triangles that cut each other, with a ring around them, and closes the holes, some rounds with growing
/// rings. Kept only where it makes fewer cuts, leaves the surface closed if it was, and takes at most a tenth of its area, 2 % of
/// its volume and 1 % of its size. `changed`: pairs gone;
/// `left`: pairs that stay. Source: Attene, "A lightweight approach to repairing digitized polygon meshes", 2010.
TriMesh withoutSelfCuts(const TriMesh& mesh, long& changed, long& left);

/// Sheets get two sides `thickness` apart and a rim; walls of other shells move outwards along the normals, as far as
/// each is too thin, smoothed over neighbours. `changed`: vertices moved or made; `left`: share of the walls in
/// thousandths that are still thinner than 0.9 of it; `reached`: their median.
TriMesh thickened(const TriMesh& mesh, double thickness, long& changed, long& left, double& reached);

}  // namespace glenoid
