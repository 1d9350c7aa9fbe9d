// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "simcore/export/ExportParts.h"
#include "simcore/scene/Start.h"

namespace glenoid::exporting {
namespace {

/// What a mesh of volumes cannot say of a joint.
void loseAllButVolumes(const Joint& joint, Written& out) {
  const long soft = static_cast<long>(softParts(joint).size()), all = static_cast<long>(joint.parts.size());
  long named = 0;
  for (const Part& part : joint.parts) named += static_cast<long>(part.regions.size() + part.landmarks.size());
  out.lose(LossKind::RigidParts, all - soft);
  out.lose(LossKind::Surfaces, 2 * all);
  out.lose(LossKind::Couplings, static_cast<long>(joint.couplings.size()));
  out.lose(LossKind::Exclusions, static_cast<long>(joint.exclusions.size()));
  out.lose(LossKind::Bursae, static_cast<long>(joint.bursae.size()));
  out.lose(LossKind::Regions, named);
}

void count(const std::vector<const Part*>& parts, Written& out) {
  for (const Part* part : parts) {
    out.report.nodes += static_cast<long>(part->volume->nodes.size());
    out.report.tetrahedra += static_cast<long>(part->volume->tets.size());
  }
}

/// A name between quotes in an MSH file.
std::string quotedName(std::string name) {
  std::replace_if(name.begin(), name.end(), [](char c) { return c == '"' || static_cast<unsigned char>(c) < 0x20; }, '\'');
  return name;
}

}  // namespace

Result<Written> writeMsh(const Joint& joint) {
  Written out;
  const auto parts = softParts(joint);
  count(parts, out);
  loseAllButVolumes(joint, out);
  out.lose(LossKind::Materials, static_cast<long>(joint.materials.size()));
  out.lose(LossKind::Cages, static_cast<long>(joint.cages.size()));
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n" << parts.size() << "\n";
  for (const Part* part : parts) out << "3 " << part->number << " \"" << quotedName(part->id) << "\"\n";
  out << "$EndPhysicalNames\n$Entities\n0 0 0 " << parts.size() << "\n";
  for (const Part* part : parts) {
    Box3 box;
    for (const Vec3& node : part->volume->nodes) box.extend(node);
    out << part->number;
    for (const Vec3& corner : {box.min(), box.max()})
      for (int k = 0; k < 3; ++k) out << " " << corner[k];
    out << " 1 " << part->number << " 0\n";
  }
  out << "$EndEntities\n$Nodes\n" << parts.size() << " " << out.report.nodes << " 1 " << out.report.nodes << "\n";
  long first = 1;
  for (const Part* part : parts) {
    const auto& nodes = part->volume->nodes;
    out << "3 " << part->number << " 0 " << nodes.size() << "\n";
    for (std::size_t i = 0; i < nodes.size(); ++i) out << first + static_cast<long>(i) << "\n";
    for (const Vec3& x : nodes) out << x.x() << " " << x.y() << " " << x.z() << "\n";
    first += static_cast<long>(nodes.size());
  }
  out << "$EndNodes\n$Elements\n" << parts.size() << " " << out.report.tetrahedra << " 1 " << out.report.tetrahedra << "\n";
  first = 1;
  long tag = 1;
  for (const Part* part : parts) {
    constexpr int kTetrahedron = 4;
    out << "3 " << part->number << " " << kTetrahedron << " " << part->volume->tets.size() << "\n";
    for (const auto& tet : part->volume->tets) {
      out << tag++;
      for (const int node : tet) out << " " << first + node;
      out << "\n";
    }
    first += static_cast<long>(part->volume->nodes.size());
  }
  out << "$EndElements\n";
  return out;
}

Result<Written> writeVtu(const Joint& joint) {
  Written out;
  const auto parts = softParts(joint);
  count(parts, out);
  loseAllButVolumes(joint, out);
  std::vector<PartTissue> tissues;
  std::vector<std::vector<Vec3>> starts;
  for (const Part* part : parts) {
    tissues.push_back(tissueOf(joint, *part));
    auto start = startNodes(joint, *part);
    if (!start) return start.error();
    starts.push_back(std::move(*start));
  }
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
      << "<Piece NumberOfPoints=\"" << out.report.nodes << "\" NumberOfCells=\"" << out.report.tetrahedra << "\">\n";
  const auto array = [&](std::string_view type, std::string_view name, int components) {
    out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\"";
    if (components > 1) out << " NumberOfComponents=\"" << components << "\"";
    out << " format=\"ascii\">\n";
  };
  const auto end = [&] { out << "</DataArray>\n"; };
  out << "<PointData Vectors=\"startDisplacement\">\n";
  array("Float64", "startDisplacement", 3);  // what the cages do, m
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t i = 0; i < starts[p].size(); ++i) {
      const Vec3 u = starts[p][i] - parts[p]->volume->nodes[i];
      out << u.x() << " " << u.y() << " " << u.z() << "\n";
    }
  end();
  out << "</PointData>\n<CellData>\n";
  const auto perTet = [&](std::string_view type, std::string_view name, auto&& value) {
    array(type, name, 1);
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (std::size_t t = 0; t < parts[p]->volume->tets.size(); ++t) out << value(p, t) << "\n";
    end();
  };
  const auto material = [&](std::size_t p, std::size_t t) -> const Material& { return joint.materials[tissues[p].material[t]]; };
  perTet("Int32", "part", [&](std::size_t p, std::size_t) { return parts[p]->number; });
  perTet("Float64", "youngsModulus", [&](std::size_t p, std::size_t t) { return material(p, t).youngsModulus; });
  perTet("Float64", "poissonRatio", [&](std::size_t p, std::size_t t) { return material(p, t).poissonRatio; });
  perTet("Float64", "density", [&](std::size_t p, std::size_t t) { return material(p, t).density; });
  perTet("Float64", "fill", [&](std::size_t p, std::size_t t) { return tissues[p].fill[t]; });
  out << "</CellData>\n<Points>\n";
  array("Float64", "Points", 3);
  for (const Part* part : parts)
    for (const Vec3& x : part->volume->nodes) out << x.x() << " " << x.y() << " " << x.z() << "\n";
  end();
  out << "</Points>\n<Cells>\n";
  array("Int64", "connectivity", 1);
  long first = 0;
  for (const Part* part : parts) {
    for (const auto& tet : part->volume->tets)
      out << first + tet[0] << " " << first + tet[1] << " " << first + tet[2] << " " << first + tet[3] << "\n";
    first += static_cast<long>(part->volume->nodes.size());
  }
  end();
  array("Int64", "offsets", 1);
  for (long t = 1; t <= out.report.tetrahedra; ++t) out << 4 * t << "\n";
  end();
  array("UInt8", "types", 1);
  constexpr int kTetra = 10;
  for (long t = 0; t < out.report.tetrahedra; ++t) out << kTetra << "\n";
  end();
  out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return out;
}

}  // namespace glenoid::exporting
