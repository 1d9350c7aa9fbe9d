// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/FileUnits.h"

#include "simcore/import/Inflate.h"
#include "simcore/import/XmlScan.h"

namespace glenoid {
namespace {

/// The model that the package's root relationship names; the usual place where it does not say.
std::optional<std::string> modelOf(std::string_view zip) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  std::string name = "3D/3dmodel.model";
  if (const auto relations = zipMember(zip, "_rels/.rels", 1u << 20)) {
    XmlScan scan(*relations);
    while (const auto tag = scan.next())
      if (tag->name == "Relationship" && tag->attribute("Type").find("3dmodel") != std::string::npos) {
        name = tag->attribute("Target");
        break;
      }
  }
  if (!name.empty() && name.front() == '/') name.erase(0, 1);
  return zipMember(zip, name, kMost);
}

}  // namespace

std::optional<double> daeUnit(std::string_view bytes) {
  XmlScan scan(bytes.substr(0, 1u << 20));
  while (const auto tag = scan.next()) {
    if (tag->name == "unit" && !tag->closing) return 1.0;
    if (tag->name == "library_geometries") break;
  }
  return std::nullopt;
}

std::optional<double> threeMfUnit(std::string_view bytes) {
  const auto model = modelOf(bytes);
  if (!model) return std::nullopt;
  XmlScan scan(*model);
  while (const auto tag = scan.next()) {
    if (tag->name != "model") continue;
    const std::string unit = tag->attribute("unit", "millimeter");
    if (unit == "micron") return 1e-6;
    if (unit == "millimeter") return 1e-3;
    if (unit == "centimeter") return 1e-2;
    if (unit == "inch") return 0.0254;
    if (unit == "foot") return 0.3048;
    if (unit == "meter") return 1.0;
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace glenoid
