// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/MeshReport.h"

#include <cstdlib>

#include "app/commands/Console.h"
#include "simcore/file/JsonObject.h"
#include "simcore/import/LengthUnit.h"

namespace glenoid {
namespace {

using Json = JsonValue;

std::string unitName(double metres) {
  const std::string_view word = unitWord(metres);
  return word.empty() ? text("%g m", metres) : std::string(word);
}

std::string sizeText(const SurfaceDiagnosis& d) {
  if (d.box.isEmpty()) return {};
  const Vec3 size = d.box.sizes();
  std::string out = text("%.5g × %.5g × %.5g units", size.x(), size.y(), size.z());
  if (d.unit.metres > 0) {
    const Vec3 mm = 1e3 * d.unit.metres * size;
    out += std::string(", ") + (std::string_view(d.unit.reason) == "file" ? "as the file says in " : "probably in ") + unitName(d.unit.metres) +
           text(": %.4g × %.4g × %.4g mm", mm.x(), mm.y(), mm.z());
    if (std::string_view(d.unit.reason) != "file") out += text(" (%.0f %%, by %s)", 100 * d.unit.confidence, d.unit.reason);
  }
  return out;
}

/// A length says its unit, so that it means the same in a recipe, with --unit and without: millimetres, four digits.
RepairStep inMillimetres(RepairStep step, double metres) {
  if (!isLength(step.kind) || !(step.amount > 0) || !(metres > 0)) return step;
  step.amount = std::strtod(text("%.4g", 1e3 * metres * step.amount).c_str(), nullptr);
  step.metresPerUnit = 1e-3;
  return step;
}

std::string repairsText(const Finding& finding, double metres) {
  std::string out;
  for (const RepairStep& step : finding.repairs) out += (out.empty() ? "" : ",") + toWord(inMillimetres(step, metres));
  if (out.empty()) return {};
  return text("repair: %s%s", out.c_str(), finding.harmless ? "" : " (on request)");
}

std::string surfaceText(const ImportedSurface& surface, const SurfaceDiagnosis& d, std::size_t number) {
  const double mm = 1e3 * (d.unit.metres > 0 ? d.unit.metres : 1e-3);
  std::string out = text("  surface %zu", number) + (surface.name.empty() ? std::string() : text(" “%s”", surface.name.c_str())) +
                    text(": %d vertices, %d triangles, %d shell%s (%d closed), side %s\n", d.vertices, d.triangles, d.shells,
                         d.shells == 1 ? "" : "s", d.closedShells, sideName(d.side.side));
  out += "    " + sizeText(d) + "\n";
  out += text("    area %.4g mm², volume %.4g mm³, genus %s, walls %.3g mm at least, %.3g mm in the middle\n", d.area * mm * mm,
              d.volume * mm * mm * mm, d.genus < 0 ? "-" : text("%d", d.genus).c_str(), d.thicknessLeast * mm, d.thicknessMedian * mm);
  for (const Finding& finding : d.findings) {
    if (finding.kind == FindingKind::Unit && finding.severity == FindingSeverity::Note) continue;  // said above
    std::string what = text("%ld", finding.count);
    if (finding.kind == FindingKind::Holes) what += text(" (longest %.3g mm around)", finding.measure * mm);
    if (finding.kind == FindingKind::Unit) {
      const double size = d.box.isEmpty() ? 0 : d.box.sizes().maxCoeff(), metres = size * d.unit.metres;
      if (std::string_view(d.unit.reason) == "file") what = text("the file says %s, which makes it %.3g %s long", unitName(d.unit.metres).c_str(), metres < 1 ? 1e3 * metres : metres, metres < 1 ? "mm" : "m") +
                                                            (finding.measure > 0 ? text("; in %s it would be %.3g mm", unitName(finding.measure).c_str(), 1e3 * size * finding.measure) : std::string());
      else what = "no unit fits well: give it with --unit";
    }
    if (finding.kind == FindingKind::Thin) what += text(" (%.3g mm in the middle)", finding.measure * mm);
    out += text("    %-8s %-22s %-30s ", findingSeverityName(finding.severity), findingName(finding.kind), what.c_str()) + repairsText(finding, d.unit.metres) + "\n";
  }
  return out + (d.healthy() ? "    healthy: closed, manifold, wound outwards\n" : "    not fit to be simulated as it is\n");
}

Json vectorJson(const Vec3& v) {
  Json json = Json::array();
  for (const double x : v) json.append(x);
  return json;
}

Json surfaceJson(const ImportedSurface& surface, const SurfaceDiagnosis& d) {
  Json findings = Json::array();
  for (const Finding& finding : d.findings) {
    Json repairs = Json::array();
    for (const RepairStep& step : finding.repairs) repairs.append(toWord(step));
    findings.append(jsonObject({{"kind", findingName(finding.kind)}, {"severity", findingSeverityName(finding.severity)}, {"count", finding.count},
                                {"measure", finding.measure}, {"repairs", repairs}, {"harmless", finding.harmless},
                                {"triangles", static_cast<long>(finding.triangles.size())}}));
  }
  Json automatic = Json::array();
  for (const RepairStep& step : automaticRepairs(d)) automatic.append(toWord(step));
  return jsonObject({{"name", surface.name}, {"vertices", d.vertices}, {"triangles", d.triangles}, {"low", d.box.isEmpty() ? Json() : vectorJson(d.box.min())},
                     {"high", d.box.isEmpty() ? Json() : vectorJson(d.box.max())}, {"metresPerUnit", d.unit.metres}, {"unitConfidence", d.unit.confidence},
                     {"unitReason", d.unit.reason}, {"side", sideName(d.side.side)}, {"sideReason", d.side.reason}, {"shells", d.shells},
                     {"closedShells", d.closedShells}, {"genus", d.genus < 0 ? Json() : Json(d.genus)}, {"holes", d.holes}, {"openEdges", d.openEdges},
                     {"longestHole", d.longestHole}, {"area", d.area}, {"volume", d.volume}, {"thicknessLeast", d.thicknessLeast},
                     {"thicknessMedian", d.thicknessMedian}, {"selfIntersections", d.selfIntersections}, {"healthy", d.healthy()},
                     {"findings", findings}, {"automaticRepairs", automatic}});
}

}  // namespace

std::string meshInfoText(const std::string& path, const ImportedFile& file, const std::vector<SurfaceDiagnosis>& diagnoses) {
  std::string out = path + ": " + file.format + text(", %zu surface%s", file.surfaces.size(), file.surfaces.size() == 1 ? "" : "s") +
                    text(", unit %s", file.metresPerUnit ? unitName(*file.metresPerUnit).c_str() : "not named") + "\n";
  if (file.axes != FileAxes::Unsaid)
    out += text("  axes: %s; as here (X forward, Y up, Z to the right) by --axes \"%s\"\n", fileAxesName(file.axes), axisWords(proposedAxes(file.axes)).c_str());
  for (const NoteCount& note : file.notes) out += text("  %-28s %ld\n", importNoteName(note.note), note.count);
  for (std::size_t i = 0; i < file.surfaces.size(); ++i) out += surfaceText(file.surfaces[i], diagnoses[i], i + 1);
  return out;
}

JsonValue meshInfoJson(const std::string& path, const ImportedFile& file, const std::vector<SurfaceDiagnosis>& diagnoses) {
  Json notes = Json::object(), surfaces = Json::array();
  for (const NoteCount& note : file.notes) notes.set(importNoteName(note.note), note.count);
  for (std::size_t i = 0; i < file.surfaces.size(); ++i) surfaces.append(surfaceJson(file.surfaces[i], diagnoses[i]));
  return jsonObject({{"file", path}, {"format", file.format}, {"metresPerUnit", file.metresPerUnit ? Json(*file.metresPerUnit) : Json()},
                     {"axes", fileAxesName(file.axes)}, {"proposedAxes", axisWords(proposedAxes(file.axes))}, {"notes", notes}, {"surfaces", surfaces}});
}

std::string repairText(const std::vector<RepairChange>& changes, double metresPerUnit) {
  std::string out;
  for (const RepairChange& change : changes) {
    out += text("  %-26s %6ld changed, %6ld left, %ld → %ld triangles", toWord(change.step).c_str(), change.changed, change.left,
                change.trianglesBefore, change.trianglesAfter);
    if (change.step.kind == RepairKind::Thicken)
      out += metresPerUnit > 0 ? text(", walls now %.4g mm in the middle", 1e3 * metresPerUnit * change.measure)
                               : text(", walls now %.4g in the middle", change.measure);
    out += "\n";
  }
  return out;
}

}  // namespace glenoid
