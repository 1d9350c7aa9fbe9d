// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/Diagnose.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/repair/Cracks.h"
#include "simcore/repair/Edges.h"
#include "simcore/repair/NameHints.h"
#include "simcore/repair/Thickness.h"
#include "simcore/repair/TwoSides.h"
#include "simcore/repair/Weld.h"

namespace glenoid {
namespace {

constexpr double kCutsPerTriangle = 0.02;  ///< pairs that cut each other, of each triangle, beyond which a new surface is advised

/// Collects the findings of one surface.
class Diagnosing {
 public:
  Diagnosing(const TriMesh& mesh, const DiagnosisOptions& options) : m_mesh(mesh), m_options(options) {}

  SurfaceDiagnosis run() {
    m_out.vertices = static_cast<int>(m_mesh.vertices.size());
    m_out.triangles = static_cast<int>(m_mesh.triangles.size());
    const MeshHealth health = healthOf(m_mesh);
    if (health.badIndices > 0 || health.notFinite > 0 || health.triangles == 0) {
      add(FindingKind::CannotBeRead, FindingSeverity::Blocks, std::max(1, health.badIndices + health.notFinite));
      return std::move(m_out);
    }
    m_out.box = boundsOf(m_mesh);
    m_out.area = health.area;
    m_out.volume = health.volume;
    m_out.genus = health.genus;
    m_out.openEdges = health.openEdges;
    m_sides = sidesOf(m_mesh.triangles);
    m_shells = findShells(m_mesh, m_sides);
    if (goOn()) unitAndSide();
    if (goOn()) vertices(health);
    if (goOn()) faces(health);
    if (goOn()) edges(health);
    if (goOn()) shells();
    if (goOn()) thickness();
    if (goOn()) selfIntersections();
    std::stable_sort(m_out.findings.begin(), m_out.findings.end(), [](const Finding& a, const Finding& b) { return a.kind < b.kind; });
    return std::move(m_out);
  }

 private:
  bool goOn() {
    m_out.cancelled = m_out.cancelled || (m_options.cancelled && m_options.cancelled());
    return !m_out.cancelled;
  }

  Finding& add(FindingKind kind, FindingSeverity severity, long count) {
    m_out.findings.push_back({kind, severity, count, 0, {}, {}, false});
    return m_out.findings.back();
  }

  void mark(Finding& finding, std::vector<int> triangles) {
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    if (triangles.size() > kMostMarked) triangles.resize(kMostMarked);
    finding.triangles = std::move(triangles);
  }

  std::vector<int> trianglesOf(int shell) const {
    std::vector<int> list;
    for (int t = 0; t < m_out.triangles; ++t)
      if (m_shells.ofTriangle[t] == shell) list.push_back(t);
    return list;
  }

  void unitAndSide() {
    const SideGuess named{sideInName(m_options.name), "name"};
    if (named.side != BodySide::Unknown) m_out.side = named;
    Box3 one = m_out.box;
    if (const auto sides = findMirrorSides(m_mesh, m_shells)) {
      m_out.side = {BodySide::Both, "mirrored-pieces"};
      Finding& finding = add(FindingKind::TwoSides, FindingSeverity::Warning, 2);
      // Neither half can be said to be left or right; the lower one is offered first.
      finding.repairs = {{RepairKind::KeepSide, 0, sides->axis, false}};
      std::vector<int> upper;
      Box3 lowerBox;
      for (int t = 0; t < m_out.triangles; ++t) {
        const Shell& shell = m_shells.list[m_shells.ofTriangle[t]];
        if (shell.box.center()[sides->axis] > sides->plane) upper.push_back(t);
        else lowerBox.extend(shell.box);
      }
      mark(finding, std::move(upper));
      one = lowerBox;
    }
    const UnitGuess guess = m_options.guess ? *m_options.guess : guessUnit(one, m_options.name);
    m_out.unit = guess;
    if (m_options.metresPerUnit) {
      const double metres = *m_options.metresPerUnit, size = one.sizes().maxCoeff() * metres;
      m_out.unit = {metres, 1, "file"};
      // From a small ligament to a whole arm.
      if (size < 0.003 || size > 2) add(FindingKind::Unit, FindingSeverity::Warning, 1).measure = guess.metres;
    } else {
      add(FindingKind::Unit, guess.confidence < 0.6 ? FindingSeverity::Warning : FindingSeverity::Note, 1).measure = guess.metres;
    }
  }

  void vertices(const MeshHealth& health) {
    if (health.unusedVertices > 0) {
      Finding& finding = add(FindingKind::UnusedVertices, FindingSeverity::Note, health.unusedVertices);
      finding.repairs = {{RepairKind::DropDegenerate}};
      finding.harmless = true;
    }
    const double tolerance = 1e-6 * m_out.box.diagonal().norm();
    const std::vector<int> same = nearestRepresentatives(m_mesh, tolerance);
    long count = 0;
    std::vector<int> where;
    for (std::size_t v = 0; v < same.size(); ++v) count += same[v] != static_cast<int>(v);
    if (count == 0) return;
    std::vector<char> twin(same.size(), 0);
    for (std::size_t v = 0; v < same.size(); ++v)
      if (same[v] != static_cast<int>(v)) twin[v] = twin[same[v]] = 1;
    for (int t = 0; t < m_out.triangles; ++t)
      for (const int v : m_mesh.triangles[t])
        if (twin[v]) where.push_back(t);
    Finding& finding = add(FindingKind::DuplicateVertices, health.openEdges > 0 ? FindingSeverity::Warning : FindingSeverity::Note, count);
    finding.repairs = {{RepairKind::Weld, tolerance}};
    finding.harmless = health.openEdges > 0;  // of a closed surface the twins were meant
    mark(finding, std::move(where));
  }

  void faces(const MeshHealth& health) {
    if (health.degenerateTriangles > 0) {
      Finding& finding = add(FindingKind::DegenerateFaces, FindingSeverity::Warning, health.degenerateTriangles);
      finding.repairs = {{RepairKind::DropDegenerate}};
      finding.harmless = true;
      std::vector<int> where;
      for (int t = 0; t < m_out.triangles; ++t)
        if (isDegenerate(m_mesh, t, 1e-9 * m_out.box.diagonal().norm())) where.push_back(t);
      mark(finding, std::move(where));
    }
    std::vector<int> twins = duplicateFaces(m_mesh);
    if (!twins.empty()) {
      Finding& finding = add(FindingKind::DuplicateFaces, FindingSeverity::Warning, static_cast<long>(twins.size()));
      finding.repairs = {{RepairKind::DropDuplicates}};
      finding.harmless = true;
      mark(finding, std::move(twins));
    }
  }

  void edges(const MeshHealth& health) {
    std::vector<int> crowded, contrary, open;
    forEachEdge(m_sides, [&](std::span<const TriangleSide> edge) {
      for (const TriangleSide& side : edge) {
        if (edge.size() > 2) crowded.push_back(side.triangle);
        if (edge.size() == 2 && edge[0].forward == edge[1].forward) contrary.push_back(side.triangle);
        if (edge.size() == 1 && !m_shells.list[m_shells.ofTriangle[side.triangle]].sheet()) open.push_back(side.triangle);
      }
    });
    if (health.nonManifoldEdges > 0) {
      Finding& finding = add(FindingKind::NonManifoldEdges, FindingSeverity::Blocks, health.nonManifoldEdges);
      finding.repairs = {{RepairKind::Orient}, {RepairKind::SplitNonManifold}, {RepairKind::DropSheets, 0.02}, {RepairKind::DropSmall, 0.01}, {RepairKind::FillHoles}};
      finding.harmless = true;
      mark(finding, std::move(crowded));
    }
    if (health.nonManifoldVertices > 0) {
      Finding& finding = add(FindingKind::NonManifoldVertices, FindingSeverity::Blocks, health.nonManifoldVertices);
      finding.repairs = {{RepairKind::SplitNonManifold}};
      finding.harmless = true;
    }
    if (health.misorientedEdges > 0) {
      Finding& finding = add(FindingKind::MisorientedEdges, FindingSeverity::Blocks, health.misorientedEdges);
      finding.repairs = {{RepairKind::Orient}, {RepairKind::Outwards}};
      finding.harmless = true;
      mark(finding, std::move(contrary));
    }
    const OpenLoops loops = openLoops(m_mesh, m_sides);
    double longestLid = 0;
    for (const auto& loop : loops.loops) {
      const int shell = shellOfVertex(loop[0]);
      if (shell >= 0 && m_shells.list[shell].sheet()) continue;
      ++m_out.holes;
      const double length = lengthOf(m_mesh, loop);
      m_out.longestHole = std::max(m_out.longestHole, length);
      if (shell < 0 || !isCrack(m_mesh, loop, m_shells.list[shell].area)) longestLid = std::max(longestLid, length);
    }
    if (open.empty()) return;
    Finding& finding = add(FindingKind::Holes, FindingSeverity::Blocks, std::max(1l, m_out.holes));
    m_out.holes = finding.count;
    finding.measure = m_out.longestHole;
    finding.repairs = {{RepairKind::FillHoles}};
    // A lid over half the part would be an invention; a crack is zipped.
    finding.harmless = longestLid < 0.5 * m_out.box.diagonal().norm();
    mark(finding, std::move(open));
  }

  int shellOfVertex(int vertex) {
    if (m_shellOfVertex.empty()) {
      m_shellOfVertex.assign(m_mesh.vertices.size(), -1);
      for (int t = 0; t < m_out.triangles; ++t)
        for (const int v : m_mesh.triangles[t]) m_shellOfVertex[v] = m_shells.ofTriangle[t];
    }
    return m_shellOfVertex[vertex];
  }

  void shells() {
    const auto& list = m_shells.list;
    m_out.shells = static_cast<int>(list.size());
    double largest = 0;
    for (const Shell& shell : list) {
      m_out.closedShells += shell.closed();
      largest = std::max(largest, shell.area);
    }
    std::vector<int> small, insideOut, sheets;
    long smallCount = 0, insideOutCount = 0, sheetCount = 0;
    const std::vector<int> wanted = wantedSigns(m_mesh, m_shells);
    std::vector<char> kinds(list.size(), 0);
    for (std::size_t s = 0; s < list.size(); ++s) {
      if (list[s].area < largest) kinds[s] |= 1;
      if (wanted[s] != 0 && list[s].volume * wanted[s] < 0) kinds[s] |= 2, ++insideOutCount;
      if (list[s].sheet()) kinds[s] |= 4, ++sheetCount;
      smallCount += list[s].area < 0.01 * largest;
    }
    for (int t = 0; t < m_out.triangles; ++t) {
      const char kind = kinds[m_shells.ofTriangle[t]];
      if (kind & 1) small.push_back(t);
      if (kind & 2) insideOut.push_back(t);
      if (kind & 4) sheets.push_back(t);
    }
    if (list.size() > 1) {
      Finding& finding = add(FindingKind::Pieces, FindingSeverity::Note, m_out.shells);
      finding.repairs = {smallCount > 0 ? RepairStep{RepairKind::DropSmall, 0.01} : RepairStep{RepairKind::KeepLargest}};
      mark(finding, std::move(small));
    }
    if (insideOutCount > 0) {
      Finding& finding = add(FindingKind::InsideOut, FindingSeverity::Blocks, insideOutCount);
      finding.repairs = {{RepairKind::Outwards}};
      finding.harmless = true;
      mark(finding, std::move(insideOut));
    }
    if (sheetCount > 0) {
      Finding& finding = add(FindingKind::Sheets, FindingSeverity::Blocks, sheetCount);
      finding.repairs = {{RepairKind::Orient}, {RepairKind::Thicken, m_options.thinLimit / metres()}};
      mark(finding, std::move(sheets));
    }
    if (m_out.genus > 0) add(FindingKind::Handles, FindingSeverity::Note, m_out.genus);
  }

  double metres() const { return m_out.unit.metres > 0 ? m_out.unit.metres : 1e-3; }

  void thickness() {
    const double limit = m_options.thinLimit / metres();
    ThicknessReport report = measureThickness(m_mesh, limit);
    m_out.thicknessLeast = report.least;
    m_out.thicknessMedian = report.median;
    if (report.thinShare < 0.05) return;
    Finding& finding = add(FindingKind::Thin, report.thinShare > 0.5 ? FindingSeverity::Warning : FindingSeverity::Note, static_cast<long>(report.thin.size()));
    finding.measure = report.median;
    finding.repairs = {{RepairKind::Thicken, limit}};
    mark(finding, std::move(report.thin));
  }

  void selfIntersections() {
    if (!m_options.selfIntersections) {
      m_out.selfIntersections = -1;
      return;
    }
    const auto pairs = selfCuts(m_mesh);
    m_out.selfIntersections = static_cast<long>(pairs.size());
    if (pairs.empty()) return;
    Finding& finding = add(FindingKind::SelfIntersections, FindingSeverity::Warning, m_out.selfIntersections);
    // Where it cuts itself all over, taking out what does would leave more hole than surface.
    const bool hopeless = m_out.selfIntersections > kCutsPerTriangle * m_out.triangles;
    finding.repairs = {{hopeless ? RepairKind::Wrap : RepairKind::RemoveSelfIntersections}};
    std::vector<int> where;
    for (const auto& pair : pairs) where.insert(where.end(), pair.begin(), pair.end());
    mark(finding, std::move(where));
  }

  const TriMesh& m_mesh;
  const DiagnosisOptions& m_options;
  SurfaceDiagnosis m_out;
  std::vector<TriangleSide> m_sides;
  Shells m_shells;
  std::vector<int> m_shellOfVertex;
};

}  // namespace

const Finding* SurfaceDiagnosis::find(FindingKind kind) const {
  for (const Finding& finding : findings)
    if (finding.kind == kind) return &finding;
  return nullptr;
}

bool SurfaceDiagnosis::healthy() const {
  return std::none_of(findings.begin(), findings.end(), [](const Finding& f) { return f.severity == FindingSeverity::Blocks; });
}

SurfaceDiagnosis diagnose(const TriMesh& mesh, const DiagnosisOptions& options) { return Diagnosing(mesh, options).run(); }

std::vector<RepairStep> repairsFor(const SurfaceDiagnosis& diagnosis, const std::set<FindingKind>& chosen) {
  std::vector<RepairStep> wanted;
  for (const Finding& finding : diagnosis.findings)
    if (chosen.count(finding.kind)) wanted.insert(wanted.end(), finding.repairs.begin(), finding.repairs.end());
  const auto has = [&](RepairKind kind) {
    return std::any_of(wanted.begin(), wanted.end(), [&](const RepairStep& step) { return step.kind == kind; });
  };
  std::vector<RepairStep> ordered;
  const bool anew = has(RepairKind::Wrap);  // then nothing of how the triangles hang together matters
  const auto take = [&](RepairKind kind) {
    for (const RepairStep& step : wanted)
      if (step.kind == kind) return ordered.push_back(step);
  };
  for (const RepairKind kind : {RepairKind::KeepSide, RepairKind::Weld, RepairKind::DropDegenerate, RepairKind::DropDuplicates, RepairKind::Orient,
                                RepairKind::SplitNonManifold, RepairKind::DropSheets, RepairKind::KeepLargest, RepairKind::DropSmall, RepairKind::FillHoles})
    if (!anew || kind == RepairKind::KeepSide) take(kind);
  for (const RepairKind kind : {RepairKind::Wrap, RepairKind::KeepLargest, RepairKind::DropSmall})  // pieces through each other become one first
    if (anew) take(kind);
  if (!anew && has(RepairKind::FillHoles)) {
    ordered.push_back({RepairKind::DropDegenerate});  // a crack closes to a face without area
    ordered.push_back({RepairKind::Orient});
  }
  if (!anew) take(RepairKind::RemoveSelfIntersections);
  if (!anew && (has(RepairKind::Outwards) || has(RepairKind::Orient) || has(RepairKind::FillHoles) || has(RepairKind::SplitNonManifold)))
    ordered.push_back({RepairKind::Outwards});
  take(RepairKind::Thicken);
  return ordered;
}

std::vector<RepairStep> automaticRepairs(const SurfaceDiagnosis& diagnosis) {
  std::set<FindingKind> harmless;
  for (const Finding& finding : diagnosis.findings)
    if (finding.harmless) harmless.insert(finding.kind);
  return repairsFor(diagnosis, harmless);
}

const char* findingName(FindingKind kind) {
  switch (kind) {
    case FindingKind::Unit: return "unit";
    case FindingKind::TwoSides: return "two-sides";
    case FindingKind::Pieces: return "pieces";
    case FindingKind::UnusedVertices: return "unused-vertices";
    case FindingKind::DuplicateVertices: return "duplicate-vertices";
    case FindingKind::DegenerateFaces: return "degenerate-faces";
    case FindingKind::DuplicateFaces: return "duplicate-faces";
    case FindingKind::NonManifoldEdges: return "non-manifold-edges";
    case FindingKind::NonManifoldVertices: return "non-manifold-vertices";
    case FindingKind::MisorientedEdges: return "misoriented-edges";
    case FindingKind::InsideOut: return "inside-out";
    case FindingKind::Holes: return "holes";
    case FindingKind::Sheets: return "sheets";
    case FindingKind::Handles: return "handles";
    case FindingKind::SelfIntersections: return "self-intersections";
    case FindingKind::Thin: return "thin";
    case FindingKind::CannotBeRead: return "cannot-be-read";
  }
  return "";
}

const char* findingSeverityName(FindingSeverity severity) {
  return severity == FindingSeverity::Note ? "note" : severity == FindingSeverity::Warning ? "warning" : "blocks";
}

const char* sideName(BodySide side) {
  return side == BodySide::Left ? "left" : side == BodySide::Right ? "right" : side == BodySide::Both ? "both" : "unknown";
}

}  // namespace glenoid
