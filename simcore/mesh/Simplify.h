// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// How far a simplification may go for the sake of shape.
struct SimplifyOptions {
  bool keepVolume = true;  ///< at the end shift vertices along their normals to the original's volume
  /// Above this many triangles meshoptimizer reduces first, as far as its answer stays a closed manifold;
  /// it picks among existing vertices, too coarse a choice for a last surface of some hundred triangles.
  int largeMesh = 40000;
  /// How much the squared error counts at each vertex of the input, > 0; empty: one everywhere. More of the triangles
  /// go where it is high. The first reduction of a large mesh does not see it.
  std::vector<double> importance = {};
};

/// Quick reduction of a large surface to roughly `targetTriangles`, by picking among its vertices (meshoptimizer). It
/// keeps a closed surface closed, but single edges may end up with four triangles: right for measuring, not for a
/// surface that somebody keeps. All indices must be valid.
TriMesh roughlySimplified(const TriMesh& mesh, int targetTriangles);

/// Closed surface with about `targetTriangles` triangles: edges collapse, cheapest first, to the point of
/// least quadric error. A collapse that would change the topology, flip a triangle, make a sliver or cut the
/// surface through itself is refused; where that leaves too many triangles, the rules on shape are relaxed
/// first, then the one on cutting (as a surface asks for that cuts itself to begin with), the topology never:
/// the answer is closed and manifold of the same genus, and has more triangles than asked for when that needs
/// them. A mesh that has no more triangles than asked for comes back as it is. Deterministic. Fails as
/// requireClosed does; with OutOfRange when targetTriangles < 4 or an importance is not
/// positive, and with BadIndex when there are not as many as vertices. Source: Garland and Heckbert, "Surface
/// Simplification Using Quadric Error Metrics", SIGGRAPH 1997; link condition: Dey, Edelsbrunner, Guha,
/// Nekhayev, "Topology Preserving Edge Contraction", 1999.
Result<TriMesh> simplify(const TriMesh& mesh, int targetTriangles, const SimplifyOptions& options = {});

}  // namespace glenoid
