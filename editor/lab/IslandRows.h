// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <vector>

#include "simcore/step/IslandViews.h"

namespace glenoid {

/// One group of parts that a step solves as one, in words.
struct IslandRow {
  QString members;       ///< names of parts and tools
  QString why;           ///< couplings and contacts that join them
  int unknowns = 0;      ///< velocities
  int rows = 0, contacts = 0, pressing = 0;
  double residual = 0;   ///< NaN: nothing to solve but the free motion
  double ms = 0;         ///< matrix, factor and contacts
  QString method;
};

/// Contact islands of a step, then coupling islands that touch nothing, the dearest first of each.
std::vector<IslandRow> islandRows(const Model& model, const IslandViews& views);

}  // namespace glenoid
