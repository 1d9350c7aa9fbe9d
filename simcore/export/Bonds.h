// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "simcore/export/ExportParts.h"

namespace glenoid::exporting {

/// Couplings as bonds of whole nodes that do not give, for programs that have no spring between two points of elements. A node
/// has one bond at most, and nothing that is bonded hangs on what is bonded itself.
struct Bonds {
  struct Bond {
    int coupling = 0;                  ///< in joint.couplings
    int rigid = -1;                    ///< part: the node moves with it
    std::array<long, 4> nodes{};       ///< else: it is the weighted sum of these, the corners of a tetrahedron
    std::array<double, 4> weights{};
  };
  std::map<long, Bond> bonds;   ///< by node
  std::vector<long> first;      ///< number of each part's first node; from 1, part by part
  long leftOut = 0;             ///< nodes that something held already
  long bonded = 0;              ///< couplings
  long rigidCouplings = 0;      ///< couplings of two rigid parts, which have no node
};

/// Of all couplings, or of those of one soft part (its index; else −1), to which everything else is rigid then. Nodes are those
/// of the volumes and, with `bones`, of the collision surfaces of rigid parts. `authored`: the joint as it was given. Fails as deriveSprings does.
Result<Bonds> bondsOf(const Joint& joint, ExportMesh mesh, bool bones, const Joint& authored, int only = -1);

}  // namespace glenoid::exporting
