// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/PartMass.h"

#include <Eigen/LU>
#include <cmath>
#include <map>

#include "simcore/base/PlainMath.h"

namespace glenoid {

namespace {

/// Closed surface around the layer under a region.
TriMesh layerUnder(const TriMesh& surface, const std::vector<int>& triangles, double thickness) {
  std::map<int, int> index;  // of the outer vertex; the inner one follows it
  std::vector<Vec3> normals;
  TriMesh layer;
  for (const int t : triangles)
    for (const int v : surface.triangles[t])
      if (index.try_emplace(v, 2 * static_cast<int>(index.size())).second) normals.push_back(Vec3::Zero());
  for (const int t : triangles) {
    const auto& corner = surface.triangles[t];
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = surface.vertices[corner[(i + 1) % 3]] - surface.vertices[corner[i]],
                 b = surface.vertices[corner[(i + 2) % 3]] - surface.vertices[corner[i]];
      const Vec3 area = a.cross(b);
      if (area.norm() > 0) normals[index[corner[i]] / 2] += plain::arcTangent(area.norm(), a.dot(b)) * area.normalized();
    }
  }
  layer.vertices.resize(2 * normals.size());
  for (const auto& [vertex, at] : index) {
    layer.vertices[at] = surface.vertices[vertex];
    layer.vertices[at + 1] = surface.vertices[vertex] - thickness * normals[at / 2].normalized();
  }
  std::map<std::array<int, 2>, bool> edges;  // directed
  for (const int t : triangles) {
    const auto& corner = surface.triangles[t];
    const int a = index[corner[0]], b = index[corner[1]], c = index[corner[2]];
    layer.triangles.push_back({a, b, c});
    layer.triangles.push_back({a + 1, c + 1, b + 1});
    for (const auto& edge : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) edges[edge] = true;
  }
  for (const auto& [edge, there] : edges) {
    if (edges.count({edge[1], edge[0]})) continue;
    layer.triangles.push_back({edge[1], edge[0], edge[0] + 1});
    layer.triangles.push_back({edge[1], edge[0] + 1, edge[1] + 1});
  }
  return layer;
}

/// Inertia about the origin of W.
Mat3 aboutOrigin(const MassProperties& body, double sign) {
  const Vec3& c = body.centre;
  return sign * (body.inertia + body.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose()));
}

}  // namespace

Result<MassProperties> massPropertiesOf(const Joint& joint, const Part& part) {
  const auto fault = [&part](Fault kind, Arguments arguments) { return Error{kind, {"", "", part.id, {}}, std::move(arguments), ""}; };
  if (part.materials.empty()) return fault(Fault::Unusable, {"no material"});
  const int first = findMaterial(joint, part.materials[0].material);
  if (first < 0) return fault(Fault::UnknownId, {part.materials[0].material, "material"});
  const double density = joint.materials[first].density;
  Result<MassProperties> whole = massPropertiesOf(*part.visual, density);
  if (!whole) {
    whole.error().place.part = part.id;
    return whole;
  }
  double mass = whole->mass;
  Vec3 moment = whole->mass * whole->centre;
  Mat3 inertia = aboutOrigin(*whole, 1);
  bool layered = false;
  for (const MaterialUse& use : part.materials) {
    if (!(use.thickness > 0)) continue;
    const int material = findMaterial(joint, use.material);
    if (material < 0) return fault(Fault::UnknownId, {use.material, "material"});
    const Region* region = findRegion(part, use.region);
    if (!region) return fault(Fault::UnknownId, {use.region, "region"});
    const double difference = joint.materials[material].density - density;
    if (difference == 0) continue;
    const TriMesh& surface = region->surface == SurfaceKind::Visual ? *part.visual : *part.collision;
    const Result<MassProperties> layer = massPropertiesOf(layerUnder(surface, trianglesOf(*region), use.thickness), std::abs(difference));
    if (!layer) return fault(Fault::BadMesh, {"the layer under the region “" + use.region + "” encloses no positive volume"});
    const double sign = difference < 0 ? -1 : 1;
    mass += sign * layer->mass;
    moment += sign * layer->mass * layer->centre;
    inertia += aboutOrigin(*layer, sign);
    layered = true;
  }
  if (!layered) return whole;  // to the bit
  const Vec3 centre = moment / mass;
  const Mat3 central = inertia - mass * (centre.squaredNorm() * Mat3::Identity() - centre * centre.transpose());
  // A layer thicker than the body it lies on leaves nothing that could be turned.
  if (!(mass > 0) || !(central.trace() > 0) || !(central.determinant() > 0)) return fault(Fault::BadMesh, {"its layers leave no positive mass"});
  return MassProperties{mass, centre, central};
}

}  // namespace glenoid
