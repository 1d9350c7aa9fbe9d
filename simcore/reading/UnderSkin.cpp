// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/UnderSkin.h"

#include <algorithm>
#include <cmath>

#include "simcore/body/SurfaceBinding.h"
#include "simcore/spatial/TrianglePoint.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

constexpr double kReach = 0.03;      ///< m: what lies deeper below a skin at the start is left alone
constexpr double kRoom = 2e-3;     ///< m, most that is kept between a skin and what lies beneath
constexpr double kShare = 0.8;     ///< of the room at the start: what moves a little is not shifted
constexpr double kFacing = 0.7;    ///< cosine: what lies beside a skin's border is not beneath it
constexpr double kWithin = 2e-3;   ///< m: what lies deeper in a skin at the start is part of it
constexpr double kLeast = 1e-6;    ///< m
constexpr int kWalkMost = 200, kRounds = 3;

bool isSkin(const Model& model, int object) {
  const SceneObject& it = model.objects[static_cast<std::size_t>(object)];
  const int part = it.tool || it.layout.rigid ? -1 : findPart(model.joint, it.id);
  return part >= 0 && appearanceOf(model.joint, model.joint.parts[static_cast<std::size_t>(part)]) == Appearance::Skin;
}

/// Area-weighted, unit.
void vertexNormals(const TriMesh& mesh, const std::vector<Vec3>& at, std::vector<Vec3>& normals) {
  normals.assign(at.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles) {
    const Vec3 area = (at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]);
    for (const int v : t) normals[v] += area;
  }
  for (Vec3& n : normals) n.normalize();
}

}  // namespace

UnderSkin::UnderSkin(const Model& model) : m_surfaces(model.objects.size()), m_shifts(model.objects.size()), m_shifted(model.objects.size(), 0) {
  for (int i = 0; i < static_cast<int>(model.objects.size()); ++i) {
    if (!isSkin(model, i)) continue;
    Skin skin = beneathOf(model, i);
    if (!skin.layers.empty()) m_skins.push_back(std::move(skin));
  }
  const auto keep = [&](int object) { m_surfaces[object] = {model.objects[object].visual, model.objects[object].layout}; };
  for (const Skin& skin : m_skins) {
    keep(skin.object);
    for (const Layer& layer : skin.layers) {
      keep(layer.object);
      m_shifts[layer.object].assign(model.objects[layer.object].visual.vertices.size(), Vec3::Zero());
    }
  }
}

UnderSkin::Skin UnderSkin::beneathOf(const Model& model, int object) {
  Skin skin;
  skin.object = object;
  TriMesh mesh = *model.objects[object].visual.mesh;
  surfacePositions(model.objects[object].visual, model.objects[object].layout, model.start.q, mesh.vertices);
  std::vector<Vec3> normals, at;
  vertexNormals(mesh, mesh.vertices, normals);
  const TriangleTree tree(mesh);
  for (int i = 0; i < static_cast<int>(model.objects.size()); ++i) {
    const SceneObject& other = model.objects[i];
    if (other.tool || i == object || isSkin(model, i)) continue;
    Layer layer;
    layer.object = i;
    at.resize(other.visual.vertices.size());
    surfacePositions(other.visual, other.layout, model.start.q, at);
    for (std::size_t v = 0; v < at.size(); ++v) {
      const TriangleTree::Closest foot = tree.closest(at[v], kReach);
      if (foot.triangle < 0) continue;
      const auto& t = mesh.triangles[foot.triangle];
      const Vec3 n = (foot.barycentric[0] * normals[t[0]] + foot.barycentric[1] * normals[t[1]] + foot.barycentric[2] * normals[t[2]]).normalized();
      const double off = n.dot(at[v] - foot.point);
      if (off > -kWithin && std::abs(off) >= kFacing * foot.distance)
        layer.vertices.push_back({static_cast<int>(v), foot.triangle, std::min(kRoom, off > 0 ? kShare * off : off - kLeast)});
    }
    if (!layer.vertices.empty()) skin.layers.push_back(std::move(layer));
  }
  std::vector<std::vector<int>> around(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const int v : mesh.triangles[t]) around[v].push_back(static_cast<int>(t));
  skin.firstNear.push_back(0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto first = static_cast<std::ptrdiff_t>(skin.near.size());
    for (const int v : mesh.triangles[t]) skin.near.insert(skin.near.end(), around[v].begin(), around[v].end());
    std::sort(skin.near.begin() + first, skin.near.end());
    skin.near.erase(std::unique(skin.near.begin() + first, skin.near.end()), skin.near.end());
    skin.firstNear.push_back(static_cast<int>(skin.near.size()));
  }
  return skin;
}

/// Visual vertices as a picture has them before any shift.
void UnderSkin::place(int object, const VecX& q, std::span<const DentView> dents, std::vector<Vec3>& out) const {
  const Surface& it = m_surfaces[object];
  out.resize(it.binding.vertices.size());
  surfacePositions(it.binding, it.layout, q, out);
  for (const DentView& dent : dents) {
    if (dent.object != object || !(dent.radius > 0)) continue;
    for (Vec3& p : out) p -= dent.depth * std::exp(-(p - dent.point_W).squaredNorm() / (2 * dent.radius * dent.radius)) * dent.normal_W;
  }
}

UnderSkin::Foot UnderSkin::footOn(const TriMesh& mesh, int triangle, const Vec3& p) const {
  const auto& t = mesh.triangles[triangle];
  const Vec3 w = nearestBarycentric(p, m_skinAt[t[0]], m_skinAt[t[1]], m_skinAt[t[2]]);
  Foot foot;
  foot.triangle = triangle;
  foot.point = w[0] * m_skinAt[t[0]] + w[1] * m_skinAt[t[1]] + w[2] * m_skinAt[t[2]];
  foot.squared = (p - foot.point).squaredNorm();
  foot.normal = w[0] * m_normals[t[0]] + w[1] * m_normals[t[1]] + w[2] * m_normals[t[2]];
  return foot;
}

/// The nearest place that can be walked to downhill: on the side of the skin where the walk begins.
UnderSkin::Foot UnderSkin::footOf(const Skin& skin, const TriMesh& mesh, int from, const Vec3& p) const {
  Foot best = footOn(mesh, from, p);
  for (int n = 0; n < kWalkMost; ++n) {
    const int at = best.triangle;
    for (int k = skin.firstNear[at]; k < skin.firstNear[at + 1]; ++k)
      if (const Foot foot = footOn(mesh, skin.near[k], p); foot.squared < best.squared) best = foot;
    if (best.triangle == at) break;
  }
  best.normal.normalize();
  return best;
}

void UnderSkin::look(const VecX& q, std::span<const DentView> dents, std::span<const char> shown) {
  for (std::size_t i = 0; i < m_shifts.size(); ++i)
    if (m_shifted[i]) std::fill(m_shifts[i].begin(), m_shifts[i].end(), Vec3::Zero()), m_shifted[i] = 0;
  for (const Skin& skin : m_skins) {
    if (!shown.empty() && !shown[skin.object]) continue;
    const TriMesh& mesh = *m_surfaces[skin.object].binding.mesh;
    place(skin.object, q, dents, m_skinAt);
    vertexNormals(mesh, m_skinAt, m_normals);
    for (const Layer& layer : skin.layers) {
      place(layer.object, q, dents, m_at);
      std::vector<Vec3>& shifts = m_shifts[layer.object];
      for (const Beneath& one : layer.vertices) {
        const Vec3 start = m_at[one.vertex] + shifts[one.vertex];
        Vec3 p = start;
        int from = one.triangle;
        for (int round = 0; round < kRounds; ++round) {
          const Foot foot = footOf(skin, mesh, from, p);
          const double lacking = one.room - foot.normal.dot(p - foot.point);
          if (!(lacking > 0)) break;
          p += lacking * foot.normal;
          from = foot.triangle;
        }
        if (p == start || !p.allFinite()) continue;
        shifts[one.vertex] += p - start;
        m_shifted[layer.object] = 1;
      }
    }
  }
}

std::span<const Vec3> UnderSkin::shifts(int object) const {
  if (object < 0 || object >= static_cast<int>(m_shifts.size()) || !m_shifted[object]) return {};
  return m_shifts[object];
}

}  // namespace glenoid
