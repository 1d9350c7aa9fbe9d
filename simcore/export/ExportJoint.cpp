// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/export/ExportJoint.h"

#include "simcore/export/ExportParts.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/scene/JointFile.h"

namespace glenoid {
namespace {

using namespace exporting;

/// The joint with one part alone, and what belongs to it alone.
Joint onlyPart(const Joint& joint, int index) {
  Joint one = joint;
  const std::string id = joint.parts[index].id;
  one.parts = {joint.parts[index]};
  one.couplings.clear();
  one.exclusions.clear();
  one.bursae.clear();
  one.startProof.reset();
  std::erase_if(one.cages, [&](const Cage& cage) { return cage.part != id; });
  return one;
}

/// The joint with tetrahedra of its soft parts themselves.
Result<Done> conform(Joint& joint, int only, const ExportWish& wish) {
  for (std::size_t p = 0; p < joint.parts.size(); ++p) {
    Part& part = joint.parts[p];
    if (part.kind != PartKind::Soft || (only >= 0 && only != static_cast<int>(p))) continue;
    Result<TetMesh> mesh = conformingMesh(*part.visual, wish.size, part.id, wish.stop);
    if (!mesh) return mesh.error();
    part.volume = std::make_shared<const TetMesh>(std::move(*mesh));
  }
  return Done{};
}

}  // namespace

const TetMesh* exporting::numberedMesh(const Joint& authored, const std::string& part) {
  const int index = findPart(authored, part);
  return index < 0 ? nullptr : authored.parts[index].volume.get();
}

const char* exportMeshWord(ExportMesh mesh) { return mesh == ExportMesh::Cells ? "cells" : "conforming"; }

ExportMesh usualMesh(ExportFormat format) { return format == ExportFormat::Inp ? ExportMesh::Conforming : ExportMesh::Cells; }

bool holdsVolumes(ExportFormat format) { return format != ExportFormat::Glb; }

const char* exportWord(ExportFormat format) {
  switch (format) {
    case ExportFormat::Msh: return "msh";
    case ExportFormat::Vtu: return "vtu";
    case ExportFormat::Scn: return "scn";
    case ExportFormat::Feb: return "feb";
    case ExportFormat::Inp: return "inp";
    case ExportFormat::Glb: return "glb";
  }
  return "";
}

Result<ExportReport> exportJoint(const Joint& original, ExportFormat format, const std::string& path, const ExportWish& wish) {
  if (const auto good = checkJoint(original, {}); !good) return good.error();
  const int index = wish.part.empty() ? -1 : findPart(original, wish.part);
  if (!wish.part.empty() && index < 0) return Error{Fault::UnknownId, {}, {wish.part, "part"}, "export"};
  Joint whole = original;
  if (holdsVolumes(format) && wish.mesh == ExportMesh::Conforming)
    if (const auto done = conform(whole, index, wish); !done) return done.error();
  const Joint joint = index < 0 ? whole : onlyPart(whole, index);
  const bool solidsAlone = format == ExportFormat::Msh || format == ExportFormat::Vtu || format == ExportFormat::Inp;
  if (solidsAlone && softParts(joint).empty())
    return Error{Fault::Unusable, {{}, {}, wish.part, {}}, {"no volume to export"}, "export"};
  Result<Written> written = Error{};
  switch (format) {
    case ExportFormat::Msh: written = writeMsh(joint, wish.mesh); break;
    case ExportFormat::Vtu: written = writeVtu(joint, wish.mesh); break;
    case ExportFormat::Scn: written = writeSofa(joint, wish.mesh, original); break;
    case ExportFormat::Feb: written = writeFebio(joint, wish.mesh, original); break;
    case ExportFormat::Inp: written = writeCalculix(whole, wish.mesh, index, original); break;
    case ExportFormat::Glb: written = writeGltf(joint); break;
  }
  if (!written) return written.error();
  if (holdsVolumes(format))
    for (const Part* part : softParts(joint)) written->report.solids.push_back(figuresOf(*part));
  if (wish.stop && *wish.stop) return Error{Fault::Cancelled, {}, {}, "export"};
  if (const auto saved = writeWholeFile(path, written->bytes); !saved) return saved.error();
  return written->report;
}

}  // namespace glenoid
