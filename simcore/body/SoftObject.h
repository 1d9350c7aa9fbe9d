// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/body/ContactObject.h"
#include "simcore/body/MassMatrix.h"
#include "simcore/embed/WholeCells.h"
#include "simcore/fem/CorotTet.h"
#include "simcore/fem/StretchLaw.h"
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
/// the forces of the step (fem/CorotTet.h, fem/StretchLaw.h), without damping. The stress is that of the tissue: an element that is half
/// tissue carries half of it.
struct ElementReading {
  Mat3 strain_W, stress_W;
};

/// A place inside an element's tissue, at rest, at which it says its strain and stress.
struct TissueSample {
  Vec3 at_E = Vec3::Zero();  ///< m
  double volume = 0;         ///< of the tissue that it stands for, m³, > 0
  Lame lame;                 ///< of that tissue
};

/// How many elements are turned inside out, and how many pressed beyond what their law holds (fem/StretchLaw.h).
struct TissueTrouble {
  int insideOut = 0, pressed = 0;
  void count(TissueState state) {
    insideOut += state == TissueState::InsideOut;
    pressed += state == TissueState::Pressed;
  }
};

/// Deformable body: q = nodes, v = node velocities, consistent mass. Its mass is where its tissue is, so a part has the
/// mass, mass centre and inertia of what its surface encloses. How it is elastic is in the two kinds below.
class SoftObject : public ContactObject {
 public:
  /// Linear corotational tetrahedra (TetObject). Fails with BadElement naming the element. `rotationOffset`: of the first
  /// element in State::rotations.
  static Result<std::unique_ptr<SoftObject>> make(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh,
                                                  const std::vector<ElementTissue>& tissue, int rotationOffset);
  /// Corotational cells of eight nodes (CellObject) on a mesh of whole cells, `mesh` being that of `cells`; `tissue` of each
  /// tetrahedron, of which fill and moments are those of `cells`. Fails with BadElement.
  static Result<std::unique_ptr<SoftObject>> makeOfCells(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh,
                                                         const CellMesh& cells, const std::vector<ElementTissue>& tissue,
                                                         int rotationOffset);

  void advance(double dt, State& state) const override;
  Vec3 position(const MaterialPoint& point, const VecX& q) const override;
  Vec3 velocity(const MaterialPoint& point, const VecX& q, const VecX& v) const override;
  int rowTerms(const MaterialPoint& point, const Vec3& d, const VecX& q, int base, RowTerm* terms) const override;
  void addSharedMass(Eigen::Ref<VecX> perNode) const override;
  double mass() const override;
  double kineticEnergy(const State& state) const override;
  Vec6 momentum(const State& state) const override;
  Vec6 momentumOf(const VecX& q, const Eigen::Ref<const VecX>& v) const override;
  void addUniform(const Vec3& acceleration_W, Eigen::Ref<VecX> f) const override;

  /// Of a tetrahedron of the mesh, with the rotation found from the guess in State::rotations. `stretchLaw`: as
  /// StepSettings; elasticEnergy is always with it.
  virtual ElementReading readElement(int tet, const State& state, bool stretchLaw = true) const = 0;
  /// Places of the tissue, the same for the object's whole life: the tissue's centroid in each tetrahedron, and eight
  /// places in each cell (per material), as far from its centroid as the tissue spreads along the cell's axes.
  std::span<const TissueSample> samples() const { return m_samples; }
  /// What is said there, in the order of samples(); with the modes inside a cell.
  virtual void readSamples(const State& state, std::vector<ElementReading>& readings, bool stretchLaw = true) const = 0;
  /// Elements that a load has been too much for, with nodes at q.
  virtual TissueTrouble troubleOf(const VecX& q, bool stretchLaw) const = 0;
  /// Elements that have a rotation in the state, in their order.
  virtual int rotationCount() const = 0;
  int elementCount() const { return static_cast<int>(m_mesh->tets.size()); }

 protected:
  SoftObject(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh, int rotationOffset);
  const TetMesh& mesh() const { return *m_mesh; }
  int rotationOffset() const { return m_rotationOffset; }
  Vec3 nodeAt(const VecX& q, int node) const { return q.segment<3>(layout().qOffset + 3 * node); }
  void setMass(std::vector<MassPair> loose);
  void setSamples(std::vector<TissueSample> samples) { m_samples = std::move(samples); }
  const MassMatrix& massMatrix() const { return m_mass; }
  /// M and what the velocities and weight make of it, into A and b; `entries` of the mass matrix's pairs.
  void assembleMass(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries, BlockMatrix& A,
                    Eigen::Ref<VecX> b) const;
  void appendMassEntries(const BlockSymbolic& symbolic, int base, std::vector<BlockEntry>& entries) const;

 private:
  std::shared_ptr<const TetMesh> m_mesh;
  MassMatrix m_mass;
  std::vector<TissueSample> m_samples;
  int m_rotationOffset;
};

}  // namespace glenoid
