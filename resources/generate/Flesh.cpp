// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/Flesh.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/repair/Untangled.h"
#include "simcore/shape/Relax.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::generate {

namespace {

constexpr double kFar = 8;  // mm: farther than this from the tube a bound will do

void evenOut(TriMesh& mesh, const Flesh& flesh) {
  const int rings = flesh.around * flesh.along;  // the two ends come after them
  for (int round = 0; round < flesh.evenings; ++round) {
    const std::vector<Vec3> means = neighbourMeans(mesh);
    for (int i = 0; i < int(mesh.vertices.size()); ++i) {
      const double place = i < rings ? double(i / flesh.around) / (flesh.along - 1) : double(i - rings);
      const double weight = 1 - 0.82 * std::clamp((place - flesh.evenTo) / 0.2, 0.0, 1.0);
      mesh.vertices[i] += 0.5 * weight * (means[i] - mesh.vertices[i]);
    }
  }
}

TriMesh rawOf(const Flesh& flesh) {
  TriMesh raw = sweep(flesh.tube, flesh.around, flesh.along);
  evenOut(raw, flesh);
  return raw;
}

Field cutOf(const TriMesh& raw, const Flesh& flesh) {
  const auto tree = std::make_shared<const TriangleTree>(raw);
  return [tree, obstacles = flesh.obstacles, edge = flesh.edge](const Vec3& p) {
    const double reached = std::min(tree->closest(p, kFar).distance, kFar);
    double d = tree->inside(p) ? -reached : reached;
    if (d > edge + 1) return d;
    for (const Obstacle& o : obstacles) {
      const double inside = o.clearance - o.field(p);
      const double h = std::max(edge - std::abs(d - inside), 0.0) / edge;
      d = std::max(d, inside) + h * h * edge * 0.25;
    }
    return d;
  };
}

}  // namespace

Field fieldOf(const Flesh& flesh) {
  return cutOf(rawOf(flesh), flesh);
}

TriMesh surfaceOf(const Flesh& flesh, int triangles) {
  const TriMesh raw = rawOf(flesh);
  const Field shape = cutOf(raw, flesh);
  TriMesh simple;
  // A thin edge folds over itself on some grids and at some counts and not at others: the first sound surface is taken.
  for (const double finer : {1.0, 0.93}) {
    const double step = finer * flesh.step;
    Box3 box = boundsOf(raw);
    box.min() -= Vec3::Constant(2 * step);
    box.max() += Vec3::Constant(2 * step);
    TriMesh mesh = largestComponent(isosurface(shape, box, step));
    relax(mesh, shape, 3);
    for (int fewer = 0; fewer <= 16; fewer += 4) {
      simple = simplified(mesh, triangles - fewer);
      if (countSelfIntersections(simple) == 0) return simple;
    }
  }
  return untangled(std::move(simple));
}

double placeAlong(const std::vector<Station>& stations, const Vec3& p) {
  constexpr int kSteps = 400;
  double best = 1e300, place = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double s = double(i) / kSteps;
    const Station st = stationAt(stations, s);
    const double d = (st.base + 0.4 * st.thickness * st.up.normalized() - p).squaredNorm();
    if (d < best) best = d, place = s;
  }
  return place;
}

TriMesh simplified(const TriMesh& mesh, int triangles) {
  Result<TriMesh> answer = simplify(mesh, triangles);
  if (!answer) {
    // The shapes are constants of this program: a failure here is a bug in it, and there is no joint without
    // them.
    std::fprintf(stderr, "simplify: %s\n", toLogLine(answer.error()).c_str());
    std::abort();
  }
  return std::move(*answer);
}

}  // namespace glenoid::generate
