// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/PrepareSurface.h"

#include "simcore/mesh/Simplify.h"

namespace glenoid {
namespace {

Error unclear(const std::string& what) { return {Fault::SchemaMismatch, {}, {what}, "source of a surface"}; }

Result<const ImportedSurface*> chosen(const ImportedFile& file, const std::string& name) {
  if (name.empty()) {
    if (file.surfaces.size() == 1) return &file.surfaces[0];
    std::string names;
    for (const ImportedSurface& surface : file.surfaces)
      if (names.size() < 200) names += (names.empty() ? "" : ", ") + surface.name;
    return unclear("the file holds " + std::to_string(file.surfaces.size()) + " surfaces (" + names + "); source.surface must name one");
  }
  for (const ImportedSurface& surface : file.surfaces)
    if (surface.name == name) return &surface;
  return Error{Fault::UnknownId, {}, {name, "a surface of the file"}, {}};
}

}  // namespace

Result<PreparedSurface> prepareSurface(const ImportedFile& file, const SurfaceSource& source) {
  const auto surface = chosen(file, source.surface);
  if (!surface) return surface.error();
  PreparedSurface out;
  out.format = file.format;
  out.notes = file.notes;
  out.trianglesBefore = static_cast<long>((*surface)->mesh.triangles.size());
  if (!source.metresPerUnit && !file.metresPerUnit) return unclear("the file names no unit; source.unit must");
  out.metresPerUnit = source.metresPerUnit.value_or(file.metresPerUnit.value_or(1));
  const bool anatomical = file.axes == FileAxes::Lps || file.axes == FileAxes::Ras;
  out.mesh = placed((*surface)->mesh, out.metresPerUnit, source.axes.value_or(anatomical ? proposedAxes(file.axes) : AxisMap{}),
                    source.turn_W.isIdentity(0) ? source.translate_W : Vec3(Vec3::Zero()));
  if (!source.turn_W.isIdentity(0))
    for (Vec3& p : out.mesh.vertices) p = source.turn_W * (p - source.about_W) + source.about_W + source.translate_W;
  if (source.shell >= 0) {
    std::vector<TriMesh> shells = shellsOf(out.mesh);
    if (source.shell >= static_cast<int>(shells.size()))
      return unclear("there is no shell " + std::to_string(source.shell) + " among the " + std::to_string(shells.size()) + " of the surface");
    out.mesh = std::move(shells[static_cast<std::size_t>(source.shell)]);
  }
  std::vector<RepairStep> steps = source.repairs;
  if (source.thicken > 0) steps.push_back({RepairKind::Thicken, source.thicken});
  if (!steps.empty()) {
    auto repaired = repair(out.mesh, steps, 1);
    if (!repaired) return repaired.error();
    out.mesh = std::move(repaired->mesh);
    out.changes = std::move(repaired->changes);
  }
  if (source.simplify > 0 && static_cast<long>(out.mesh.triangles.size()) > source.simplify) {
    auto simple = simplify(out.mesh, source.simplify);
    if (!simple) return simple.error();
    out.mesh = std::move(*simple);
  }
  return out;
}

}  // namespace glenoid
