// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <vector>

#include "simcore/coupling/Springs.h"

namespace glenoid {

/// A spring ready for assembly: its ends as points of contact objects, block bases of both in their island
/// (base −1: fixed, contributes no row), and where its blocks lie.
struct BoundSpring {
  const ContactObject* a = nullptr;
  const ContactObject* b = nullptr;
  int objectA = -1, objectB = -1;   ///< of the scene
  MaterialPoint pointA, pointB;
  int baseA = -1, baseB = -1;
  double stiffness = 0, damping = 0;
  std::vector<BlockEntry> entries;  ///< lower triangle over the spring's terms, row by row
};

/// Block pairs that a spring fills; call before the symbolic phase.
void appendSpringPairs(const BoundSpring& spring, const VecX& q, std::vector<std::array<int, 2>>& pairs);

/// Finds the entries; call after the symbolic phase.
void bindSpring(BoundSpring& spring, const VecX& q, const BlockSymbolic& symbolic);

/// Adds Jᵀ (Δt² k + Δt c) J to A and the spring's force times Δt to the island's right-hand side. `drift_W`: velocity, m/s,
/// that a prescribed motion gives the stretch p_a − p_b.
void assembleSpring(const BoundSpring& spring, double dt, const VecX& q, BlockMatrix& A, VecX& b,
                    const Vec3& drift_W = Vec3::Zero());

}  // namespace glenoid
