// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/export/ConformingMesh.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// Formats of other programs. All lengths in metres, other quantities in SI, coordinates in the rest frame W.
enum class ExportFormat {
  Msh,  ///< Gmsh MSH 4.1, ASCII: volumes, a physical group for each part. Source: Gmsh reference manual, "MSH file format"
  Vtu,  ///< VTK XML unstructured grid, ASCII: volumes with tissue. Source: VTK file formats, The VTK User's Guide
  Scn,  ///< SOFA scene, XML, component names of v23.12. Source: SOFA's component documentation
  Feb,  ///< FEBio input, specification 4.0. Source: FEBio user's manual 4
  Inp,  ///< CalculiX input deck: tetrahedra of ten nodes, rigid ends, an example of a step. Source: Dhondt, CalculiX CrunchiX user's manual 2.20
  Glb,  ///< glTF 2.0 binary: surfaces. Source: Khronos, glTF 2.0 specification
};
inline constexpr ExportFormat kExportFormats[] = {ExportFormat::Msh, ExportFormat::Vtu, ExportFormat::Scn, ExportFormat::Feb,
                                                  ExportFormat::Inp, ExportFormat::Glb};
/// "msh", "vtu", …: the word of the command line and the ending of the file.
const char* exportWord(ExportFormat format);
/// Whether it holds tetrahedra.
bool holdsVolumes(ExportFormat format);

/// Of which tetrahedra soft parts are written.
enum class ExportMesh {
  Cells,       ///< those that the simulation has, which stand out of the part: their volume is several times its own
  Conforming,  ///< of the part itself, see ConformingMesh.h; for solvers
};
inline constexpr ExportMesh kExportMeshes[] = {ExportMesh::Cells, ExportMesh::Conforming};
/// "cells", "conforming".
const char* exportMeshWord(ExportMesh mesh);

/// What is written unless something else is asked for: a deck for a solver is of the parts, the others have always held cells.
ExportMesh usualMesh(ExportFormat format);

struct ExportWish {
  std::string part = {};                    ///< id; empty: all
  ExportMesh mesh = ExportMesh::Cells;
  TetSize size = {};                        ///< of conforming tetrahedra
  const std::atomic<bool>* stop = nullptr;  ///< set to give up; nothing is written then
};

/// What a format cannot say, or says otherwise. The sentences are made at the top.
enum class LossKind {
  RigidParts,        ///< count: rigid parts that were left out
  Surfaces,          ///< count: surfaces that were left out
  Volumes,           ///< count: tetrahedral meshes that were left out
  Materials,         ///< count: materials whose mechanical values were left out
  MaterialLaw,       ///< corotational linear elasticity became another law
  FillFractions,     ///< count: tetrahedra only partly tissue, written as full ones
  MaterialRegions,   ///< count: parts of several materials, written with their first one
  Couplings,         ///< count: couplings that were left out
  CouplingStiffness, ///< count: couplings written as rigid bonds
  BondsLeftOut,      ///< count: nodes of couplings that another condition holds already
  Contact,           ///< contact was left out
  ContactPenalty,    ///< hard contact became a penalty
  Friction,          ///< friction was left out
  Damping,           ///< damping by material became one value for all
  Exclusions,        ///< count: pairs without contact that were left out
  Bursae,            ///< count
  Regions,           ///< count: regions and landmarks
  Cages,             ///< count: cages; where the format can, the start they make is kept
  FixedBones,        ///< count: rigid parts written as fixed, since who moves is a scenario's matter
  Precision,         ///< coordinates in single precision
};
inline constexpr int kLossKindCount = static_cast<int>(LossKind::Precision) + 1;
struct Loss {
  LossKind kind;
  long count = 0;  ///< 0 where the kind says nothing of a count
  bool operator==(const Loss&) const = default;
};

/// What the tetrahedra of a soft part are like.
struct SolidFigures {
  std::string part;           ///< id
  long tetrahedra = 0;
  double volume = 0;          ///< m³, of the tetrahedra
  double partVolume = 0;      ///< m³, that the part's own surface encloses
  double leastDihedral = 0;   ///< rad, least angle between two faces of a tetrahedron; regular: 1.23
  double leastRadiusRatio = 0;///< least of three times the insphere's radius over the circumsphere's; regular: 1
};
SolidFigures figuresOf(const Part& part);

struct ExportReport {
  std::vector<Loss> losses;
  std::vector<SolidFigures> solids;               ///< of a format that holds volumes, in the joint's order
  long nodes = 0, tetrahedra = 0, triangles = 0;  ///< written
};

/// Writes the joint, or one part of it, atomically. Fails as checkJoint does (nothing is written of a joint that could not be
/// saved), with UnknownId (arguments: id, "part"), with Unusable where the format holds volumes alone and there are none, as
/// conformingMesh and as writeWholeFile do.
Result<ExportReport> exportJoint(const Joint& joint, ExportFormat format, const std::string& path, const ExportWish& wish = {});

}  // namespace glenoid
