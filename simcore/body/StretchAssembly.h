// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/body/ContactObject.h"
#include "simcore/fem/StretchLaw.h"

/// Private to this folder.
namespace glenoid {

/// A list without entries, with room for `size`; one for each thread, so that a step allocates nothing.
inline std::vector<int>& elementScratch(int size) {
  static thread_local std::vector<int> list;
  list.clear();
  list.reserve(size);
  return list;
}

/// Adds to A and b what an element far from rest lacks of the stretch law (StretchLaw.h). `pairs`: local nodes of its blocks, as
/// `entries`; `nodes`: of the object. Like tension's, the stiffness multiplies Δt² alone: damping stays that of the linear law.
template <int kNodes, std::size_t kBlocks>
void addStretchCorrection(const StretchCorrection& more, double volume, const StepSettings& settings, const Mat3& R_WE,
                          const Eigen::Matrix<double, 3, kNodes>& gradients_E, const int (&pairs)[kBlocks][2], const int* nodes,
                          const BlockEntry* entries, BlockMatrix& A, Eigen::Ref<VecX> b) {
  using Corners = Eigen::Matrix<double, 3, kNodes>;
  const double dt = settings.dt;
  const Corners force = -dt * volume * (R_WE * (more.stress_E * gradients_E));
  for (int i = 0; i < kNodes; ++i) b.segment<3>(3 * nodes[i]) += force.col(i);
  const Corners g = R_WE * gradients_E;
  std::array<Corners, 6> y;
  for (int m = 0; m < more.count; ++m)
    y[m] = (dt * std::sqrt(volume * more.terms[m].stiffness)) * (R_WE * (more.terms[m].direction_E * gradients_E));
  const double turning = settings.tension ? dt * dt * volume * more.turning : 0;
  for (std::size_t k = 0; k < kBlocks; ++k) {
    const int i = pairs[k][0], j = pairs[k][1];
    Mat3 block = tensionBlock(turning, g.col(i), g.col(j));
    for (int m = 0; m < more.count; ++m) block += y[m].col(i) * y[m].col(j).transpose();
    A.add(entries[k], block);
  }
}

}  // namespace glenoid
