// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MakeBody.h"

#include <algorithm>
#include <cmath>

#include "simcore/embed/Fill.h"
#include "simcore/linear/BlockSymbolic.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

/// Points of a surface at which it is compared; an even choice where there are more than this.
constexpr std::size_t kMostPoints = 40000;

std::vector<Vec3> pointsOf(const TriMesh& mesh) {
  const std::size_t all = mesh.vertices.size() + mesh.triangles.size(), step = 1 + all / kMostPoints;
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < all; i += step) {
    if (i < mesh.vertices.size()) {
      points.push_back(mesh.vertices[i]);
    } else {
      const auto& t = mesh.triangles[i - mesh.vertices.size()];
      points.push_back((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3);
    }
  }
  return points;
}

void compare(const TriMesh& visual, const TriMesh& collision, BodyFigures& figures) {
  const TriangleTree visualTree(visual), collisionTree(collision);
  const std::vector<Vec3> ofCollision = pointsOf(collision);
  for (const Vec3& p : ofCollision) {
    const double distance = visualTree.closest(p).distance;
    figures.deviationMax = std::max(figures.deviationMax, distance);
    figures.deviationMean += distance / static_cast<double>(ofCollision.size());
  }
  for (const Vec3& p : pointsOf(visual))
    figures.deviationMax = std::max(figures.deviationMax, collisionTree.closest(p).distance);
}

}  // namespace

Result<Body> makeBody(const Part& part, const BodyWish& wish, const IsStale& isStale) {
  const auto named = [&part](Error error) {
    error.place.part = part.id;
    return error;
  };
  const auto stale = [&isStale] { return isStale && isStale(); };
  const Error cancelled{Fault::Cancelled, {}, {}, "making a body"};
  if (!part.visual)
    return Error{Fault::BadMesh, {{}, {}, part.id, {}}, {"no visual surface"}, "making a body"};
  if (const auto closed = requireClosed(*part.visual, part.id); !closed) return closed.error();
  if (stale()) return cancelled;
  Body body;
  const int count = static_cast<int>(part.visual->triangles.size());
  if (wish.collision) {
    body.collision = wish.collision;
  } else if (wish.collisionTriangles == 0 || wish.collisionTriangles >= count) {
    body.collision = part.visual;
  } else {
    SimplifyOptions options;
    options.importance = wish.importance;
    auto simple = simplify(*part.visual, wish.collisionTriangles, options);
    if (!simple) return named(simple.error());
    body.collision = std::make_shared<const TriMesh>(std::move(*simple));
  }
  if (stale()) return cancelled;
  BodyFigures& figures = body.figures;
  figures.visualTriangles = count;
  figures.collisionTriangles = static_cast<int>(body.collision->triangles.size());
  if (body.collision != part.visual) compare(*part.visual, *body.collision, figures);
  const double volume = enclosedVolume(*part.visual);
  figures.volumeError = enclosedVolume(*body.collision) / volume - 1;
  figures.thinnest = 2 * volume / healthOf(*part.visual).area;
  if (wish.kind == PartKind::Rigid) return body;

  if (stale()) return cancelled;
  CellGrid grid;
  if (wish.axes == GridAxes::Principal) grid.frame.q_WB = principalAxes(*part.visual);
  grid.cell = Vec3::Constant(wish.cellSize);
  auto tets = embedInCells(*part.visual, *body.collision, grid);
  if (!tets) return named(tets.error());
  if (stale()) return cancelled;
  body.volume = std::make_shared<const TetMesh>(std::move(*tets));
  figures.tetrahedra = static_cast<int>(body.volume->tets.size());
  figures.nodes = static_cast<int>(body.volume->nodes.size());
  faceComponents(*body.volume, &figures.pieces);
  const std::vector<double> enclosed = enclosedVolumes(*body.volume, *part.visual);
  double whole = 0;
  figures.leastFill = 1;
  for (int t = 0; t < figures.tetrahedra; ++t) {
    const double each = tetVolume(*body.volume, t);
    whole += each;
    figures.leastFill = std::min(figures.leastFill, std::max(0.0, enclosed[t] / each));
  }
  figures.meanFill = volume / whole;
  if (stale()) return cancelled;
  figures.stepMs = expectedStepMs(*body.volume);
  return body;
}

Part withBody(const Part& part, const BodyWish& wish, const Body& body) {
  Part out = part;
  out.kind = wish.kind;
  out.collision = body.collision;
  out.volume = wish.kind == PartKind::Soft ? body.volume : nullptr;
  out.cellSize = wish.kind == PartKind::Soft ? wish.cellSize : 0;
  if (body.collision == part.collision || !part.collision ||
      (part.collision && *body.collision == *part.collision))
    return out;
  const TriangleTree old(*part.collision);
  std::vector<int> nearest;
  for (const auto& t : body.collision->triangles) {
    const auto& v = body.collision->vertices;
    nearest.push_back(old.closest((v[t[0]] + v[t[1]] + v[t[2]]) / 3).triangle);
  }
  for (Region& region : out.regions) {
    if (region.surface != SurfaceKind::Collision) continue;
    const std::vector<int> had = trianglesOf(region);
    std::vector<int> has;
    for (std::size_t t = 0; t < nearest.size(); ++t)
      if (std::binary_search(had.begin(), had.end(), nearest[t])) has.push_back(static_cast<int>(t));
    region.triangles = runsOf(has);
  }
  std::erase_if(out.regions, [](const Region& region) {
    return region.surface == SurfaceKind::Collision && region.triangles.empty();
  });
  return out;
}

double expectedStepMs(const TetMesh& volume) {
  constexpr double kPerTetrahedron = 1.1e-4, kPerProduct = 2.9e-6, kPerBlock = 6e-6;  // ms
  std::vector<std::array<int, 2>> pairs;
  for (const auto& tet : volume.tets)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) pairs.push_back({std::max(tet[i], tet[j]), std::min(tet[i], tet[j])});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  const BlockSymbolic symbolic(static_cast<int>(volume.nodes.size()), pairs);
  return kPerTetrahedron * static_cast<double>(volume.tets.size()) +
         kPerProduct * static_cast<double>(symbolic.updateCount()) + kPerBlock * symbolic.slotCount();
}

}  // namespace glenoid
