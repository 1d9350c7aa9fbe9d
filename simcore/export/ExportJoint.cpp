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

}  // namespace

const char* exportWord(ExportFormat format) {
  switch (format) {
    case ExportFormat::Msh: return "msh";
    case ExportFormat::Vtu: return "vtu";
    case ExportFormat::Scn: return "scn";
    case ExportFormat::Feb: return "feb";
    case ExportFormat::Glb: return "glb";
  }
  return "";
}

Result<ExportReport> exportJoint(const Joint& whole, ExportFormat format, const std::string& path, const std::string& part) {
  if (const auto good = checkJoint(whole, {}); !good) return good.error();
  const int index = part.empty() ? -1 : findPart(whole, part);
  if (!part.empty() && index < 0) return Error{Fault::UnknownId, {}, {part, "part"}, "export"};
  const Joint joint = part.empty() ? whole : onlyPart(whole, index);
  if ((format == ExportFormat::Msh || format == ExportFormat::Vtu) && softParts(joint).empty())
    return Error{Fault::Unusable, {{}, {}, part, {}}, {"no volume to export"}, "export"};
  Result<Written> written = Error{};
  switch (format) {
    case ExportFormat::Msh: written = writeMsh(joint); break;
    case ExportFormat::Vtu: written = writeVtu(joint); break;
    case ExportFormat::Scn: written = writeSofa(joint); break;
    case ExportFormat::Feb: written = writeFebio(joint); break;
    case ExportFormat::Glb: written = writeGltf(joint); break;
  }
  if (!written) return written.error();
  if (const auto saved = writeWholeFile(path, written->bytes); !saved) return saved.error();
  return written->report;
}

}  // namespace glenoid
