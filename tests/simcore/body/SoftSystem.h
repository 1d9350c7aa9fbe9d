// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

#include "simcore/body/SoftObject.h"

namespace glenoid::test {

/// One soft object with all nodes free and its own matrix: what tests need to ask for A and b without a
/// scene.
struct SoftSystem {
  SoftSystem(std::shared_ptr<const TetMesh> tets, const ElementTissue& tissueOfAll)
      : mesh(std::move(tets)), tissue(tissueOfAll) {
    const int nodes = static_cast<int>(mesh->nodes.size()), elements = static_cast<int>(mesh->tets.size());
    layout = {false, true, 0, 3 * nodes, 0, 3 * nodes, nodes};
    soft = SoftObject::make(layout, mesh, std::vector<ElementTissue>(elements, tissue), 0).value();
    state.q.resize(layout.qSize);
    for (int i = 0; i < nodes; ++i) state.q.segment<3>(3 * i) = mesh->nodes[i];
    state.v.setZero(layout.vSize);
    state.rotations.setZero(4 * elements);
    for (int i = 0; i < elements; ++i) state.rotations[4 * i + 3] = 1;
    std::vector<std::array<int, 2>> pairs;
    soft->appendBlockPairs(0, pairs);
    symbolic = std::make_shared<BlockSymbolic>(layout.nodeCount, pairs);
    entries = soft->blockEntries(*symbolic, 0);
  }

  /// Leaves the rotations that were found in state.rotations.
  void assemble(const StepSettings& settings, BlockMatrix& A, VecX& b) {
    A.setZero();
    b.setZero(layout.vSize);
    soft->assemble(settings, state, entries, state.rotations, A, b);
  }

  BlockEntry diagonal(int node) const { return entries[10 * mesh->tets.size() + node]; }

  std::shared_ptr<const TetMesh> mesh;
  ElementTissue tissue;
  ObjectLayout layout;
  std::unique_ptr<SoftObject> soft;
  State state;
  std::shared_ptr<const BlockSymbolic> symbolic;
  std::vector<BlockEntry> entries;
};

}  // namespace glenoid::test
