// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/spatial/TriangleTree.h"
#include "simcore/step/CompileObjects.h"

namespace glenoid {

namespace {

/// Which visual triangles a side of a bursa covers.
std::vector<char> covered(const Part& part, const BursaSide& side) {
  std::vector<char> inside(part.visual->triangles.size(), side.region.empty());
  if (const Region* region = findRegion(part, side.region); region && region->surface == SurfaceKind::Visual)
    for (const int t : trianglesOf(*region)) inside[t] = 1;
  return inside;
}

/// Collision vertices nearest to what the side covers.
std::vector<char> coveredVertices(const Part& part, const BursaSide& side) {
  const std::vector<char> visual = covered(part, side);
  const TriangleTree tree(*part.visual);
  std::vector<char> inside;
  for (const Vec3& p : part.collision->vertices) inside.push_back(visual[tree.closest(p).triangle]);
  return inside;
}

void addFloor(const Joint& joint, const BursaSide& side, FilmModel& film) {
  const int object = findPart(joint, side.part);  // parts come first, in the joint's order
  const Part& part = joint.parts[object];
  const std::vector<char> inside = coveredVertices(part, side);
  std::vector<char>& cover = film.floor[object];
  cover.resize(inside.size(), 0);
  for (std::size_t v = 0; v < inside.size(); ++v) {
    if (!inside[v] || cover[v]) continue;
    cover[v] = 1;
    film.sides.floor.push_back({object, static_cast<int>(v)});
  }
}

/// Triangles whose middle lies nearest to what the side covers.
void addRoof(const Joint& joint, const BursaSide& side, FilmModel& film) {
  const int object = findPart(joint, side.part);
  const Part& part = joint.parts[object];
  const std::vector<char> visual = covered(part, side);
  const TriangleTree tree(*part.visual);
  const TriMesh& mesh = *part.collision;
  std::vector<char>& cover = film.roof[object];
  cover.resize(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& c = mesh.triangles[t];
    const Vec3 middle = (mesh.vertices[c[0]] + mesh.vertices[c[1]] + mesh.vertices[c[2]]) / 3;
    if (!visual[tree.closest(middle).triangle]) continue;
    film.sides.roof.push_back({object, static_cast<int>(t)});
    for (const int v : c) cover[v] = 1;
  }
}

}  // namespace

std::vector<FilmModel> compileFilms(const Model& model) {
  std::vector<FilmModel> films;
  int keys = 0;
  for (const Bursa& bursa : model.joint.bursae) {
    FilmModel film;
    film.floor.resize(model.objects.size());
    film.roof.resize(model.objects.size());
    for (const BursaSide& side : bursa.floor) addFloor(model.joint, side, film);
    for (const BursaSide& side : bursa.roof) addRoof(model.joint, side, film);
    if (film.sides.floor.empty() || film.sides.roof.empty()) continue;
    film.id = bursa.id;
    film.firstKey = keys;
    keys += static_cast<int>(film.sides.floor.size());
    film.thickness = bursa.thickness;
    film.stiffnessPerArea = bursa.youngsModulus / bursa.thickness;
    film.damping = bursa.damping;
    film.friction = bursa.friction;
    films.push_back(std::move(film));
  }
  return films;
}

}  // namespace glenoid
