// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>

#include "simcore/base/Error.h"
#include "simcore/body/ContactObject.h"
#include "simcore/body/MassMatrix.h"
#include "simcore/fem/CorotTet.h"
#include "simcore/fem/ElementPack.h"
#include "simcore/mesh/TetMesh.h"

namespace glenoid {

/// Tissue of one element, already resolved from the part's materials.
struct ElementTissue {
  Lame lame;
  double density = 1000;           ///< kg/m³
  double massDamping = 0;          ///< Rayleigh α, 1/s
  double stiffnessDamping = 0;     ///< Rayleigh β, s
  double fill = 1;                 ///< fraction of the element's stiffness that is there, above 0
  /// ∫ λ λᵀ over the tissue in the element, m³ (embed/Fill.h); without them it is spread over the element, times fill.
  std::optional<Eigen::Matrix4d> moments = std::nullopt;
};

/// What an element says of its tissue, symmetric tensors in W: strain R (sym(RᵀF) − I) Rᵀ and stress, Pa, of the same law as
/// the forces of the step (fem/CorotTet.h), without damping. The stress is that of the tissue: an element that is half
/// tissue carries half of it.
struct ElementReading {
  Mat3 strain_W, stress_W;
};

/// Deformable body: linear corotational tetrahedra, consistent mass; q = nodes, v = node velocities.
/// An element's stiffness is weighted by its fill, since a 1 mm ligament in 8 mm cells would otherwise be several
/// times too stiff; its mass is where its tissue is, so a part has the mass, mass centre and inertia of what its surface
/// encloses.
class SoftObject : public ContactObject {
 public:
  /// Fails with BadElement naming the element. `rotationOffset`: of the first element in State::rotations.
  static Result<std::unique_ptr<SoftObject>> make(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh,
                                                  const std::vector<ElementTissue>& tissue, int rotationOffset);

  void appendBlockPairs(int base, std::vector<std::array<int, 2>>& pairs) const override;
  std::vector<BlockEntry> blockEntries(const BlockSymbolic& symbolic, int base) const override;
  void assemble(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries, VecX& rotations,
                BlockMatrix& A, Eigen::Ref<VecX> b) const override;
  void advance(double dt, State& state) const override;
  Vec3 position(const MaterialPoint& point, const VecX& q) const override;
  Vec3 velocity(const MaterialPoint& point, const VecX& q, const VecX& v) const override;
  int rowTerms(const MaterialPoint& point, const Vec3& d, const VecX& q, int base, RowTerm* terms) const override;
  void addSharedMass(Eigen::Ref<VecX> perNode) const override;
  double mass() const override;
  double kineticEnergy(const State& state) const override;
  /// With rotations found from the guesses in State::rotations.
  double elasticEnergy(const State& state) const override;
  Vec6 momentum(const State& state) const override;
  Vec6 momentumOf(const VecX& q, const Eigen::Ref<const VecX>& v) const override;
  void addUniform(const Vec3& acceleration_W, Eigen::Ref<VecX> f) const override;
  /// With the rotation found from the guess in State::rotations.
  ElementReading readElement(int element, const State& state) const;

  int elementCount() const { return static_cast<int>(m_elements.size()); }

 private:
  SoftObject(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh, int rotationOffset);
  Mat34 nodesOf(int element, const VecX& q) const;
  Mat3 rotationOf(int element, const Mat3& F, const State& state) const;
  void buildPacks();
  /// One element by CorotTet: where a lane did not settle, and for the reference.
  void assembleElement(int element, const StepSettings& settings, const VecX& q, const BlockEntry* entries,
                       Eigen::Map<Quat> rotation, BlockMatrix& A, Eigen::Ref<VecX> b) const;

  std::shared_ptr<const TetMesh> m_mesh;
  std::vector<CorotTet> m_elements;
  std::vector<ElementPack> m_packs;        ///< the same elements, four at a time
  std::vector<double> m_stiffnessDamping;  ///< of each element, s
  MassMatrix m_mass;
  int m_rotationOffset;
};

}  // namespace glenoid
