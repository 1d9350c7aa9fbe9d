// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/train/BoundPlace.h"

#include <algorithm>
#include <limits>
#include <map>

#include "simcore/embed/Bind.h"
#include "simcore/spatial/TrianglePoint.h"

namespace glenoid {
namespace {

constexpr double kAhead = 1e-3;  ///< m

Vec3 middleOf(const TriMesh& mesh) {
  Box3 box;
  for (const Vec3& x : mesh.vertices) box.extend(x);
  return box.isEmpty() ? Vec3::Zero() : Vec3(box.center());
}

int objectOfPart(const Model& model, const std::string& id) {
  for (std::size_t i = 0; i < model.objects.size(); ++i)
    if (!model.objects[i].tool && model.objects[i].id == id) return static_cast<int>(i);
  return -1;
}

Error unknown(const std::string& id, const char* kind) { return {Fault::UnknownId, {}, {id, kind}, "place of a task"}; }

}  // namespace

CarriedPoint::CarriedPoint(const Model& model, int object, const Vec3& rest) : m_object(object), m_rest(rest) {
  if (object < 0) return;
  const SceneObject& carrier = model.objects[object];
  VertexBinding binding;
  if (carrier.layout.rigid) {
    // A body's own frame is turned as its mesh's at rest, so its origin there is what any vertex says.
    const SurfaceBinding& surface = carrier.visual;
    binding.r_B = surface.vertices.empty() ? rest : Vec3(rest - surface.mesh->vertices.front() + surface.vertices.front().r_B);
  } else {
    binding = bindToTets(*carrier.volume, {&rest, 1}).front();
  }
  m_binding.vertices.push_back(binding);
}

Vec3 CarriedPoint::at(const Model& model, const VecX& q) const {
  if (m_object < 0) return m_rest;
  Vec3 x;
  surfacePositions(m_binding, model.objects[m_object].layout, q, {&x, 1});
  return x;
}

Result<BoundPlace> BoundPlace::bind(const Model& model, const TaskPlace& place) {
  BoundPlace bound(model);
  Vec3 rest = place.point_W.value_or(Vec3::Zero());
  if (!place.part.empty()) {
    bound.m_object = objectOfPart(model, place.part);
    if (bound.m_object < 0) return unknown(place.part, "part");
    const Part& part = model.joint.parts[findPart(model.joint, place.part)];
    const SceneObject& object = model.objects[bound.m_object];
    if (!place.landmark.empty()) {
      const auto found = std::find_if(part.landmarks.begin(), part.landmarks.end(), [&](const Landmark& l) { return l.id == place.landmark; });
      if (found == part.landmarks.end()) return unknown(place.landmark, "landmark");
      rest = found->position_W;
    } else if (!place.region.empty()) {
      const Region* region = findRegion(part, place.region);
      if (!region) return unknown(place.region, "region");
      const SurfaceBinding& surface = region->surface == SurfaceKind::Visual ? object.visual : object.collision;
      std::map<int, int> numbers;
      for (const int t : trianglesOf(*region)) {
        std::array<int, 3> corners;
        for (int k = 0; k < 3; ++k) {
          const int vertex = surface.mesh->triangles[t][k];
          const auto [entry, fresh] = numbers.try_emplace(vertex, static_cast<int>(bound.m_region.vertices.size()));
          if (fresh) bound.m_region.vertices.push_back(surface.vertices[vertex]);
          corners[k] = entry->second;
        }
        bound.m_triangles.push_back(corners);
      }
      if (bound.m_triangles.empty()) return unknown(place.region, "region");
    } else if (!place.point_W) {
      bound.m_anywhere = true;
      rest = middleOf(*object.visual.mesh);
    }
  }
  bound.m_point = CarriedPoint(model, bound.m_object, rest);
  if (place.normal_W) bound.m_ahead = CarriedPoint(model, bound.m_object, rest + kAhead * place.normal_W->normalized());
  return bound;
}

Vec3 BoundPlace::point(const VecX& q) const {
  if (m_triangles.empty()) return m_point.at(*m_model, q);
  std::vector<Vec3> corners(m_region.vertices.size());
  surfacePositions(m_region, m_model->objects[m_object].layout, q, corners);
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : corners) sum += x;
  return sum / static_cast<double>(corners.size());
}

double BoundPlace::distanceTo(const Vec3& touched_W, const VecX& q) const {
  if (m_anywhere) return 0;
  if (m_triangles.empty()) return (m_point.at(*m_model, q) - touched_W).norm();
  std::vector<Vec3> corners(m_region.vertices.size());
  surfacePositions(m_region, m_model->objects[m_object].layout, q, corners);
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : m_triangles) {
    const Vec3 w = nearestBarycentric(touched_W, corners[a], corners[b], corners[c]);
    nearest = std::min(nearest, (w[0] * corners[a] + w[1] * corners[b] + w[2] * corners[c] - touched_W).norm());
  }
  return nearest;
}

Vec3 BoundPlace::normal(const VecX& q) const { return (m_ahead.at(*m_model, q) - m_point.at(*m_model, q)).normalized(); }

}  // namespace glenoid
