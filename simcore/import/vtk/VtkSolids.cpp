// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of unstructured grids by their VTK type: faces as they are, solids by the faces that only one of them has.
#include <algorithm>
#include <span>

#include "simcore/import/vtk/VtkSurface.h"
#include "simcore/mesh/PolygonSplit.h"

namespace glenoid {
namespace {

/// Faces of a solid by local corners, −1 ends them, seen from outside against the clock. Source: VTK's vtkTetra, vtkHexahedron,
/// vtkWedge and vtkPyramid (their figures in the file formats' description give the corners).
using Face = std::array<int, 4>;
constexpr std::array<Face, 4> kTetra{{{0, 1, 3, -1}, {1, 2, 3, -1}, {2, 0, 3, -1}, {0, 2, 1, -1}}};
constexpr std::array<Face, 6> kHexahedron{{{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
constexpr std::array<Face, 5> kWedge{{{0, 1, 2, -1}, {3, 5, 4, -1}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}};
constexpr std::array<Face, 5> kPyramid{{{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}};

/// A kind of cell: how many corners come first, before those of curved edges, and its faces where it is a solid.
struct Kind {
  int type;
  std::size_t corners;  ///< 0: all of them
  std::span<const Face> faces;
};
const std::array kKinds{Kind{5, 3, {}},          Kind{22, 3, {}},          Kind{34, 3, {}},         Kind{7, 0, {}},         Kind{9, 4, {}},
                        Kind{8, 4, {}},          Kind{23, 4, {}},          Kind{28, 4, {}},         Kind{10, 4, kTetra},    Kind{24, 4, kTetra},
                        Kind{12, 8, kHexahedron}, Kind{11, 8, kHexahedron}, Kind{25, 8, kHexahedron}, Kind{29, 8, kHexahedron}, Kind{13, 6, kWedge},
                        Kind{26, 6, kWedge},     Kind{14, 5, kPyramid},    Kind{27, 5, kPyramid}};

std::array<int, 4> ascending(std::array<int, 4> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

}  // namespace

Result<Done> VtkCells::cell(int type, std::vector<long long>& corners, long long base) {
  const auto dropped = [&](ImportNote what) {
    note(what, 1);
    ++m_cells;
    return Done{};
  };
  if (type == 1 || type == 2) return dropped(ImportNote::PointsDropped);
  if (type == 3 || type == 4 || type == 21) return dropped(ImportNote::LinesDropped);
  if (type == 6) return strip(corners, base);
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return k.type == type; });
  const auto fail = [&](const std::string& what) { return Error{Fault::BadMesh, {m_file, {}, {}, m_cells}, {what}, {}}; };
  if (kind == kKinds.end()) return fail("cells of VTK's type " + std::to_string(type) + " are not known here");
  if (corners.size() < std::max<std::size_t>(kind->corners, 3)) return fail("a cell with fewer corners than its type has");
  if (kind->corners > 0) corners.resize(kind->corners);
  if (type == 8) std::swap(corners[2], corners[3]);
  if (type == 11) std::swap(corners[2], corners[3]), std::swap(corners[6], corners[7]);
  if (const auto good = toIndices(corners, base); !good) return good;
  if (kind->faces.empty()) {
    m_flat.push_back(m_corners);
    return Done{};
  }
  note(ImportNote::SolidsSkinned, 1);
  double& volume = m_volumes[type];
  const auto at = [&](int i) -> const Vec3& { return m_mesh.vertices[static_cast<std::size_t>(m_corners[static_cast<std::size_t>(i)])]; };
  for (const Face& face : kind->faces)
    for (int i = 1; i + 1 < 4 && face[i + 1] >= 0; ++i) volume += (at(face[0]) - at(0)).dot((at(face[i]) - at(0)).cross(at(face[i + 1]) - at(0)));
  for (const Face& face : kind->faces) {
    std::array<int, 4> around{-1, -1, -1, -1};
    for (int i = 0; i < 4 && face[i] >= 0; ++i) around[i] = m_corners[static_cast<std::size_t>(face[i])];
    const auto [known, isNew] = m_faces.try_emplace(ascending(around), SolidFace{around, type, m_faceCount, 0});
    m_faceCount += isNew;
    ++known->second.solids;
  }
  return Done{};
}

void VtkCells::skin() {
  std::vector<const SolidFace*> outer;
  for (const auto& [key, face] : m_faces)
    if (face.solids == 1) outer.push_back(&face);
  std::sort(outer.begin(), outer.end(), [](const SolidFace* a, const SolidFace* b) { return a->order < b->order; });
  for (const SolidFace* face : outer) {
    std::array<int, 4> around = face->around;
    const std::size_t corners = around[3] < 0 ? 3 : 4;
    // Writers differ in how they number a wedge, and some mirror: what all solids of a type enclose says which way they are wound.
    if (m_volumes[face->type] < 0) std::reverse(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(corners));
    splitPolygon(m_mesh.vertices, std::span<const int>(around).first(corners), m_mesh.triangles);
  }
  for (const std::vector<int>& flat : m_flat) {
    std::array<int, 4> corners{-1, -1, -1, -1};
    if (flat.size() <= 4) std::copy(flat.begin(), flat.end(), corners.begin());
    if (flat.size() <= 4 && m_faces.count(ascending(corners))) continue;  // what a mesher adds to mark a boundary
    if (flat.size() > 3) note(ImportNote::PolygonsSplit, 1);
    splitPolygon(m_mesh.vertices, flat, m_mesh.triangles);
  }
}

}  // namespace glenoid
