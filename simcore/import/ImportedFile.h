// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// What a reader lost or changed on the way. Nothing of this happens silently.
enum class ImportNote {
  PolygonsSplit,      ///< faces of more than three corners were cut into triangles
  StripsSplit,        ///< triangle strips were cut into triangles
  PointsJoined,       ///< points at the very same place became one: where the reader repeats a point for each face
  NodesMoved,         ///< surfaces carried a transform, which was applied
  NodesMirrored,      ///< … one that mirrors, so the winding was turned back
  LinesDropped,
  PointsDropped,      ///< points that stand alone
  NormalsDropped,     ///< surfaces with normals of their own
  TexturesDropped,    ///< surfaces with texture coordinates
  ColoursDropped,     ///< surfaces with colours at their points
  MaterialsDropped,
  AnimationsDropped,  ///< animations and bones
  OthersDropped,      ///< lights and cameras
  DataDropped,        ///< arrays of values at points or cells
  SurfacesWithoutTriangles,
  SolidsSkinned,      ///< solid cells, of which the faces on the outside were taken
};
inline constexpr int kImportNoteCount = static_cast<int>(ImportNote::SolidsSkinned) + 1;

/// Word of a note, for programs and logs: "polygons-split" …
const char* importNoteName(ImportNote note);

struct NoteCount {
  ImportNote note;
  long count;
  bool operator==(const NoteCount&) const = default;
};

/// The frame that a file says its coordinates are in: left, posterior, superior or right, anterior, superior (3D Slicer and
/// others write SPACE=LPS or RAS), or which axis points up, where it says no more.
enum class FileAxes { Unsaid, Lps, Ras, XUp, YUp, ZUp };
inline constexpr int kFileAxesCount = static_cast<int>(FileAxes::ZUp) + 1;
/// "LPS", "RAS", "X up" …; empty for Unsaid.
const char* fileAxesName(FileAxes axes);

/// One surface of a file, with the file's own units and axes; transforms of its nodes are applied. Indices are
/// valid and coordinates finite, nothing else is promised.
struct ImportedSurface {
  std::string name;  ///< as the file calls it, may be empty
  TriMesh mesh;
};

struct ImportedFile {
  std::string format;                    ///< "STL", "OBJ" …
  std::optional<double> metresPerUnit;   ///< where the file or its format says it
  FileAxes axes = FileAxes::Unsaid;
  std::vector<ImportedSurface> surfaces; ///< at least one, each with triangles
  std::vector<NoteCount> notes;          ///< ascending by note, counts > 0
};

/// Adds to the count of a note, keeping the order.
void addNote(std::vector<NoteCount>& notes, ImportNote note, long count);

/// Points at the very same place (bit for bit, −0 = 0) become the first of them; triangles stay all, in order, even
/// those that lose a corner. Points that no triangle uses go. Answers how many points were joined to another.
long joinIdenticalPoints(TriMesh& mesh);

}  // namespace glenoid
