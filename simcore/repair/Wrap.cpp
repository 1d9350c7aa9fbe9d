// SPDX-License-Identifier: GPL-3.0-or-later
// Knows CGAL, whose headers take long to read: it stands alone and is rarely touched.
#include "simcore/repair/Wrap.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <cmath>
#include <vector>

#include "simcore/mesh/MeshHealth.h"

namespace glenoid {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr double kWidths = 100;          ///< in a diagonal, of the width that is taken where none is given
constexpr double kOffsets = 30;          ///< in a width: how near the wrap lies
constexpr double kTrianglesPerWidth = 2.5;  ///< triangles that a square of one width is covered by, measured on balls and bands

TriMesh meshOf(const Surface& surface) {
  TriMesh mesh;
  for (const Surface::Vertex_index v : surface.vertices()) {
    const Kernel::Point_3& p = surface.point(v);
    mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const Surface::Face_index face : surface.faces()) {
    std::array<int, 3> corners{};
    int k = 0;
    for (const Surface::Vertex_index v : surface.vertices_around_face(surface.halfedge(face)))
      if (k < 3) corners[k++] = static_cast<int>(static_cast<Surface::size_type>(v));
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

/// Every vertex moved inwards, along the mean of its triangles' normals by their area.
TriMesh drawnBack(const TriMesh& mesh, double way) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles) {
    const Vec3 n = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    for (const int v : t) normals[v] += n;
  }
  TriMesh out = mesh;
  for (std::size_t v = 0; v < normals.size(); ++v)
    if (normals[v].squaredNorm() > 0) out.vertices[v] -= way * normals[v].normalized();
  return out;
}

}  // namespace

Result<TriMesh> wrapped(const TriMesh& mesh, double width) {
  const Box3 box = boundsOf(mesh);
  const double diagonal = box.isEmpty() ? 0 : box.sizes().norm();
  if (!(diagonal > 0) || mesh.triangles.empty()) return Error{Fault::BadMesh, {}, {"it has no extent that could be wrapped"}, "wrap"};
  const double wanted = width > 0 ? width : diagonal / kWidths;
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
  const double least = std::sqrt(kTrianglesPerWidth * area / static_cast<double>(kMostWrapTriangles));
  if (!(wanted >= least && wanted <= diagonal))
    return Error{Fault::OutOfRange, {}, {std::to_string(wanted), std::to_string(least), std::to_string(diagonal)}, "wrap"};

  // About its middle and of length one, so that nothing depends on the unit.
  std::vector<Kernel::Point_3> points;
  points.reserve(mesh.vertices.size());
  for (const Vec3& x : mesh.vertices) {
    const Vec3 p = (x - box.center()) / diagonal;
    points.emplace_back(p.x(), p.y(), p.z());
  }
  std::vector<std::array<std::size_t, 3>> faces;
  faces.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) faces.push_back({static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2])});
  const double alpha = wanted / diagonal, offset = alpha / kOffsets;
  Surface surface;
  CGAL::alpha_wrap_3(points, faces, alpha, offset, surface);
  TriMesh out = meshOf(surface);
  const TriMesh nearer = drawnBack(out, offset);
  if (healthOf(nearer).healthy() && countSelfIntersections(nearer) == 0) out = nearer;
  for (Vec3& x : out.vertices) x = diagonal * x + box.center();
  return out;
}

}  // namespace glenoid
