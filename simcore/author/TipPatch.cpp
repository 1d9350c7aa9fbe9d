// SPDX-License-Identifier: GPL-3.0-or-later
// The place that a tip presses, and cells that are fine there.
#include <cmath>

#include "simcore/author/StaticPart.h"
#include "simcore/embed/Cells.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

namespace {

struct Facet {
  Vec3 a, b, c;
  Vec3 area() const { return 0.5 * (b - a).cross(c - a); }
  Vec3 middle() const { return (a + b + c) / 3; }
  double longest() const { return std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()})); }
};

/// Pieces of a facet no longer than `size`, as far as they may lie within `reach` of the middle.
void cut(const Facet& facet, const Vec3& middle, double reach, double size, std::vector<Facet>& pieces) {
  const double longest = facet.longest();
  if ((facet.middle() - middle).norm() > reach + longest) return;
  if (longest <= size) {
    pieces.push_back(facet);
    return;
  }
  const Vec3 ab = 0.5 * (facet.a + facet.b), bc = 0.5 * (facet.b + facet.c), ca = 0.5 * (facet.c + facet.a);
  for (const Facet& quarter : {Facet{facet.a, ab, ca}, Facet{ab, facet.b, bc}, Facet{ca, bc, facet.c}, Facet{ab, bc, ca}})
    cut(quarter, middle, reach, size, pieces);
}

/// One axis of the graded cells: from metres off the place to cells counted from it, and back.
struct Grading {
  explicit Grading(const GradedCells& cells)
      : c(cells), grown(c.core + (c.coarsest - c.finest) / c.growth), inCore(c.core / c.finest),
        inGrown(inCore + std::log(c.coarsest / c.finest) / c.growth) {}
  double toCells(double x) const {
    const double d = std::abs(x);
    const double n = d <= c.core  ? d / c.finest
                     : d <= grown ? inCore + std::log1p(c.growth * (d - c.core) / c.finest) / c.growth
                                  : inGrown + (d - grown) / c.coarsest;
    return std::copysign(n, x);
  }
  double toMetres(double x) const {
    const double n = std::abs(x);
    const double d = n <= inCore    ? n * c.finest
                     : n <= inGrown ? c.core + c.finest * std::expm1(c.growth * (n - inCore)) / c.growth
                                    : grown + (n - inGrown) * c.coarsest;
    return std::copysign(d, x);
  }
  GradedCells c;
  double grown, inCore, inGrown;
};

/// Triangles cut in four: edges that are straight in metres then differ little from edges straight in cells.
TriMesh inCells(const TriMesh& surface, const Mat3& toFrame, const Vec3& middle, const Grading& grading) {
  TriMesh mesh = surface;
  for (Vec3& v : mesh.vertices) {
    const Vec3 x = toFrame * (v - middle);
    for (int k = 0; k < 3; ++k) v[k] = grading.toCells(x[k]);
  }
  return mesh;
}

}  // namespace

TipPatch tipPatchAt(const TriMesh& surface, const Vec3& near_W, double radius) {
  TipPatch patch;
  patch.radius = radius;
  const auto closest = TriangleTree(surface).closest(near_W);
  patch.middle_W = closest.point;
  const auto facetOf = [&](std::size_t t) {
    const auto& c = surface.triangles[t];
    return Facet{surface.vertices[c[0]], surface.vertices[c[1]], surface.vertices[c[2]]};
  };
  const Vec3 facing = facetOf(static_cast<std::size_t>(closest.triangle)).area().normalized();
  std::vector<Facet> pieces;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (const Facet facet = facetOf(t); facet.area().dot(facing) > 0) cut(facet, patch.middle_W, radius, radius / 5, pieces);
  Vec3 normal = Vec3::Zero();
  double area = 0;
  for (const Facet& piece : pieces) {
    if ((piece.middle() - patch.middle_W).norm() > radius) continue;
    patch.points_W.push_back(piece.middle());
    patch.weights.push_back(piece.area().norm());
    normal += piece.area();
    area += patch.weights.back();
  }
  patch.normal_W = normal.normalized();
  for (double& weight : patch.weights) weight /= area;
  return patch;
}

Result<TetMesh> embedGraded(const Part& part, const TipPatch& place, const GradedCells& cells) {
  const Grading grading(cells);
  Mat3 toFrame;
  toFrame.row(2) = place.normal_W;
  toFrame.row(0) = place.normal_W.unitOrthogonal();
  toFrame.row(1) = place.normal_W.cross(toFrame.row(0).transpose());
  const TriMesh visual = inCells(*part.visual, toFrame, place.middle_W, grading);
  const TriMesh collision = inCells(*part.collision, toFrame, place.middle_W, grading);
  auto mesh = embedInCells(visual, collision, 1.0);
  if (!mesh) return mesh.error();
  for (Vec3& node : mesh->nodes) {
    const Vec3 x(grading.toMetres(node.x()), grading.toMetres(node.y()), grading.toMetres(node.z()));
    node = toFrame.transpose() * x + place.middle_W;
  }
  return fitToSurface(*mesh, *part.visual);
}

}  // namespace glenoid
