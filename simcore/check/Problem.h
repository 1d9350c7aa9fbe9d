// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simcore/author/RigidAdvice.h"
#include "simcore/base/Error.h"
#include "simcore/scene/Part.h"
#include "simcore/scene/UnusedSettings.h"

namespace glenoid {

/// What can be wrong with a joint that is being made. The sentence for each is made at the top
/// (editor/core/ProblemSentences); what `count`, `figure` and `wanted` mean stands here.
enum class ProblemKind {
  UnitOfJoint,         ///< figure: largest extent, m; wanted: factor that makes it a joint's
  UnitOfPart,          ///< the same of one part among others
  NoSurface,           ///< a surface is missing, has bad indices or numbers that are not finite
  SurfaceOpen,         ///< count: open edges
  SurfaceTangled,      ///< count: edges and vertices where it is no manifold, or triangles without area
  SurfaceInwards,      ///< figure: enclosed volume, m³, negative
  SurfaceCutsItself,   ///< count: pairs of triangles; element: first triangle
  NoVolume,            ///< a soft part without tetrahedra, or with nodes that are not there
  FlatTetrahedra,      ///< count; element: the worst; figure: its volume, m³
  InvertedTetrahedra,  ///< the same; their corners only need turning around
  NoMaterial,          ///< material: the unknown id, empty: none at all; other: id of one that would do, may be empty
  CouplingBroken,      ///< names a part, a region or nodes that are not there; count: nodes it names
  RegionCannotHold,    ///< a coupling over a line; figure: width of its region, m, 0 where it has no area
  NodesCannotHold,     ///< a coupling at nodes that are too few, in a line or named twice; count: nodes; `error` says why
  RegionTooSmall,      ///< a coupling stiffer per area than tissue is; figure: area of its region, m²; wanted: stiffness
                       ///< per area that tissue has, N/m per m²
  BondedCollision,     ///< figure: bonded area, m²
  PartLoose,           ///< nothing holds it; figure: distance of the nearest other part, m; infinite when alone
  IslandLoose,         ///< parts coupled to each other and to nothing that stays; parts: which
  WeightOverstretches, ///< a soft part hangs, and the weight below stretches it; figure: to how many times its length, in the mean over
                       ///< the weakest tenth of its height; wanted: Young's modulus that would keep that at 1.2, Pa
  StepTooLong,         ///< a spring that holds a part swings faster than steps can show, so they damp it out; figure: how often, Hz;
                       ///< wanted: a step that would show it, s
  CageUnusable,        ///< `error` says why
  CageCrushes,         ///< count: tetrahedra below the limit; element: the worst; figure: its volume at the start over
                       ///< that at rest; wanted: part of the handles' way that keeps the limit
  CageMovesFar,        ///< figure: farthest vertex of the collision surface from rest, m; wanted: thickness of the part, m
  CageSqueezes,        ///< count: tetrahedra below `wanted`, the ratio of volumes that is usual; element: the worst; figure: its
                       ///< volume at the start over that at rest
  Overlap,             ///< count: pairs of triangles at the start; figure: deepest vertex, m; element: a triangle of
                       ///< `part`; parts: those of the two that are soft and can be moved by cages; `rigid` where none is
  Swallowed,           ///< `part` lies wholly inside `other` at the start; figure: deepest vertex, m
  ProofMissing,        ///< the start is free of overlap, and the joint does not say so
  ProofStale,          ///< the joint says so of other meshes, cages or exclusions
  SettingUnused,       ///< of the scenario: `unused` says which wish changes nothing
  Unsound,             ///< anything else that keeps it from being saved: `error`
};
inline constexpr int kProblemKindCount = static_cast<int>(ProblemKind::Unsound) + 1;

/// English word of a kind, for logs, JSON and tests.
const char* problemName(ProblemKind kind);

/// An Error keeps the joint from running or from meaning something; a Warning is probably a slip; a Note is advice.
enum class Severity { Note, Warning, Error };

/// One thing that an author should look at. Ids, so that it outlives an edit; empty where they do not apply.
struct Problem {
  ProblemKind kind = ProblemKind::Unsound;
  Severity severity = Severity::Error;
  std::string part, other, coupling, region, material;
  std::optional<SurfaceKind> surface;
  std::optional<long> element;
  long count = 0;
  double figure = 0, wanted = 0;
  std::vector<std::string> parts;
  std::optional<Error> error;
  std::optional<UnusedSetting> unused;
  std::optional<RigidAdvice> rigid;
};

}  // namespace glenoid
