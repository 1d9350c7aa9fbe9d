// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/check/ScaleJoint.h"

#include <map>

namespace glenoid {
namespace {

/// Scales each mesh once, however many parts show it.
class MeshScaler {
 public:
  explicit MeshScaler(double factor) : m_factor(factor) {}

  std::shared_ptr<const TriMesh> operator()(const std::shared_ptr<const TriMesh>& mesh) {
    if (!mesh) return mesh;
    std::shared_ptr<const TriMesh>& scaled = m_surfaces[mesh];
    if (!scaled) {
      TriMesh copy = *mesh;
      for (Vec3& vertex : copy.vertices) vertex *= m_factor;
      scaled = std::make_shared<const TriMesh>(std::move(copy));
    }
    return scaled;
  }
  std::shared_ptr<const TetMesh> operator()(const std::shared_ptr<const TetMesh>& mesh) const {
    if (!mesh) return mesh;
    TetMesh copy = *mesh;
    for (Vec3& node : copy.nodes) node *= m_factor;
    return std::make_shared<const TetMesh>(std::move(copy));
  }

 private:
  double m_factor;
  std::map<std::shared_ptr<const TriMesh>, std::shared_ptr<const TriMesh>> m_surfaces;
};

void scalePart(Joint& joint, Part& part, double factor, MeshScaler& scaler) {
  part.visual = scaler(part.visual);
  part.collision = scaler(part.collision);
  part.volume = scaler(part.volume);
  part.cellSize *= factor;
  for (Landmark& landmark : part.landmarks) landmark.position_W *= factor;
  for (Cage& cage : joint.cages) {
    if (cage.part != part.id) continue;
    for (Vec3& handle : cage.rest_W) handle *= factor;
    for (Vec3& handle : cage.moved_W) handle *= factor;
  }
}

}  // namespace

Joint scaledJoint(const Joint& joint, double factor) {
  Joint scaled = joint;
  MeshScaler scaler(factor);
  for (Part& part : scaled.parts) scalePart(scaled, part, factor, scaler);
  return scaled;
}

Joint withScaledPart(const Joint& joint, const std::string& part, double factor) {
  Joint scaled = joint;
  MeshScaler scaler(factor);
  const int index = findPart(scaled, part);
  if (index >= 0) scalePart(scaled, scaled.parts[index], factor, scaler);
  return scaled;
}

}  // namespace glenoid
