// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/body/SoftObject.h"
#include "simcore/fem/ElementPack.h"

namespace glenoid {

/// Soft object of linear corotational tetrahedra, four at a time. An element's stiffness is weighted by its fill, since
/// a 1 mm ligament in 8 mm cells would otherwise be several times too stiff. Made by SoftObject::make.
class TetObject : public SoftObject {
 public:
  /// What SoftObject::make does.
  static Result<std::unique_ptr<SoftObject>> make(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh,
                                                  const std::vector<ElementTissue>& tissue, int rotationOffset);

  void appendBlockPairs(int base, std::vector<std::array<int, 2>>& pairs) const override;
  std::vector<BlockEntry> blockEntries(const BlockSymbolic& symbolic, int base) const override;
  void assemble(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries, VecX& rotations,
                BlockMatrix& A, Eigen::Ref<VecX> b) const override;
  /// With rotations found from the guesses in State::rotations.
  double elasticEnergy(const State& state) const override;
  ElementReading readElement(int tet, const State& state, bool stretchLaw = true) const override;
  void readSamples(const State& state, std::vector<ElementReading>& readings, bool stretchLaw = true) const override;
  TissueTrouble troubleOf(const VecX& q, bool stretchLaw) const override;
  int rotationCount() const override { return elementCount(); }

 private:
  using SoftObject::SoftObject;
  Mat34 nodesOf(int element, const VecX& q) const;
  Mat3 rotationOf(int element, const Mat3& F, const State& state) const;
  void buildPacks();
  /// How much of the stretch law holds, where all elements but these are near rest.
  LawRange rangeOf(std::span<const int> elements, const VecX& q) const;
  /// What elements that may be far from rest have besides, with their rotations found.
  void addStretchLaw(std::vector<int>& elements, const StepSettings& settings, const VecX& q, std::span<const BlockEntry> entries,
                     const VecX& rotations, BlockMatrix& A, Eigen::Ref<VecX> b) const;
  /// One element by CorotTet: where a lane did not settle, and for the reference.
  void assembleElement(int element, const StepSettings& settings, const VecX& q, const BlockEntry* entries,
                       Eigen::Map<Quat> rotation, BlockMatrix& A, Eigen::Ref<VecX> b) const;

  std::vector<CorotTet> m_elements;
  std::vector<ElementPack> m_packs;        ///< the same elements, four at a time
  std::vector<double> m_stiffnessDamping;  ///< of each element, s
  std::vector<int> m_sampled;              ///< the element of each sample
};

}  // namespace glenoid
