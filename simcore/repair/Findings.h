// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simcore/repair/RepairStep.h"

namespace glenoid {

/// What can be wrong with a surface that somebody brings.
enum class FindingKind {
  Unit,              ///< the numbers are not in the unit they are taken for
  TwoSides,          ///< left and right of a body in one file
  Pieces,            ///< more than one shell
  UnusedVertices,
  DuplicateVertices, ///< at the same place, though not the same
  DegenerateFaces,   ///< without area
  DuplicateFaces,    ///< of the same three corners as another
  NonManifoldEdges,  ///< of three or more triangles
  NonManifoldVertices,
  MisorientedEdges,  ///< neighbours with contrary winding
  InsideOut,         ///< closed shells wound inwards
  Holes,             ///< loops of open edges
  Sheets,            ///< pieces without thickness
  Handles,           ///< genus above 0
  SelfIntersections,
  Thin,              ///< walls thinner than the limit
  CannotBeRead,      ///< bad indices or numbers: nothing else was looked at
};
inline constexpr int kFindingKindCount = static_cast<int>(FindingKind::CannotBeRead) + 1;

/// Word of a finding, for programs: "holes", "inside-out" …
const char* findingName(FindingKind kind);

/// Note: good to know. Warning: worth a repair. Blocks: the surface encloses nothing that could be simulated.
enum class FindingSeverity { Note, Warning, Blocks };
const char* findingSeverityName(FindingSeverity severity);

struct Finding {
  FindingKind kind;
  FindingSeverity severity = FindingSeverity::Note;
  long count = 0;
  double measure = 0;                 ///< in the surface's unit: longest hole, thinnest wall; else 0
  std::vector<int> triangles;         ///< where, ascending; at most kMostMarked
  std::vector<RepairStep> repairs;    ///< what is offered, in this order; empty: nothing can be
  bool harmless = false;              ///< the repair changes no place where the surface was right
};
inline constexpr std::size_t kMostMarked = 200000;

/// What a length in the file may mean.
struct UnitGuess {
  double metres = 0;        ///< per unit, 0: cannot be told
  double confidence = 0;    ///< 0…1
  const char* reason = "";  ///< "file", "name", "place", "size", "unclear"
};

enum class BodySide { Unknown, Left, Right, Both };
const char* sideName(BodySide side);

struct SideGuess {
  BodySide side = BodySide::Unknown;
  const char* reason = "unclear";  ///< "name", "mirrored-pieces", "unclear"
};

}  // namespace glenoid
