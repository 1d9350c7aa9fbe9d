// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "simcore/export/ExportParts.h"
#include "simcore/export/VtuGrid.h"
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

Result<Written> writeMsh(const Joint& joint, ExportMesh mesh) {
  Written out;
  const auto parts = softParts(joint);
  long partly = 0;
  for (const Part* part : parts)
    for (const double fill : tissueOf(joint, *part, mesh).fill) partly += fill < 1 - 1e-9;
  out.lose(LossKind::FillFractions, partly);
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

Result<Written> writeVtu(const Joint& joint, ExportMesh mesh) {
  Written out;
  const auto parts = softParts(joint);
  count(parts, out);
  loseAllButVolumes(joint, out);
  std::vector<PartTissue> tissues;
  std::vector<std::vector<Vec3>> starts;
  for (const Part* part : parts) {
    tissues.push_back(tissueOf(joint, *part, mesh));
    auto start = startNodes(joint, *part);
    if (!start) return start.error();
    starts.push_back(std::move(*start));
  }
  VtuGrid grid;
  VtuField& displacement = grid.pointFields.emplace_back(VtuField{"startDisplacement", 3, false, {}});  // what the cages do, m
  for (std::size_t p = 0; p < parts.size(); ++p) {
    grid.append(*parts[p]->volume);
    for (std::size_t i = 0; i < starts[p].size(); ++i) displacement.append(Vec3(starts[p][i] - parts[p]->volume->nodes[i]));
  }
  const auto perTet = [&](const char* name, bool whole, auto&& value) {
    VtuField& field = grid.cellFields.emplace_back(VtuField{name, 1, whole, {}});
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (std::size_t t = 0; t < parts[p]->volume->tets.size(); ++t) field.values.push_back(value(p, t));
  };
  const auto material = [&](std::size_t p, std::size_t t) -> const Material& { return joint.materials[tissues[p].material[t]]; };
  perTet("part", true, [&](std::size_t p, std::size_t) { return parts[p]->number; });
  perTet("youngsModulus", false, [&](std::size_t p, std::size_t t) { return material(p, t).youngsModulus; });
  perTet("poissonRatio", false, [&](std::size_t p, std::size_t t) { return material(p, t).poissonRatio; });
  perTet("density", false, [&](std::size_t p, std::size_t t) { return material(p, t).density; });
  perTet("fill", false, [&](std::size_t p, std::size_t t) { return tissues[p].fill[t]; });
  out << vtuText(grid);
  return out;
}

}  // namespace glenoid::exporting
