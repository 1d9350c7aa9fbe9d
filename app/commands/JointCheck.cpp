// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "app/commands/Console.h"
#include "app/commands/JointReport.h"
#include "editor/core/ProblemSentences.h"
#include "simcore/check/FixProblem.h"
#include "simcore/file/JsonObject.h"

namespace glenoid {
namespace {

using Json = JsonValue;

const char* severityWord(Severity severity) {
  return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "note";
}

bool holds(const SurfaceFindings& surface) {
  return surface.health.healthy() && (surface.kind == SurfaceKind::Visual || surface.cuts == 0);
}

bool isOverlap(const Problem& problem) {
  return problem.kind == ProblemKind::Overlap || problem.kind == ProblemKind::Swallowed;
}

long flatTetrahedra(const CheckReport& report) {
  long flat = 0;
  for (const Problem& problem : report.problems)
    if (problem.kind == ProblemKind::FlatTetrahedra || problem.kind == ProblemKind::InvertedTetrahedra) flat += problem.count;
  return flat;
}

Json fromProblem(const Problem& problem, const Joint& joint) {
  Json json = jsonObject({{"kind", problemName(problem.kind)}, {"severity", severityWord(problem.severity)},
                          {"sentence", sentenceOf(problem, joint).toStdString()}, {"fix", fixTitleOf(problem, joint).toStdString()}});
  const auto word = [&](const char* key, const std::string& value) {
    if (!value.empty()) json.set(key, value);
  };
  word("part", problem.part);
  word("other", problem.other);
  word("coupling", problem.coupling);
  word("region", problem.region);
  word("material", problem.material);
  if (problem.surface) json.set("surface", problem.surface == SurfaceKind::Collision ? "collision" : "visual");
  if (problem.element) json.set("element", *problem.element);
  if (problem.count) json.set("count", problem.count);
  if (problem.figure != 0 && std::isfinite(problem.figure)) json.set("figure", problem.figure);
  if (problem.wanted != 0) json.set("wanted", problem.wanted);
  if (problem.rigid)
    json.set("rigid", jsonObject({{"surfacesOverlap", problem.rigid->surfacesOverlap}, {"triangles", problem.rigid->triangles},
                                  {"clearance", problem.rigid->clearance}}));
  for (const std::string& part : problem.parts) {
    Json parts = json["parts"];
    parts.append(part);
    json.set("parts", parts);
  }
  return json;
}

}  // namespace

std::string jointCheckText(const Joint& joint, const CheckReport& report) {
  std::string out = text("%s: %zu parts\n", joint.name.c_str(), joint.parts.size());
  for (const Problem& problem : report.problems) {
    out += text("  %s: %s\n", severityWord(problem.severity), sentenceOf(problem, joint).toUtf8().constData());
    if (const QString fix = fixTitleOf(problem, joint); !fix.isEmpty()) out += text("      fix: %s\n", fix.toUtf8().constData());
  }
  const long bad = std::count_if(report.surfaces.begin(), report.surfaces.end(), [](const auto& s) { return !holds(s); });
  out += text("surfaces:       %zu, %s\n", report.surfaces.size(),
              bad ? text("%ld with problems", bad).c_str() : "all closed, manifold and wound outwards");
  const long flat = flatTetrahedra(report);
  out += text("tetrahedra:     %s\n", flat ? text("%ld without positive volume", flat).c_str() : "all with positive volume");
  out += text("couplings:      %d, at least %d springs each\n", report.couplings, report.springsMin);
  const long cuts = std::count_if(report.problems.begin(), report.problems.end(), isOverlap);
  out += text("at the start:   %d pairs of parts that may collide, %s\n", report.startPairs,
              cuts ? text("%ld of them cut each other", cuts).c_str() : "no two collision surfaces cut each other");
  out += text("problems:       errors: %d, warnings: %d, notes: %d\n", report.count(Severity::Error),
              report.count(Severity::Warning), report.count(Severity::Note));
  return out + (report.holds() ? "All checks hold.\n" : "");
}

std::string jointCheckJson(const Joint& joint, const CheckReport& report) {
  Json problems = Json::array(), surfaces = Json::array(), intersections = Json::array();
  for (const Problem& problem : report.problems) {
    problems.append(fromProblem(problem, joint));
    if (isOverlap(problem))
      intersections.append(jsonObject({{"partA", problem.part}, {"partB", problem.other}, {"trianglePairs", problem.count},
                                       {"depth", problem.figure}}));
  }
  for (const SurfaceFindings& s : report.surfaces) {
    const MeshHealth& h = s.health;
    surfaces.append(jsonObject({{"part", s.part}, {"surface", s.kind == SurfaceKind::Collision ? "collision" : "visual"},
                                {"holds", holds(s)}, {"triangles", h.triangles}, {"openEdges", h.openEdges},
                                {"nonManifoldEdges", h.nonManifoldEdges}, {"misorientedEdges", h.misorientedEdges},
                                {"nonManifoldVertices", h.nonManifoldVertices}, {"degenerateTriangles", h.degenerateTriangles},
                                {"components", h.components}, {"genus", h.genus}, {"volume", h.volume}, {"area", h.area},
                                {"selfIntersections", s.cuts}}));
  }
  return toText(jsonObject({{"id", joint.id}, {"holds", report.holds()}, {"errors", report.count(Severity::Error)},
                            {"warnings", report.count(Severity::Warning)}, {"notes", report.count(Severity::Note)},
                            {"problems", problems}, {"surfaces", surfaces}, {"flatTetrahedra", flatTetrahedra(report)},
                            {"couplings", report.couplings}, {"springsMin", report.springsMin},
                            {"startPairs", report.startPairs}, {"startIntersections", intersections}}));
}

}  // namespace glenoid
