// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/vtk/VtkSurface.h"
#include "simcore/mesh/Cleanup.h"
#include "simcore/mesh/PolygonSplit.h"

namespace glenoid {

Result<Done> VtkCells::toIndices(const std::vector<long long>& corners, long long base) {
  m_corners.clear();
  const auto size = static_cast<long long>(m_mesh.vertices.size());
  for (const long long corner : corners) {
    if (corner < 0 || corner >= size - base)
      return Error{Fault::BadIndex, {m_file, {}, {}, m_cells}, {std::to_string(corner), std::to_string(size - base)}, {}};
    m_corners.push_back(static_cast<int>(corner + base));
  }
  ++m_cells;
  return Done{};
}

Result<Done> VtkCells::polygon(std::vector<long long>& corners, long long base) {
  if (const auto good = toIndices(corners, base); !good) return good;
  if (m_corners.size() < 3) {
    note(ImportNote::LinesDropped, 1);
    return Done{};
  }
  if (m_corners.size() > 3) note(ImportNote::PolygonsSplit, 1);
  splitPolygon(m_mesh.vertices, m_corners, m_mesh.triangles);
  return Done{};
}

Result<Done> VtkCells::strip(std::vector<long long>& corners, long long base) {
  if (const auto good = toIndices(corners, base); !good) return good;
  note(ImportNote::StripsSplit, 1);
  for (std::size_t i = 0; i + 2 < m_corners.size(); ++i)
    m_mesh.triangles.push_back({m_corners[i], m_corners[i + 1 + i % 2], m_corners[i + 2 - i % 2]});
  return Done{};
}

Result<ImportedFile> VtkCells::finish(const char* format) {
  skin();
  for (std::size_t i = 0; i < m_mesh.vertices.size(); ++i)
    if (!m_mesh.vertices[i].allFinite()) return Error{Fault::NotFinite, {m_file, {}, {}, static_cast<long>(i)}, {}, {}};
  if (m_mesh.triangles.empty()) return Error{Fault::BadMesh, {m_file, {}, {}, {}}, {"it holds no triangles"}, {}};
  ImportedFile out;
  out.format = format;
  out.notes = std::move(m_notes);
  out.surfaces.push_back({{}, m_faces.empty() ? std::move(m_mesh) : compact(m_mesh)});  // points inside solids
  return out;
}

}  // namespace glenoid
