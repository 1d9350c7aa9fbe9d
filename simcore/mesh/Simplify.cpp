// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/Simplify.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "simcore/mesh/Cleanup.h"
#include "simcore/mesh/Collapse.h"
#include "simcore/mesh/MeshHealth.h"

namespace glenoid {
namespace {

/// Importance of the vertices of a surface whose vertices are some of the first one's: by place.
std::vector<double> importanceOf(const TriMesh& some, const TriMesh& all, const std::vector<double>& importance) {
  if (importance.empty()) return {};
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::map<Vec3, double, decltype(less)> at(less);
  for (std::size_t v = 0; v < all.vertices.size(); ++v) {
    double& value = at.try_emplace(all.vertices[v], importance[v]).first->second;
    value = std::max(value, importance[v]);
  }
  std::vector<double> out;
  for (const Vec3& p : some.vertices) out.push_back(at.at(p));
  return out;
}

}  // namespace

TriMesh roughlySimplified(const TriMesh& mesh, int target) {
  const Box3 box = boundsOf(mesh);
  const double scale = box.diagonal().norm();
  std::vector<float> positions;
  positions.reserve(3 * mesh.vertices.size());
  for (const Vec3& v : mesh.vertices)
    for (int i = 0; i < 3; ++i) positions.push_back(static_cast<float>((v[i] - box.center()[i]) / scale));
  std::vector<unsigned> indices;
  indices.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    for (const int i : t) indices.push_back(static_cast<unsigned>(i));
  std::vector<unsigned> out(indices.size());
  const std::size_t count =
      meshopt_simplify(out.data(), indices.data(), indices.size(), positions.data(), mesh.vertices.size(),
                       3 * sizeof(float), 3 * static_cast<std::size_t>(target), 0.05f, 0, nullptr);
  TriMesh reduced;
  reduced.vertices = mesh.vertices;
  for (std::size_t i = 0; i + 2 < count; i += 3)
    reduced.triangles.push_back(
        {static_cast<int>(out[i]), static_cast<int>(out[i + 1]), static_cast<int>(out[i + 2])});
  return compact(reduced);
}

namespace {

/// First reduction of a large surface. The answer counts only when it kept closedness and topology.
TriMesh reduceLarge(const TriMesh& mesh, int target) {
  const TriMesh reduced = roughlySimplified(mesh, target);
  const MeshHealth before = healthOf(mesh), after = healthOf(reduced);
  const bool kept = after.closed() && after.manifold() && after.genus == before.genus &&
                    after.components == before.components;
  return kept ? reduced : mesh;
}

std::vector<Vec3> areaVectors(const TriMesh& mesh) {
  std::vector<Vec3> sums(mesh.vertices.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles) {
    const Vec3 vector =
        (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]) / 2;
    for (const int i : t) sums[i] += vector;
  }
  return sums;
}

/// Shifts all vertices by one distance along their normals until the volume is `wanted`: Newton on a cubic
/// that is nearly straight. Given up when that would make the surface cut itself.
TriMesh withVolume(const TriMesh& mesh, double wanted) {
  const std::vector<Vec3> start = areaVectors(mesh);
  TriMesh moved = mesh;
  double distance = 0;
  for (int i = 0; i < 8; ++i) {
    const std::vector<Vec3> vectors = areaVectors(moved);
    double slope = 0;
    for (std::size_t v = 0; v < vectors.size(); ++v) slope += vectors[v].dot(start[v].normalized()) / 3;
    if (!(slope > 0)) return mesh;
    distance += (wanted - enclosedVolume(moved)) / slope;
    for (std::size_t v = 0; v < vectors.size(); ++v)
      moved.vertices[v] = mesh.vertices[v] + distance * start[v].normalized();
  }
  const bool reached = std::abs(enclosedVolume(moved) - wanted) < 1e-9 * wanted;
  return reached && countSelfIntersections(moved) <= countSelfIntersections(mesh) ? moved : mesh;
}

}  // namespace

Result<TriMesh> simplify(const TriMesh& mesh, int targetTriangles, const SimplifyOptions& options) {
  if (targetTriangles < 4)
    return Error{
        Fault::OutOfRange, {}, {std::to_string(targetTriangles), "4", "inf"}, "triangles to simplify to"};
  if (const auto closed = requireClosed(mesh); !closed) return closed.error();
  if (!options.importance.empty() && options.importance.size() != mesh.vertices.size())
    return Error{Fault::BadIndex,
                 {},
                 {std::to_string(options.importance.size()), std::to_string(mesh.vertices.size())},
                 "importance of vertices"};
  for (const double each : options.importance)
    if (!(each > 0) || !std::isfinite(each))
      return Error{Fault::OutOfRange, {}, {std::to_string(each), "0", "inf"}, "importance of a vertex"};
  if (static_cast<int>(mesh.triangles.size()) <= targetTriangles) return mesh;

  // Collapsing edges one by one is slow, so the larger the surface the more of it goes the quick way.
  const bool huge = static_cast<int>(mesh.triangles.size()) > 5 * options.largeMesh;
  const int first = std::max(options.largeMesh / (huge ? 4 : 2), (huge ? 4 : 2) * targetTriangles);
  const bool large = static_cast<int>(mesh.triangles.size()) > std::max(options.largeMesh, 2 * first);
  const TriMesh begun = large ? reduceLarge(mesh, first) : compact(mesh);
  Collapser collapser(begun, importanceOf(begun, mesh, options.importance));
  // Shape first; then the count. A cut through itself only when nothing else reaches it, as with a surface
  // that cuts itself to begin with.
  const CollapseRules strict, loose{0.0, 0.05, -0.9, 0.1, false}, last{-0.2, 0.01, -0.99, 0.2, false},
      any{-1, 1e-3, -1, 0.5, true};
  // Far from the goal the triangles of a huge surface are small beside its features: none will come to cut another.
  if (huge) collapser.run(first, CollapseRules{strict.minTurn, strict.minShape, strict.minDihedral, strict.maxVolumeLoss, true});
  for (const CollapseRules& rules : {strict, loose, last, any}) collapser.run(targetTriangles, rules);
  const TriMesh result = collapser.result();
  return options.keepVolume ? withVolume(result, enclosedVolume(mesh)) : result;
}

}  // namespace glenoid
