// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/StartSurfaces.h"

#include "simcore/embed/Bind.h"

namespace glenoid {

Result<std::shared_ptr<const CageFollower>> CageFollower::make(const Part& part, const Cage& cage) {
  if (!part.volume || part.volume->tets.empty() || !part.collision)
    return Error{
        Fault::Unusable, {"", "", part.id, {}}, {"volume"}, "a cage around a part without tetrahedra"};
  auto weights = cageWeights({cage.rest_W, cage.triangles}, part.volume->nodes);
  if (!weights) {
    weights.error().place.part = part.id;
    return weights.error();
  }
  std::shared_ptr<CageFollower> follower(new CageFollower);
  follower->m_volume = part.volume;
  follower->m_collision = part.collision;
  follower->m_triangles = cage.triangles;
  follower->m_rest_W = cage.rest_W;
  follower->m_weights = std::move(*weights);
  follower->m_bound = bindToTets(*part.volume, part.collision->vertices);
  return std::shared_ptr<const CageFollower>(std::move(follower));
}

bool CageFollower::isFor(const Part& part, const Cage& cage) const {
  return part.volume == m_volume && part.collision == m_collision && cage.triangles == m_triangles &&
         cage.rest_W == m_rest_W;
}

std::vector<Vec3> CageFollower::nodes(const std::vector<Vec3>& moved_W) const {
  return followCage(m_weights, m_volume->nodes, m_rest_W, moved_W);
}

TriMesh CageFollower::collision(const std::vector<Vec3>& moved_W) const {
  TriMesh surface = *m_collision;
  const std::vector<Vec3> at = nodes(moved_W);
  for (std::size_t v = 0; v < m_bound.size(); ++v) surface.vertices[v] = boundPosition(m_bound[v], at);
  return surface;
}

Result<std::shared_ptr<const CageFollower>> StartSurfaces::follower(const Part& part, const Cage& cage) {
  const std::lock_guard lock(m_mutex);
  std::shared_ptr<const CageFollower>& kept = m_followers[part.id];
  if (kept && kept->isFor(part, cage)) return kept;
  auto made = CageFollower::make(part, cage);
  if (made.ok()) kept = *made;
  return made;
}

Result<std::vector<TriMesh>> StartSurfaces::of(const Joint& joint) {
  std::vector<TriMesh> surfaces;
  for (const Part& part : joint.parts) {
    const Cage* cage = part.kind == PartKind::Soft ? findCage(joint, part.id) : nullptr;
    if (!cage) {
      surfaces.push_back(part.collision ? *part.collision : TriMesh{});
      continue;
    }
    const auto found = follower(part, *cage);
    if (!found) return found.error();
    surfaces.push_back((*found)->collision(cage->moved_W));
  }
  return surfaces;
}

}  // namespace glenoid
