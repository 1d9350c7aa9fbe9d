// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/SurfaceBinding.h"

#include <cassert>

namespace glenoid {

void surfacePositions(const SurfaceBinding& surface, const ObjectLayout& layout, const VecX& q, std::span<Vec3> out) {
  assert(out.size() == surface.vertices.size());
  if (layout.rigid) {
    const Vec3 c = q.segment<3>(layout.qOffset);
    const Mat3 R = Quat(q[layout.qOffset + 6], q[layout.qOffset + 3], q[layout.qOffset + 4], q[layout.qOffset + 5])
                       .toRotationMatrix();
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = c + R * surface.vertices[i].r_B;
    return;
  }
  const double* nodes = q.data() + layout.qOffset;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const VertexBinding& binding = surface.vertices[i];
    Vec3 p = Vec3::Zero();
    for (int k = 0; k < 4; ++k) p += binding.weight[k] * Eigen::Map<const Vec3>(nodes + 3 * binding.node[k]);
    out[i] = p;
  }
}

void surfaceVelocities(const SurfaceBinding& surface, const ObjectLayout& layout, const VecX& q, const VecX& v,
                       std::span<Vec3> out) {
  assert(out.size() == surface.vertices.size());
  if (!layout.free) {
    for (Vec3& velocity : out) velocity.setZero();
    return;
  }
  if (layout.rigid) {
    const Mat3 R = Quat(q[layout.qOffset + 6], q[layout.qOffset + 3], q[layout.qOffset + 4], q[layout.qOffset + 5])
                       .toRotationMatrix();
    const Vec3 linear = v.segment<3>(layout.vOffset), omega = v.segment<3>(layout.vOffset + 3);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = linear + omega.cross(R * surface.vertices[i].r_B);
    return;
  }
  const double* nodes = v.data() + layout.vOffset;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const VertexBinding& binding = surface.vertices[i];
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 4; ++k) sum += binding.weight[k] * Eigen::Map<const Vec3>(nodes + 3 * binding.node[k]);
    out[i] = sum;
  }
}

}  // namespace glenoid
