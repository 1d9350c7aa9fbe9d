// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <set>
#include <string>

#include "simcore/repair/Findings.h"

namespace glenoid {

struct DiagnosisOptions {
  std::string name;                      ///< of the surface or its file: hints of anatomy and side
  std::optional<double> metresPerUnit;   ///< where the file or the user said it
  std::optional<UnitGuess> guess;        ///< in place of one from this surface alone
  double thinLimit = 1e-3;               ///< m
  bool selfIntersections = true;         ///< the dearest part
  std::function<bool()> cancelled;       ///< asked between the parts; the rest is then left out
};

/// What a surface is like, and what about it asks for repair. Looks, never changes. 500 000 triangles take a few
/// seconds. Lengths in the surface's own unit unless it says metres.
struct SurfaceDiagnosis {
  int vertices = 0, triangles = 0;
  Box3 box;
  UnitGuess unit;
  SideGuess side;
  int shells = 0, closedShells = 0;
  int genus = -1;                ///< −1 unless closed and manifold
  long holes = 0, openEdges = 0;
  double longestHole = 0;        ///< length around
  double area = 0, volume = 0;   ///< volume signed, meaningless with holes
  double thicknessLeast = 0, thicknessMedian = 0;  ///< by rays; first of a hundred parts, and half; 0: no wall found
  long selfIntersections = 0;    ///< pairs; −1: not looked at
  bool cancelled = false;
  std::vector<Finding> findings; ///< ascending by kind

  const Finding* find(FindingKind kind) const;
  /// Closed, manifold, outwards, nothing that blocks.
  bool healthy() const;
};

SurfaceDiagnosis diagnose(const TriMesh& mesh, const DiagnosisOptions& options = {});

/// The repairs that these findings offer, in an order that works; kinds that were not found offer nothing.
std::vector<RepairStep> repairsFor(const SurfaceDiagnosis& diagnosis, const std::set<FindingKind>& chosen);

/// Those of all findings whose repair is harmless; what `--auto` takes.
std::vector<RepairStep> automaticRepairs(const SurfaceDiagnosis& diagnosis);

/// Metres per unit of one surface from its size, its place and its name: sizes of bones, muscles and ligaments of adults, whole
/// or parts of them. Surfaces of one file together: GuessUnit.h.
UnitGuess guessUnit(const Box3& box, const std::string& name);

}  // namespace glenoid
