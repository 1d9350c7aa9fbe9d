// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/body/SoftObject.h"
#include "simcore/fem/CellModes.h"
#include "simcore/fem/CellPack.h"
#include "simcore/fem/CorotCell.h"

namespace glenoid {

/// Soft object of corotational cells of eight nodes, integrated over the tissue in each (fem/CorotCell.h), four at a
/// time. Points of its surfaces follow the cell's tetrahedra, whose corners are the cell's. A cell that holds less than
/// kFillFloor of tissue is given the rest of that evenly, so that none of its nodes is loose. Made by
/// SoftObject::makeOfCells.
class CellObject : public SoftObject {
 public:
  /// What SoftObject::makeOfCells does.
  static Result<std::unique_ptr<SoftObject>> make(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh, const CellMesh& cells,
                                                  const std::vector<ElementTissue>& tissue, int rotationOffset);

  void appendBlockPairs(int base, std::vector<std::array<int, 2>>& pairs) const override;
  std::vector<BlockEntry> blockEntries(const BlockSymbolic& symbolic, int base) const override;
  void assemble(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries, VecX& rotations,
                BlockMatrix& A, Eigen::Ref<VecX> b) const override;
  /// With rotations found from the guesses in State::rotations.
  double elasticEnergy(const State& state) const override;
  /// The mean strain of the cell's tissue, and the stress it makes in the tetrahedron's material.
  ElementReading readElement(int tet, const State& state, bool stretchLaw = true) const override;
  void readSamples(const State& state, std::vector<ElementReading>& readings, bool stretchLaw = true) const override;
  TissueTrouble troubleOf(const VecX& q, bool stretchLaw) const override;
  int rotationCount() const override { return static_cast<int>(m_cells.size()); }

 private:
  using SoftObject::SoftObject;
  Mat38 cornersAt(int cell, const VecX& q) const;
  Mat3 rotationOf(int cell, const Mat3& F, const State& state) const;
  void buildPacks();
  /// As for tetrahedra.
  LawRange rangeOf(std::span<const int> cells, const VecX& q) const;
  void addStretchLaw(std::vector<int>& cells, const StepSettings& settings, const VecX& q, std::span<const BlockEntry> entries,
                     const VecX& rotations, BlockMatrix& A, Eigen::Ref<VecX> b) const;
  /// One cell by CorotCell: where a lane did not settle, and for the reference.
  void assembleCell(int cell, const StepSettings& settings, const VecX& q, const BlockEntry* entries, Eigen::Map<Quat> rotation,
                    BlockMatrix& A, Eigen::Ref<VecX> b) const;

  std::vector<CorotCell> m_cells;
  std::vector<std::array<int, 8>> m_corners;
  std::vector<CellPack> m_packs;           ///< the same cells, four at a time
  std::vector<double> m_stiffnessDamping;  ///< of each cell, s: mean over its tissue
  std::vector<Lame> m_lameOfTet;
  struct Place {
    int cell;
    Vec3 xi;
  };
  std::vector<CellModes> m_modes;
  std::vector<Place> m_places;             ///< of the samples
};

}  // namespace glenoid
