// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Occlusion.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <thread>

#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

constexpr double kLift = 2e-4;                 ///< m from the surface to where its rays begin
constexpr double kStill = 4e-3, kGone = 16e-3; ///< m of relative motion over which an occluder fades
constexpr int kChunk = 256;                    ///< receivers that a thread takes at once

bool counts(const ObjectGeometry& object) { return !object.tool && object.visual.present; }

/// Directions about +Z whose projections are spread evenly over the unit disc (Vogel's spiral).
std::array<Vec3, kOcclusionRays> directions() {
  std::array<Vec3, kOcclusionRays> list;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int k = 0; k < kOcclusionRays; ++k) {
    const double r2 = (k + 0.5) / kOcclusionRays, r = std::sqrt(r2);
    list[k] = {r * std::cos(golden * k), r * std::sin(golden * k), std::sqrt(1 - r2)};
  }
  return list;
}

struct Occluder {
  int object;
  Box3 reach;  ///< grown by the rays' reach
  std::unique_ptr<TriangleTree> tree;
};

}  // namespace

Occlusion::Occlusion(const SceneGeometry& scene, const VecX& q, int threads, const std::atomic<bool>& cancelled) {
  m_at.assign(scene.vertices.size(), Eigen::Vector3f::Zero());
  m_corners.resize(scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const ObjectGeometry& object = scene.objects[i];
    if (!counts(object)) continue;
    const Range vertices = object.visual.vertices, indices = object.visual.triangles;
    for (int v = vertices.first; v < vertices.first + vertices.count; ++v)
      m_at[v] = positionOf(scene.vertices[v], q).cast<float>();
    m_indices.insert(m_indices.end(), scene.indices.begin() + indices.first, scene.indices.begin() + indices.first + indices.count);
    for (int axis = 0; axis < 3; ++axis)
      for (const float sign : {-1.0f, 1.0f}) {
        int best = vertices.first;
        for (int v = vertices.first; v < vertices.first + vertices.count; ++v)
          if (sign * m_at[v][axis] > sign * m_at[best][axis]) best = v;
        m_corners[i].push_back(best);
      }
  }
  castAll(scene, threads, cancelled);
}

void Occlusion::castAll(const SceneGeometry& scene, int threads, const std::atomic<bool>& cancelled) {
  std::vector<Occluder> occluders;
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
    const ObjectGeometry& object = scene.objects[i];
    if (!counts(object)) continue;
    TriMesh mesh;
    Occluder occluder{i, {}, nullptr};
    const Range vertices = object.visual.vertices;
    for (int v = vertices.first; v < vertices.first + vertices.count; ++v) {
      mesh.vertices.push_back(m_at[v].cast<double>());
      occluder.reach.extend(mesh.vertices.back());
      m_receivers.push_back({v, i, {}});
    }
    for (int k = object.visual.triangles.first; k < object.visual.triangles.first + object.visual.triangles.count; k += 3) {
      const auto at = [&](int corner) { return static_cast<int>(scene.indices[k + corner]) - vertices.first; };
      mesh.triangles.push_back({at(0), at(1), at(2)});
    }
    if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Vec3& x) { return x.allFinite(); })) continue;
    occluder.reach.min() -= Vec3::Constant(kOcclusionReach);
    occluder.reach.max() += Vec3::Constant(kOcclusionReach);
    occluder.tree = std::make_unique<TriangleTree>(mesh);
    occluders.push_back(std::move(occluder));
  }

  const std::array<Vec3, kOcclusionRays> sky = directions();
  const auto cast = [&](Receiver& receiver, std::vector<Hit>& hits) {
    const Vec3 p = m_at[receiver.vertex].cast<double>();
    Vec3 n = Vec3::Zero();
    const auto [first, count] = scene.rings[receiver.vertex];
    for (int r = first; r < first + count; ++r) {
      const auto& other = scene.neighbours[r];
      n += (m_at[other[0]].cast<double>() - p).cross(m_at[other[1]].cast<double>() - p);
    }
    const double length = n.norm();
    if (!(length > 0) || !p.allFinite()) return;
    n /= length;
    const Vec3 side = n.unitOrthogonal(), third = n.cross(side), from = p + kLift * n;
    for (int k = 0; k < kOcclusionRays; ++k) {
      const Vec3 direction = sky[k].x() * side + sky[k].y() * third + sky[k].z() * n;
      for (const Occluder& occluder : occluders) {
        if (!occluder.reach.contains(from)) continue;
        const auto hit = occluder.tree->cast(from, direction, kOcclusionReach);
        if (!hit) continue;
        const double near = 1 - hit->distance / kOcclusionReach;
        hits.push_back({static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(std::lround(255 * near)),
                        static_cast<std::uint16_t>(occluder.object)});
      }
    }
  };

  // Chunks are taken by whoever is free and put together in their order.
  const int chunks = (static_cast<int>(m_receivers.size()) + kChunk - 1) / kChunk;
  std::vector<std::vector<Hit>> found(chunks);
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int chunk = next++; chunk < chunks && !cancelled; chunk = next++)
      for (int i = chunk * kChunk; i < std::min<int>((chunk + 1) * kChunk, static_cast<int>(m_receivers.size())); ++i) {
        m_receivers[i].hits.first = static_cast<int>(found[chunk].size());
        cast(m_receivers[i], found[chunk]);
        m_receivers[i].hits.count = static_cast<int>(found[chunk].size()) - m_receivers[i].hits.first;
      }
  };
  std::vector<std::thread> helpers;
  for (int t = 1; t < std::min(threads, chunks); ++t) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  for (int chunk = 0; chunk < chunks; ++chunk) {
    for (int i = chunk * kChunk; i < std::min<int>((chunk + 1) * kChunk, static_cast<int>(m_receivers.size())); ++i)
      m_receivers[i].hits.first += static_cast<int>(m_hits.size());
    m_hits.insert(m_hits.end(), found[chunk].begin(), found[chunk].end());
  }
}

bool Occlusion::holdsFor(const SceneGeometry& scene, const VecX& q) const {
  if (m_at.size() != scene.vertices.size() || m_corners.size() != scene.objects.size()) return false;
  std::size_t index = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const ObjectGeometry& object = scene.objects[i];
    if (counts(object) == m_corners[i].empty()) return false;
    if (!counts(object)) continue;
    for (int v = object.visual.vertices.first; v < object.visual.vertices.first + object.visual.vertices.count; ++v)
      if (positionOf(scene.vertices[v], q).cast<float>() != m_at[v]) return false;
    for (int k = 0; k < object.visual.triangles.count; ++k, ++index)
      if (index >= m_indices.size() || m_indices[index] != scene.indices[object.visual.triangles.first + k]) return false;
  }
  return index == m_indices.size();
}

std::vector<float> Occlusion::openness(const SceneGeometry& scene, std::span<const float> presence) const {
  const int objects = static_cast<int>(scene.objects.size());
  std::vector<float> open(scene.vertices.size(), 1.0f);
  for (const Receiver& receiver : m_receivers) {
    const float* present = presence.data() + static_cast<std::ptrdiff_t>(receiver.object) * objects;
    float hidden = 0;
    for (int h = receiver.hits.first, last = h + receiver.hits.count; h < last;) {
      const std::uint8_t ray = m_hits[h].ray;
      float strongest = 0;
      for (; h < last && m_hits[h].ray == ray; ++h)
        strongest = std::max(strongest, present[m_hits[h].object] * static_cast<float>(m_hits[h].strength));
      hidden += strongest;
    }
    open[receiver.vertex] = 1 - hidden / (255.0f * kOcclusionRays);
  }
  // Few rays are coarse: each vertex takes half from its neighbours.
  std::vector<float> even = open;
  for (const Receiver& receiver : m_receivers) {
    const auto [first, count] = scene.rings[receiver.vertex];
    if (count == 0) continue;
    float sum = 0;
    for (int r = first; r < first + count; ++r) sum += open[scene.neighbours[r][0]] + open[scene.neighbours[r][1]];
    even[receiver.vertex] = 0.5f * open[receiver.vertex] + 0.25f * sum / static_cast<float>(count);
  }
  return even;
}

Vec3 Occlusion::motionOf(const SceneGeometry& scene, int object, const VecX& q) const {
  Vec3 sum = Vec3::Zero();
  for (const int v : m_corners[object]) sum += positionOf(scene.vertices[v], q) - m_at[v].cast<double>();
  return m_corners[object].empty() ? sum : Vec3(sum / static_cast<double>(m_corners[object].size()));
}

std::vector<float> Occlusion::presence(const SceneGeometry& scene, const VecX& q, std::span<const float> opacity) const {
  const int objects = static_cast<int>(scene.objects.size());
  std::vector<Vec3> motion(objects);
  for (int i = 0; i < objects; ++i) motion[i] = motionOf(scene, i, q);
  std::vector<float> table(static_cast<std::size_t>(objects) * objects, 0.0f);
  for (int a = 0; a < objects; ++a)
    for (int b = 0; b < objects; ++b) {
      const double apart = a == b ? 0 : (motion[a] - motion[b]).norm();
      const double still = std::clamp((kGone - apart) / (kGone - kStill), 0.0, 1.0);
      table[static_cast<std::size_t>(a) * objects + b] =
          static_cast<float>(std::isfinite(apart) ? std::round(8 * still) / 8 : 0) * opacity[b];
    }
  return table;
}

}  // namespace glenoid
