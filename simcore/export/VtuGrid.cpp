// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/export/VtuGrid.h"

#include "simcore/export/ExportParts.h"

namespace glenoid {
namespace {

using exporting::Written;

void begin(Written& out, std::string_view type, const std::string& name, int components) {
  out << "<DataArray type=\"" << type << "\" Name=\"" << exporting::xmlText(name) << "\"";
  if (components > 1) out << " NumberOfComponents=\"" << components << "\"";
  out << " format=\"ascii\">\n";
}

void end(Written& out) { out << "</DataArray>\n"; }

void write(const VtuField& field, Written& out) {
  begin(out, field.whole ? "Int32" : "Float64", field.name, field.components);
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    if (field.whole)
      out << static_cast<long>(field.values[i]);
    else
      out << field.values[i];
    out << ((i + 1) % static_cast<std::size_t>(field.components) == 0 ? "\n" : " ");
  }
  end(out);
}

}  // namespace

void VtuGrid::append(const TetMesh& mesh) {
  const int first = static_cast<int>(points.size());
  points.insert(points.end(), mesh.nodes.begin(), mesh.nodes.end());
  for (const auto& tet : mesh.tets) tets.push_back({first + tet[0], first + tet[1], first + tet[2], first + tet[3]});
}

std::string vtuText(const VtuGrid& grid) {
  Written out;
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
      << "<Piece NumberOfPoints=\"" << grid.points.size() << "\" NumberOfCells=\"" << grid.tets.size() << "\">\n<PointData";
  if (!grid.pointFields.empty()) out << " Vectors=\"" << exporting::xmlText(grid.pointFields.front().name) << "\"";
  out << ">\n";
  for (const VtuField& field : grid.pointFields) write(field, out);
  out << "</PointData>\n<CellData>\n";
  for (const VtuField& field : grid.cellFields) write(field, out);
  out << "</CellData>\n<Points>\n";
  begin(out, "Float64", "Points", 3);
  for (const Vec3& x : grid.points) out << x.x() << " " << x.y() << " " << x.z() << "\n";
  end(out);
  out << "</Points>\n<Cells>\n";
  begin(out, "Int64", "connectivity", 1);
  for (const auto& tet : grid.tets) out << tet[0] << " " << tet[1] << " " << tet[2] << " " << tet[3] << "\n";
  end(out);
  begin(out, "Int64", "offsets", 1);
  for (std::size_t t = 1; t <= grid.tets.size(); ++t) out << 4 * t << "\n";
  end(out);
  begin(out, "UInt8", "types", 1);
  constexpr int kTetra = 10;
  for (std::size_t t = 0; t < grid.tets.size(); ++t) out << kTetra << "\n";
  end(out);
  out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return std::move(out.bytes);
}

}  // namespace glenoid
