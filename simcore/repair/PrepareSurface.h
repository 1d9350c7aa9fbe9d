// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/import/ImportedFile.h"
#include "simcore/repair/RepairStep.h"

namespace glenoid {

/// How a surface of somebody else's file becomes one of a joint: everything an author decides on import, as data that
/// can be kept and repeated. Taken in this order: surface, unit, axes, turn, shift, shell, repairs, thickness, simplification.
/// Lengths in repairs are therefore metres in the joint's frame W.
struct SurfaceSource {
  std::optional<double> metresPerUnit;  ///< nothing: as the file says
  std::optional<AxisMap> axes;          ///< of the file that become X, Y, Z of W; nothing: as its LPS or RAS asks for, else as they are
  Mat3 turn_W = Mat3::Identity();       ///< after the axes, about `about_W`: a rotation and, where it is one, a scale
  Vec3 about_W = Vec3::Zero();          ///< m
  Vec3 translate_W = Vec3::Zero();      ///< m, after the turn
  std::string surface;                  ///< name in the file; may be empty where there is one
  int shell = -1;                       ///< by area from 0; −1: all of them
  std::vector<RepairStep> repairs;
  double thicken = 0;                   ///< m; 0: as it is
  int simplify = 0;                     ///< triangles of the visual surface; 0: all
};

/// The surface and everything that was lost or changed on the way.
struct PreparedSurface {
  TriMesh mesh;  ///< W, m
  std::string format;
  double metresPerUnit = 1;
  std::vector<NoteCount> notes;
  std::vector<RepairChange> changes;
  long trianglesBefore = 0;  ///< of the chosen surface, before shell, repairs and simplification
};

/// Fails with UnknownId (arguments: name, kind) or SchemaMismatch (argument: what) where the choice of a surface, a shell or
/// the unit is missing or wrong, and as repair() and simplify() do.
Result<PreparedSurface> prepareSurface(const ImportedFile& file, const SurfaceSource& source);

}  // namespace glenoid
