// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/ContactSpread.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

namespace {

double meanEdge(const SurfaceBinding& surface) {
  if (!surface.mesh || surface.mesh->triangles.empty()) return 0;
  double sum = 0;
  for (const auto& t : surface.mesh->triangles)
    for (int k = 0; k < 3; ++k) sum += (surface.mesh->vertices[t[k]] - surface.mesh->vertices[t[(k + 1) % 3]]).norm();
  return sum / (3.0 * static_cast<double>(surface.mesh->triangles.size()));
}

/// A visual surface as it is now.
struct Skin {
  std::vector<Vec3> at_W, normal_W;  ///< normals: unit; zero where all triangles around are flat
  std::vector<double> area;          ///< m²
  std::vector<double> force;         ///< N, what contacts have left
};

Skin skinOf(const SceneObject& object, const VecX& q) {
  Skin skin;
  const std::size_t count = object.visual.vertices.size();
  skin.at_W.resize(count);
  surfacePositions(object.visual, object.layout, q, skin.at_W);
  skin.normal_W.assign(count, Vec3::Zero());
  skin.area.assign(count, 0);
  skin.force.assign(count, 0);
  for (const auto& t : object.visual.mesh->triangles) {
    const Vec3 n = 0.5 * (skin.at_W[t[1]] - skin.at_W[t[0]]).cross(skin.at_W[t[2]] - skin.at_W[t[0]]);
    for (const int v : t) {
      skin.normal_W[v] += n;
      skin.area[v] += n.norm() / 3;
    }
  }
  for (Vec3& n : skin.normal_W)
    if (const double length = n.norm(); length > 0) n /= length;
  return skin;
}

void spread(Skin& skin, const Vec3& point, const Vec3& outwards, double force, double radius) {
  struct Share {
    std::size_t vertex;
    double weight;
  };
  std::vector<Share> shares;
  double sum = 0, least = INFINITY;
  std::size_t nearest = skin.at_W.size();
  for (std::size_t v = 0; v < skin.at_W.size(); ++v) {
    const double d2 = (skin.at_W[v] - point).squaredNorm();
    if (d2 < least && skin.area[v] > 0) least = d2, nearest = v;
    if (d2 >= radius * radius) continue;
    const double bell = 1 - d2 / (radius * radius), weight = skin.area[v] * std::max(0.0, skin.normal_W[v].dot(outwards)) * bell * bell;
    if (weight > 0) shares.push_back({v, weight}), sum += weight;
  }
  for (const Share& share : shares) skin.force[share.vertex] += force * share.weight / sum;
  if (shares.empty() && nearest < skin.at_W.size()) skin.force[nearest] += force;
}

}  // namespace

double spreadRadius(const SceneObject& object) { return std::max(1.5 * meanEdge(object.collision), 2 * meanEdge(object.visual)); }

std::vector<std::vector<float>> spreadContacts(const Model& model, const VecX& q, std::span<const ContactView> contacts) {
  std::vector<std::vector<float>> values(model.objects.size());
  std::vector<Skin> skins(model.objects.size());
  std::vector<double> radii(model.objects.size(), 0);
  const auto has = [&](int object) { return object >= 0 && object < static_cast<int>(model.objects.size()) && model.objects[object].visual.mesh; };
  const auto radiusOf = [&](int object) {
    if (!has(object)) return 0.0;
    if (radii[object] == 0) radii[object] = spreadRadius(model.objects[object]);
    return radii[object];
  };
  for (const ContactView& contact : contacts) {
    if (!(contact.force > 0) || !contact.point_W.allFinite() || !contact.normal_W.allFinite()) continue;
    const double radius = std::max(radiusOf(contact.objectA), radiusOf(contact.objectB));
    for (const bool first : {true, false}) {
      const int object = first ? contact.objectA : contact.objectB;
      if (!has(object) || model.objects[object].tool) continue;
      if (skins[object].at_W.empty()) skins[object] = skinOf(model.objects[object], q);
      // The normal leads from b to a: out of b, into a.
      spread(skins[object], contact.point_W, first ? Vec3(-contact.normal_W) : contact.normal_W, contact.force, radius);
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!has(static_cast<int>(i)) || model.objects[i].tool) continue;
    values[i].assign(model.objects[i].visual.vertices.size(), 0.0f);
    for (std::size_t v = 0; v < skins[i].force.size(); ++v)
      if (skins[i].force[v] > 0) values[i][v] = static_cast<float>(skins[i].force[v] / skins[i].area[v]);
  }
  return values;
}

double spreadSum(const Model& model, const VecX& q, const std::vector<std::vector<float>>& values, int object) {
  if (values[object].empty()) return 0;
  const Skin skin = skinOf(model.objects[object], q);
  double sum = 0;
  for (std::size_t v = 0; v < skin.area.size(); ++v) sum += skin.area[v] * values[object][v];
  return sum;
}

}  // namespace glenoid
