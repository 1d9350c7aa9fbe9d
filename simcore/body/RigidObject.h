// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/body/ContactObject.h"

namespace glenoid {

/// Mass, centre and inertia of a rigid object.
struct MassProperties {
  double mass = 0;               ///< kg
  Vec3 centre = Vec3::Zero();    ///< m, in the frame of the mesh
  Mat3 inertia = Mat3::Zero();   ///< kg·m² about the centre, axes of the mesh's frame
};

/// Of the volume that a closed surface encloses at one density, exactly (divergence theorem).
/// Fails with BadMesh when the enclosed volume is not positive.
Result<MassProperties> massPropertiesOf(const TriMesh& surface, double density);

/// Rigid body: q = (centre of mass, unit quaternion x y z w), v = (linear, angular), both in W.
/// Body frame B: origin at the centre of mass, axes of the rest frame.
/// A step changes its momenta at the orientation it started with; then the body moves freely: it turns with its angular
/// momentum and its energy kept (Euler's equations by a midpoint rule in sub-steps), however far it turns in a step.
class RigidObject : public ContactObject {
 public:
  /// `withWeight`: false for a tool, whose weight the hand carries.
  RigidObject(const ObjectLayout& layout, const MassProperties& properties, double massDamping, bool withWeight);

  void appendBlockPairs(int base, std::vector<std::array<int, 2>>& pairs) const override;
  std::vector<BlockEntry> blockEntries(const BlockSymbolic& symbolic, int base) const override;
  void assemble(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries, VecX& rotations,
                BlockMatrix& A, Eigen::Ref<VecX> b) const override;
  void advance(double dt, State& state) const override;
  Vec3 position(const MaterialPoint& point, const VecX& q) const override;
  Vec3 velocity(const MaterialPoint& point, const VecX& q, const VecX& v) const override;
  int rowTerms(const MaterialPoint& point, const Vec3& d, const VecX& q, int base, RowTerm* terms) const override;
  double mass() const override { return m_properties.mass; }
  double kineticEnergy(const State& state) const override;
  double elasticEnergy(const State&) const override { return 0; }
  Vec6 momentum(const State& state) const override;
  Vec6 momentumOf(const VecX& q, const Eigen::Ref<const VecX>& v) const override;
  void addUniform(const Vec3& acceleration_W, Eigen::Ref<VecX> f) const override;

  Pose pose(const VecX& q) const { return poseAt(q, layout().qOffset); }
  const MassProperties& properties() const { return m_properties; }

 private:
  Mat3 inertia_W(const VecX& q) const;
  MassProperties m_properties;
  double m_massDamping;
  bool m_withWeight;
};

}  // namespace glenoid
