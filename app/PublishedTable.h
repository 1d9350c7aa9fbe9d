// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/live/RunReport.h"

namespace glenoid {

/// One row of the paper's Table 1 ("List of anatomical parts simulated in the arthroscopy example").
/// Source: Otaduy, Garre, Gascón, Miguel, Pérez, Zurdo, "Modeling and Simulation of a Human Shoulder for
/// Interactive Medical Applications", CEIG 2010.
struct PublishedRow {
  int number;
  const char* name;
  int render, collision;
  int tetrahedra;              ///< −1: rigid
  std::vector<int> couplings;  ///< numbers of the other parts, ascending; twice where the table says ×2
};

/// All eleven rows. The humerus row prints "2(x2)" first, a coupling of the humerus to itself and a misprint:
/// the partners' rows do not have it, and neither has this table.
const std::vector<PublishedRow>& publishedTable();

/// One of our parts beside the published one.
struct Comparison {
  const PublishedRow* published = nullptr;  ///< null: the paper has no such part
  bool kind = false, render = false, collision = false, tetrahedra = false, couplings = false;  ///< within tolerance
  bool all() const { return published && kind && render && collision && tetrahedra && couplings; }
};

/// Tolerances: visual triangles 5 %; collision triangles 5 % or 4, whichever is more; tetrahedra 15 %; kind and
/// couplings as they are.
Comparison compare(const PartReport& part);

/// "3, 4, 5, 6(x2)" as the table prints them.
std::string couplingText(const std::vector<int>& numbers);

}  // namespace glenoid
