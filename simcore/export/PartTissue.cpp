// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/Bind.h"
#include "simcore/embed/Fill.h"
#include "simcore/export/ExportParts.h"
#include "simcore/scene/TriangleUse.h"

namespace glenoid::exporting {

PartTissue tissueOf(const Joint& joint, const Part& part, ExportMesh mesh) {
  PartTissue tissue;
  tissue.fill = mesh == ExportMesh::Conforming ? std::vector<double>(part.volume->tets.size(), 1) : fillFractions(*part.volume, *part.visual);
  for (const int use : labelTets(*part.volume, *part.visual, useOfTriangles(part)))
    tissue.material.push_back(findMaterial(joint, part.materials[use].material));
  return tissue;
}

std::vector<const Part*> softParts(const Joint& joint) {
  std::vector<const Part*> parts;
  for (const Part& part : joint.parts)
    if (part.kind == PartKind::Soft) parts.push_back(&part);
  return parts;
}

std::string xmlText(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&apos;"; break;
      default: out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
  }
  return out;
}

}  // namespace glenoid::exporting
