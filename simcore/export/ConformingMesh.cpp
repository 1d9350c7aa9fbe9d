// SPDX-License-Identifier: GPL-3.0-or-later
// The one file that knows CGAL: a minute to compile, so it stands alone and is rarely touched.
#include "simcore/export/ConformingMesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "simcore/export/SharpCurves.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/TetTools.h"

namespace glenoid {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, Surface>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

constexpr double kLeastCurve = 4;           ///< edges of the mesh that creases must be long to be kept
constexpr double kFacetAngle = 25;          ///< °, least of boundary faces; up to 30 the refinement is proved to end
constexpr double kRadiusPerEdge = 2.5;      ///< circumradius over the shortest edge; above 2 the refinement is proved to end
constexpr double kFlat = 1e-6;              ///< edges³: no volume; a regular tetrahedron has 0.12
constexpr double kMostOff = 0.2;            ///< of the part's volume: coarser than this it is another part
// Criteria bound circumradii from above; the mean of what comes out is some three quarters of its bound, and a regular
// tetrahedron has 0.61 of its edge, a regular triangle 0.58.
constexpr double kCellRadius = 0.8, kFacetRadius = 0.75;  ///< of the edge that is meant

Error badMesh(const std::string& part, const std::string& what) { return {Fault::BadMesh, {{}, {}, part, {}}, {what}, "conforming"}; }

/// Nodes that edges of this length ask for: those of a lattice of regular tetrahedra, inside and on the surface.
double nodesOf(double volume, double area, double edge) { return 1.4 * volume / std::pow(edge, 3) + 0.6 * area / (edge * edge); }

std::string millimetres(double metres) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g mm", 1e3 * metres);
  return text;
}

/// The surface about its middle, in edges of the mesh to come.
Surface scaled(const TriMesh& mesh, const Vec3& middle, double edge) {
  Surface surface;
  std::vector<Surface::Vertex_index> corner;
  for (const Vec3& x : mesh.vertices) {
    const Vec3 p = (x - middle) / edge;
    corner.push_back(surface.add_vertex({p.x(), p.y(), p.z()}));
  }
  for (const auto& t : mesh.triangles) surface.add_face(corner[t[0]], corner[t[1]], corner[t[2]]);
  return surface;
}

TetMesh tetsOf(const Complex& complex, const Vec3& middle, double edge) {
  TetMesh mesh;
  std::map<Triangulation::Vertex_handle, int> known;  // ordered by when a vertex was made, not by where it lies in memory
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell) {
    std::array<int, 4> tet{};
    for (int k = 0; k < 4; ++k) {
      const auto [entry, fresh] = known.try_emplace(cell->vertex(k), static_cast<int>(mesh.nodes.size()));
      if (fresh) {
        const auto& p = cell->vertex(k)->point();
        mesh.nodes.push_back(middle + edge * Vec3(p.x(), p.y(), p.z()));
      }
      tet[k] = entry->second;
    }
    mesh.tets.push_back(tet);
  }
  return mesh;
}

/// Four nodes on a flat side of the part may make a tetrahedron without volume. It goes: what lies behind it has the same outside.
/// Whether any went; another may lie behind.
bool dropFlat(TetMesh& mesh, double edge) {
  std::map<std::array<int, 3>, int> uses;
  const auto face = [](const std::array<int, 4>& tet, int without) {
    std::array<int, 3> key{};
    for (int k = 0, n = 0; k < 4; ++k)
      if (k != without) key[n++] = tet[k];
    std::sort(key.begin(), key.end());
    return key;
  };
  for (const auto& tet : mesh.tets)
    for (int k = 0; k < 4; ++k) ++uses[face(tet, k)];
  std::vector<std::array<int, 4>> kept;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    int outside = 0;
    for (int k = 0; k < 4; ++k) outside += uses[face(mesh.tets[t], k)] == 1;
    if (outside < 2 || tetVolume(mesh, static_cast<int>(t)) > kFlat * edge * edge * edge) kept.push_back(mesh.tets[t]);
  }
  mesh.tets.swap(kept);
  return mesh.tets.size() < kept.size();
}

Result<TetMesh> meshed(const TriMesh& mesh, const TetSize& size, double expected, const std::string& part, const std::atomic<bool>* stop) {
  namespace wish = CGAL::parameters;
  const Vec3 middle = boundsOf(mesh).center();
  const Surface surface = scaled(mesh, middle, size.edge);
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});  // what it would print is in the exception
  CGAL::get_default_random() = CGAL::Random(0);
  CGAL::Random chance(0);
  Domain domain(surface, &chance);
  std::vector<std::vector<Kernel::Point_3>> curves;
  for (const std::vector<int>& curve : exporting::sharpCurves(mesh, kLeastCurve * size.edge)) {
    auto& points = curves.emplace_back();
    for (const int vertex : curve) points.push_back(surface.point(Surface::Vertex_index(static_cast<unsigned>(vertex))));
  }
  domain.add_features(curves.begin(), curves.end());
  const Criteria criteria(wish::edge_size = 1.0, wish::facet_angle = kFacetAngle, wish::facet_size = kFacetRadius,
                          wish::facet_distance = size.distance / size.edge, wish::cell_radius_edge_ratio = kRadiusPerEdge,
                          wish::cell_size = kCellRadius);
  std::atomic<bool> never{false};
  CGAL::Mesh_error_code trouble = CGAL::CGAL_MESH_3_NO_ERROR;
  // The step that follows the refinement has no limit of time: what comes out would depend on the machine.
  const Complex complex = CGAL::make_mesh_3<Complex>(
      domain, criteria, wish::no_perturb(), wish::exude(wish::time_limit = 0),
      wish::mesh_3_options(wish::maximal_number_of_vertices = static_cast<std::size_t>(std::min<double>(kMostTetNodes, 2000 + 20 * expected)),
                           wish::pointer_to_error_code = &trouble,
                           wish::pointer_to_stop_atomic_boolean = stop ? const_cast<std::atomic<bool>*>(stop) : &never));
  if (stop && *stop) return Error{Fault::Cancelled, {}, {}, "conforming"};
  if (trouble != CGAL::CGAL_MESH_3_NO_ERROR)
    return badMesh(part, "tetrahedra of " + millimetres(size.edge) + " within " + millimetres(size.distance) +
                             " of its surface become too many; its folds are too sharp, or the distance is too small");
  TetMesh tets = tetsOf(complex, middle, size.edge);
  while (dropFlat(tets, size.edge)) {
  }
  return tets;
}

}  // namespace

TetSize chosenSize(const TriMesh& surface, const TetSize& wish) {
  TetSize size = wish;
  if (!(size.edge > 0)) {
    const MeshHealth health = healthOf(surface);
    size.edge = health.area > 0 ? 2.0 / 3 * 2 * std::abs(health.volume) / health.area : 0;
  }
  if (!(size.distance > 0)) size.distance = 0.1 * size.edge;
  return size;
}

Result<TetMesh> conformingMesh(const TriMesh& surface, const TetSize& wish, const std::string& part, const std::atomic<bool>* stop) {
  if (const auto closed = requireClosed(surface, part); !closed) return closed.error();
  const MeshHealth health = healthOf(surface);
  if (health.degenerateTriangles > 0)
    return badMesh(part, "triangles of its surface have no area: " + std::to_string(health.degenerateTriangles) + "; repair them first");
  if (const int cuts = countSelfIntersections(surface); cuts > 0)
    return badMesh(part, "its surface cuts itself in " + std::to_string(cuts) + " places, so inside and outside are not told apart; repair them first");
  const TetSize size = chosenSize(surface, wish);
  double finest = boundsOf(surface).sizes().maxCoeff();
  const double longest = finest;
  while (nodesOf(health.volume, health.area, 0.95 * finest) < kMostTetNodes) finest *= 0.95;
  if (!(size.edge >= finest && size.edge <= longest))
    return Error{Fault::OutOfRange, {{}, {}, part, {}}, {millimetres(size.edge), millimetres(finest), millimetres(longest)}, "size of tetrahedra"};
  try {
    // Round-off can turn a flat tetrahedron over; a size next to the one that is meant has others.
    for (const double share : {1.0, 0.97, 0.94}) {
      Result<TetMesh> mesh = meshed(surface, {share * size.edge, size.distance}, nodesOf(health.volume, health.area, size.edge), part, stop);
      if (!mesh) return mesh;
      if (!mesh->tets.empty() && healthOf(*mesh).healthy() && std::abs(totalVolume(*mesh) / health.volume - 1) < kMostOff) return mesh;
    }
    return badMesh(part, "no sound tetrahedra of " + millimetres(size.edge) + " come of its surface; choose smaller ones");
  } catch (const std::exception& error) {  // a condition of the library's that did not hold
    Error failed = badMesh(part, "its surface cannot be filled with tetrahedra; repair it, or choose another size");
    failed.detail = error.what();
    return failed;
  }
}

}  // namespace glenoid
