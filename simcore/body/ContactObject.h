// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <span>
#include <vector>

#include "simcore/body/State.h"
#include "simcore/body/SurfaceBinding.h"
#include "simcore/linear/BlockMatrix.h"
#include "simcore/linear/BlockSymbolic.h"

namespace glenoid {

/// A material point of one object: a combination of up to twelve nodes (three surface vertices of four nodes
/// each, merged) or, of a rigid object, a place in its frame. Whoever touches a surface does it through this.
struct MaterialPoint {
  int count = 0;  ///< nodes in use; 0 for a rigid object
  std::array<int, 12> node{};
  std::array<double, 12> weight{};
  Vec3 r_B = Vec3::Zero();  ///< rigid: body frame, m
};

/// Point at one bound vertex.
MaterialPoint pointAt(const VertexBinding& binding, bool rigid);

/// Point at Σ weights[i] · vertices[i] of a surface; equal nodes are merged, ascending.
MaterialPoint pointAt(const SurfaceBinding& surface, bool rigid, std::span<const int> vertices,
                      std::span<const double> weights);

/// What a step asks of the objects.
struct StepSettings {
  double dt = 0.005;            ///< s
  Vec3 gravity_W = Vec3::Zero();  ///< zero where the effect is off
  bool damping = true;          ///< Rayleigh
  bool portable = false;        ///< no SIMD kernels
  bool tension = true;          ///< A holds the stiffness of taut tissue against turning
  bool stretchLaw = true;       ///< far from rest tissue follows fem/StretchLaw.h; else it is linear at any stretch
  bool rotationsBySvd = false;  ///< `reference`: no iteration, no guess
};

/// Most row terms that one point can give.
inline constexpr int kMaxPointTerms = 12;

/// The elementary dynamic object with its own mechanical properties, the paper's "contact object": state q,
/// velocity v, q̇ = G v. What comes after (couplings, contact, step) asks nothing else and never its kind.
/// Velocities are counted in blocks of three: a node is one block, a rigid body two (linear, angular).
/// Constant after construction, so threads may share it. Frames: W world; SI units.
/// Source: Otaduy et al., "Modeling and Simulation of a Human Shoulder", CEIG 2010, §3.1 and §5.1.
class ContactObject {
 public:
  explicit ContactObject(const ObjectLayout& layout) : m_layout(layout) {}
  virtual ~ContactObject() = default;
  const ObjectLayout& layout() const { return m_layout; }

  /// Blocks of three velocities; zero for a fixed object.
  int blockCount() const { return m_layout.vSize / 3; }

  /// Block pairs of A that the object fills, with its first block at `base` of its island.
  virtual void appendBlockPairs(int base, std::vector<std::array<int, 2>>& pairs) const = 0;

  /// Where those blocks lie; what assemble wants as `entries`.
  virtual std::vector<BlockEntry> blockEntries(const BlockSymbolic& symbolic, int base) const = 0;

  /// Adds A = M − Δt ∂F/∂v − Δt² (∂F/∂q) G and b = Δt F + (M − Δt ∂F/∂v) v₀ of the object's own forces.
  /// `b` is the object's part of the right-hand side, `rotations` the scene's vector (guess in, answer out).
  virtual void assemble(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries,
                        VecX& rotations, BlockMatrix& A, Eigen::Ref<VecX> b) const = 0;

  /// q ← q + Δt G v with the state's new v. A fixed object stays.
  virtual void advance(double dt, State& state) const = 0;

  virtual Vec3 position(const MaterialPoint& point, const VecX& q) const = 0;
  virtual Vec3 velocity(const MaterialPoint& point, const VecX& q, const VecX& v) const = 0;

  /// The row dᵀ J with ṗ = J v, as terms with blocks counted from `base`, ascending. Answers how many (zero
  /// for a fixed object); `terms` has room for kMaxPointTerms. Which blocks appear depends on the point only.
  virtual int rowTerms(const MaterialPoint& point, const Vec3& d, const VecX& q, int base, RowTerm* terms) const = 0;

  /// Adds to each block the mass it has together with the object's other blocks, kg: with it the diagonal of M is what the
  /// block would weigh alone, and a splitting by blocks converges for M.
  virtual void addSharedMass(Eigen::Ref<VecX>) const {}

  virtual double mass() const = 0;  ///< kg
  virtual double kineticEnergy(const State& state) const = 0;  ///< J
  virtual double elasticEnergy(const State& state) const = 0;  ///< J
  /// Linear momentum (kg·m/s), then angular momentum about the origin of W (kg·m²/s); zero for a fixed object.
  virtual Vec6 momentum(const State& state) const = 0;

  /// The same for velocities `v` of this object alone, as many as a free object of its kind has; also of a fixed one. With
  /// rigid motions for v it tells mass, centre and inertia of what the step moves, whatever its mass matrix.
  virtual Vec6 momentumOf(const VecX& q, const Eigen::Ref<const VecX>& v) const = 0;

  /// Adds M a, N, to the object's part of a right-hand side: a field of acceleration that is the same everywhere, as
  /// weight is. Never for a fixed object.
  virtual void addUniform(const Vec3& acceleration_W, Eigen::Ref<VecX> f) const = 0;

 private:
  ObjectLayout m_layout;
};

}  // namespace glenoid
