// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/RegionAnchors.h"

#include <algorithm>
#include <cmath>

#include "simcore/base/PlainMath.h"
#include "simcore/embed/Bind.h"

namespace glenoid {

namespace {

/// Four springs each; from here on nothing is halved any more. A region this many cells large costs its cells far more.
constexpr std::size_t kManyPieces = 1024;

struct Piece {
  std::vector<Triangle> triangles;
  AreaMoments moments;
  double length = 0;  ///< m, of the rod with the same largest radius of gyration
  bool whole = false; ///< not cut any more
};

Piece pieceOf(std::vector<Triangle> triangles) {
  Piece piece{std::move(triangles), {}, 0, false};
  piece.moments = momentsOf(piece.triangles);
  piece.length = std::sqrt(12.0) * radiiOfGyration(piece.moments)(2);
  return piece;
}

/// Widest of the axes, the first of equals: round-off must not choose.
int widestAxis(const AreaMoments& moments) {
  int widest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (moments.second(axis, axis) > (1 + 1e-6) * moments.second(widest, widest)) widest = axis;
  return widest;
}

std::vector<Triangle> trianglesIn(const Part& part, const Region& region, const Mat3& axes_W = Mat3::Identity()) {
  const TriMesh& mesh = region.surface == SurfaceKind::Visual ? *part.visual : *part.collision;
  std::vector<Triangle> triangles;
  for (const int index : trianglesOf(region)) {
    const auto& t = mesh.triangles[index];
    triangles.push_back({axes_W * mesh.vertices[t[0]], axes_W * mesh.vertices[t[1]], axes_W * mesh.vertices[t[2]]});
  }
  return triangles;
}

/// Lowers each edge to that of the cell which the tetrahedron at the point was cut from: five or six to a cell, a sixth
/// of it each.
void takeCells(const Part* part, std::span<const Vec3> points, std::vector<double>& edges) {
  if (!part || part->kind != PartKind::Soft || !part->volume || part->volume->tets.empty()) return;
  const std::vector<int> tets = tetsOf(*part->volume, points);
  for (std::size_t i = 0; i < points.size(); ++i)
    edges[i] = std::min(edges[i], plain::cubeRoot(6 * std::abs(tetVolume(*part->volume, tets[i]))));
}

std::vector<Piece> piecesOf(std::vector<Triangle> triangles, const Part& part, const Part* other, const Mat3& axes_W) {
  std::vector<Piece> pieces;
  pieces.push_back(pieceOf(std::move(triangles)));
  if (!(pieces[0].moments.area > 0)) return {};
  for (bool more = true; more && pieces.size() < kManyPieces;) {
    more = false;
    std::vector<Vec3> centres;  // of those that may be cut
    for (const Piece& piece : pieces)
      if (!piece.whole) centres.push_back(axes_W.transpose() * piece.moments.centre);
    std::vector<double> edges(centres.size(), 1e300);
    takeCells(&part, centres, edges);
    takeCells(other, centres, edges);
    std::vector<Piece> next;
    std::size_t asked = 0;
    for (Piece& piece : pieces) {
      if (!piece.whole && piece.length > (1 + 1e-6) * edges[asked++]) {
        const int axis = widestAxis(piece.moments);
        auto [below, above] = cutAt(piece.triangles, axis, piece.moments.centre[axis]);
        if (!below.empty() && !above.empty()) {
          next.push_back(pieceOf(std::move(below)));
          next.push_back(pieceOf(std::move(above)));
          more = true;
          continue;
        }
      }
      piece.whole = true;
      next.push_back(std::move(piece));
    }
    pieces = std::move(next);
  }
  return pieces;
}

}  // namespace

AreaMoments momentsOf(const Part& part, const Region& region) { return momentsOf(trianglesIn(part, region)); }

std::vector<RegionAnchor> regionAnchors(const CoupledPart& part, const Region& region, const Part* other, const Mat3& axes_W) {
  std::vector<Vec3> points;
  std::vector<RegionAnchor> anchors;
  for (const Piece& piece : piecesOf(trianglesIn(*part.part, region, axes_W), *part.part, other, axes_W))
    for (const Vec3& along : pointsWithMoments(piece.moments)) {
      const Vec3 point = axes_W.transpose() * along;
      points.push_back(point);
      anchors.push_back({point, {}, piece.moments.area / 4});
    }
  if (anchors.empty()) return anchors;
  const std::vector<VertexBinding> bound = part.part->kind == PartKind::Soft ? bindToTets(*part.part->volume, points)
                                                                             : bindToRigid(points, part.centre);
  for (std::size_t i = 0; i < anchors.size(); ++i) anchors[i].binding = bound[i];
  return anchors;
}

bool canHold(const AreaMoments& moments) {
  const Vec3 radii = radiiOfGyration(moments);
  return moments.area > 0 && radii(1) > 1e-3 * radii(2);
}

}  // namespace glenoid
