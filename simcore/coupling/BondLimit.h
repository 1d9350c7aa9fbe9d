// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Joint.h"

namespace glenoid {

/// What the tissue at a bond could mean by its stiffness. A layer of thickness t and Young's modulus E gives E/t per
/// area; bonded tissue ends in a layer of about a millimetre (the fibrocartilage of an enthesis), and in none thinner
/// than 0.1 mm (periosteum, the tidemark). E is that of the softer side, in its stiffest tissue: of the soft parts, or
/// where both are rigid of both, since a rigid part stands for bone that does not give. Over a region larger than a cell
/// of the soft part such a bond is merely glue: the cells give for it. Over a smaller one, nothing that is simulated does,
/// and all of the stiffness sits in one place. A picked node stands for a face of its part's cells, so a bond at nodes is
/// never that small: the cells around each give for it.
struct BondLimit {
  double area = 0;              ///< of the region, or a face for each node, m²
  double stiffness = 0;         ///< of the coupling over all of it, N/m
  double cell = 0;              ///< face of a cell of the finer soft part, m²; 0: none known
  double modulus = 0;           ///< E, Pa; 0 where no material is known, and then there is no limit
  double most = 0;              ///< E / 0.1 mm, N/m per m²
  double usual = 0;             ///< E / 1 mm, N/m per m²: what to lower the stiffness per area to
  double areaForStiffness = 0;  ///< stiffness / usual, m²: what to enlarge the region to, with the whole stiffness kept
  /// More per area than any layer, and smaller than a cell: the region is too small for its stiffness.
  bool exceeded() const { return modulus > 0 && stiffness > most * area && !(cell > 0 && area >= (1 - 1e-6) * cell); }
};

/// The coupling's parts and its region or nodes must be there.
BondLimit bondLimitOf(const Joint& joint, const Coupling& coupling);

}  // namespace glenoid
