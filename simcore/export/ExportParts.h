// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <charconv>
#include <string>
#include <vector>

#include "simcore/export/ExportJoint.h"

/// The pieces of an export; private to this folder.
namespace glenoid::exporting {

/// A file in the making, and what is lost by it.
struct Written {
  std::string bytes;
  ExportReport report;

  void lose(LossKind kind, long count = 1) {
    if (count > 0) report.losses.push_back({kind, count});
  }
  Written& operator<<(std::string_view text) {
    bytes += text;
    return *this;
  }
  Written& operator<<(long value) {
    bytes += std::to_string(value);
    return *this;
  }
  Written& operator<<(int value) { return *this << static_cast<long>(value); }
  Written& operator<<(std::size_t value) { return *this << static_cast<long>(value); }
  /// Shortest text that reads back as the same double; never in the language's own way.
  Written& operator<<(double value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    bytes.append(text, end);
    return *this;
  }
};

/// With &, <, > and quotes as entities; control characters, which XML 1.0 forbids, become '?'.
std::string xmlText(const std::string& text);

/// What each tetrahedron of a soft part is made of.
struct PartTissue {
  std::vector<int> material;   ///< in joint.materials
  std::vector<double> fill;    ///< part of it that is tissue, (0, 1]
};
PartTissue tissueOf(const Joint& joint, const Part& part, ExportMesh mesh);

/// Soft parts in the joint's order.
std::vector<const Part*> softParts(const Joint& joint);

/// Volume of a part of the joint as it was given, whose nodes couplings number; null where it has none.
const TetMesh* numberedMesh(const Joint& authored, const std::string& part);

// Of a joint whose volumes are already those that `mesh` says; `authored`: as it was given.
Result<Written> writeMsh(const Joint& joint, ExportMesh mesh);
Result<Written> writeVtu(const Joint& joint, ExportMesh mesh);
Result<Written> writeSofa(const Joint& joint, ExportMesh mesh, const Joint& authored);
Result<Written> writeFebio(const Joint& joint, ExportMesh mesh, const Joint& authored);
Result<Written> writeGltf(const Joint& joint);
/// `only`: index of the one soft part that is written, else −1. Then what it is bonded to is known but left out.
Result<Written> writeCalculix(const Joint& joint, ExportMesh mesh, int only, const Joint& authored);

}  // namespace glenoid::exporting
