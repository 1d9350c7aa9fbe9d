// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/step/StepModel.h"

namespace glenoid {

/// Forces of loads, pressures and supports, and where motions put their parts. Private to step/ and reading/.

/// Velocity of an object as a rigid whole: point p moves with linear_W + omega_W × (p − at_W).
struct Twist {
  Vec3 at_W = Vec3::Zero(), linear_W = Vec3::Zero(), omega_W = Vec3::Zero();
  Vec3 of(const Vec3& p_W) const { return linear_W + omega_W.cross(p_W - at_W); }
};

/// Puts every driven object where its motion wants it at a time.
void placeDriven(const Model& model, const StepModel& inside, double time, VecX& q);

/// The steady twist that takes a motion's part from where it is at `begin` to where it is at `end` > begin, s.
Twist twistOf(const Motion& motion, double begin, double end);

/// Adds Δt F of a load to the right-hand side of the object's island.
void assembleLoad(const BoundLoad& load, const ContactObject& object, double dt, const VecX& q, VecX& b);

/// Adds Δt F of a pressure. `scratch` has room for two entries for each of its points.
void assemblePressure(const BoundPressure& pressure, const ContactObject& object, double dt, const VecX& q, std::vector<Vec3>& scratch,
                      VecX& b);

/// Force of the region's pressure as it lies, N, and its torque about the origin of W, N·m.
Vec6 pressureWrench(const BoundPressure& pressure, const ContactObject& object, const VecX& q);

/// Adds a support's spring: Jᵀ (Δt² k + Δt c) J to A, −Δt Jᵀ k (p − rest) to b.
void assembleSupport(const BoundSupport& support, double dt, const VecX& q, BlockMatrix& A, VecX& b);

}  // namespace glenoid
