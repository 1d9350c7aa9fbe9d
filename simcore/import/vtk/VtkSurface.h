// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <map>
#include <string>
#include <string_view>

#include "simcore/base/Error.h"
#include "simcore/import/ImportedFile.h"

namespace glenoid {

/// VTK PolyData: triangles, polygons (split) and strips; unstructured grids: their faces, and the faces of their solids that no other
/// solid has (of curved cells the corners); lines, single points and values at points or cells are dropped and noted. Both readers believe no count that the bytes could not hold. They fail with UnknownFormat (no
/// VTK), BadMesh (argument: what; another kind of data set, a header that makes no sense), FileTruncated, NotFinite
/// (element: point), BadIndex (arguments: index, size; element: cell) and Unusable … never with anything half read.
/// Source: "VTK File Formats", The VTK User's Guide, 11th edition, 2010.

/// Legacy `.vtk`, DATASET POLYDATA or UNSTRUCTURED_GRID, versions 1 to 5, ascii and binary.
Result<ImportedFile> parseVtkSurface(std::string_view bytes, const std::string& file);

/// XML `.vtp` and `.vtu`: ascii, inline base64, appended raw or base64; plain or packed by zlib; either byte order.
Result<ImportedFile> parseVtp(std::string_view bytes, const std::string& file);

/// What both collect: checks indices, splits polygons and strips.
class VtkCells {
 public:
  explicit VtkCells(std::string file) : m_file(std::move(file)) {}
  std::vector<Vec3>& points() { return m_mesh.vertices; }
  /// One cell; `base` is added to every index (pieces of a VTP).
  Result<Done> polygon(std::vector<long long>& corners, long long base);
  Result<Done> strip(std::vector<long long>& corners, long long base);
  /// One cell of an unstructured grid by its VTK type; BadMesh for a type that is not known or has too few corners.
  Result<Done> cell(int type, std::vector<long long>& corners, long long base);
  void note(ImportNote note, long count) { addNote(m_notes, note, count); }
  /// Fails with NotFinite or, without any triangle, BadMesh.
  Result<ImportedFile> finish(const char* format);

 private:
  Result<Done> toIndices(const std::vector<long long>& corners, long long base);
  std::string m_file;
  TriMesh m_mesh;
  std::vector<NoteCount> m_notes;
  std::vector<int> m_corners;
  long m_cells = 0;
  struct SolidFace {
    std::array<int, 4> around;  ///< −1 ends a triangle
    int type;                   ///< of the solid that had it first
    long order;                 ///< in which they came
    int solids;                 ///< that have it
  };
  void skin();
  std::map<std::array<int, 4>, SolidFace> m_faces;  ///< by ascending corners
  std::map<int, double> m_volumes;  ///< six times, with its sign, of all solids of a type
  std::vector<std::vector<int>> m_flat;
  long m_faceCount = 0;
};

}  // namespace glenoid
