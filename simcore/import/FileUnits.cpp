// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/FileUnits.h"

#include "simcore/import/vtk/XmlScan.h"

namespace glenoid {

std::optional<double> daeUnit(std::string_view bytes) {
  XmlScan scan(bytes.substr(0, 1u << 20));
  while (const auto tag = scan.next()) {
    if (tag->name == "unit" && !tag->closing) return 1.0;
    if (tag->name == "library_geometries") break;
  }
  return std::nullopt;
}

}  // namespace glenoid
