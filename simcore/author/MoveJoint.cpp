// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MoveJoint.h"

#include <map>
#include <utility>

#include "simcore/scene/JointFile.h"

namespace glenoid {
namespace {

/// Moves each surface once, however many parts show it.
class SurfaceMover {
 public:
  explicit SurfaceMover(const Isometry& motion) : m_motion(motion) {}

  std::shared_ptr<const TriMesh> operator()(const std::shared_ptr<const TriMesh>& mesh) {
    if (!mesh) return mesh;
    std::shared_ptr<const TriMesh>& moved = m_moved[mesh];
    if (!moved) moved = std::make_shared<const TriMesh>(movedMesh(*mesh, m_motion));
    return moved;
  }

 private:
  const Isometry& m_motion;
  std::map<std::shared_ptr<const TriMesh>, std::shared_ptr<const TriMesh>> m_moved;
};

}  // namespace

Vec3 Isometry::operator*(const Vec3& x) const {
  Vec3 y;
  for (int i = 0; i < 3; ++i) {
    double sum = t[i];
    bool any = sum != 0;
    for (int k = 0; k < 3; ++k) {
      if (R(i, k) == 0) continue;
      sum = any ? sum + R(i, k) * x[k] : R(i, k) * x[k];
      any = true;
    }
    y[i] = sum;
  }
  return y;
}

TriMesh movedMesh(const TriMesh& mesh, const Isometry& motion) {
  TriMesh moved = mesh;
  for (Vec3& vertex : moved.vertices) vertex = motion * vertex;
  if (motion.mirrors())
    for (auto& t : moved.triangles) std::swap(t[1], t[2]);
  return moved;
}

TetMesh movedMesh(const TetMesh& mesh, const Isometry& motion) {
  TetMesh moved = mesh;
  for (Vec3& node : moved.nodes) node = motion * node;
  if (motion.mirrors())
    for (auto& tet : moved.tets) std::swap(tet[2], tet[3]);
  return moved;
}

Joint movedJoint(const Joint& joint, const Isometry& motion) {
  Joint moved = joint;
  const Isometry turn{motion.R, Vec3::Zero()};
  for (int row = 0; row < 3; ++row) moved.axes_W.row(row) = (turn * joint.axes_W.row(row).transpose()).transpose();
  SurfaceMover surface(motion);
  for (Part& part : moved.parts) {
    part.visual = surface(part.visual);
    part.collision = surface(part.collision);
    if (part.volume) part.volume = std::make_shared<const TetMesh>(movedMesh(*part.volume, motion));
    for (Landmark& landmark : part.landmarks) landmark.position_W = motion * landmark.position_W;
  }
  for (Cage& cage : moved.cages) {
    for (auto* handles : {&cage.rest_W, &cage.moved_W})
      for (Vec3& handle : *handles) handle = motion * handle;
    if (motion.mirrors())
      for (auto& t : cage.triangles) std::swap(t[1], t[2]);
  }
  for (std::size_t i = 0; i < moved.parts.size(); ++i) {
    const Part& from = joint.parts[i];
    if (!from.dents) continue;
    DentTable dents = *from.dents;
    for (DentSample& sample : dents.samples) sample.at_W = motion * sample.at_W;
    if (dents.basis == dentBasis(joint, from)) dents.basis = dentBasis(moved, moved.parts[i]);
    moved.parts[i].dents = std::make_shared<const DentTable>(std::move(dents));
  }
  if (joint.startProof && joint.startProof->of == startHash(joint)) moved.startProof->of = startHash(moved);
  return moved;
}

}  // namespace glenoid
