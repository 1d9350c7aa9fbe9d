// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "simcore/author/Overlaps.h"
#include "simcore/check/CheckParts.h"
#include "simcore/check/StartWarnings.h"
#include "simcore/collide/Penetration.h"
#include "simcore/embed/Bind.h"
#include "simcore/embed/CageWeights.h"
#include "simcore/scene/CouplingHold.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/Start.h"
#include "simcore/spatial/TriangleTree.h"
#include "simcore/step/CompileObjects.h"

namespace glenoid::check {
namespace {

double volumeAt(const std::array<int, 4>& tet, const std::vector<Vec3>& x) {
  return (x[tet[1]] - x[tet[0]]).dot((x[tet[2]] - x[tet[0]]).cross(x[tet[3]] - x[tet[0]])) / 6;
}

/// Start nodes of a soft part, or nothing after saying why its cage cannot be used.
std::optional<std::vector<Vec3>> nodesAtStart(Work& work, const Part& part) {
  const auto nodes = startNodes(work.joint, part);
  if (nodes) return *nodes;
  Problem& problem = work.add(ProblemKind::CageUnusable, Severity::Error, part.id);
  problem.error = nodes.error();
  return {};
}

void checkCage(Work& work, const Part& part, const std::vector<Vec3>& nodes) {
  const Cage* cage = findCage(work.joint, part.id);
  if (!cage) return;
  for (Problem& problem : startWarnings(part, nodes)) work.report.problems.push_back(std::move(problem));
  const CrushedTets crushed = crushedTets(*part.volume, nodes);
  if (crushed.below == 0) return;
  Problem& problem = work.add(ProblemKind::CageCrushes, crushed.least > 0 ? Severity::Warning : Severity::Error, part.id);
  problem.count = crushed.below;
  problem.element = crushed.worst;
  problem.figure = crushed.least;
  problem.wanted = usableWay(work.joint, *cage);
}

/// Vertices of a surface that a triangle outside of the skipped ones uses.
std::vector<int> comparedVertices(const TriMesh& mesh, const std::vector<char>& skip) {
  std::vector<char> used(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (t >= skip.size() || !skip[t])
      for (const int vertex : mesh.triangles[t]) used[vertex] = 1;
  std::vector<int> vertices;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) vertices.push_back(static_cast<int>(v));
  return vertices;
}

struct Depth {
  double deepest = 0;  ///< m
  long inside = 0;     ///< vertices
};
Depth depthOf(const std::vector<Vec3>& points, const std::vector<int>& vertices, const TriangleTree& other, const Box3& box) {
  Depth depth;
  for (const int vertex : vertices) {
    if (!box.contains(points[vertex]) || !other.inside(points[vertex])) continue;
    ++depth.inside;
    depth.deepest = std::max(depth.deepest, other.closest(points[vertex]).distance);
  }
  return depth;
}

class StartComparison {
 public:
  StartComparison(Work& work, const std::vector<std::vector<Vec3>>& nodes) : m_work(work) {
    m_model.joint = soundOnly(work, m_kept);
    if (work.scenario) {
      m_model.scenario.fixedParts = work.scenario->fixedParts;
    }
    for (std::size_t i = 0; i < m_kept.size(); ++i) {
      const Part& part = m_model.joint.parts[i];
      SceneObject object;
      object.id = part.id;
      object.layout.rigid = part.kind == PartKind::Rigid;
      const auto& fixed = m_model.scenario.fixedParts;
      object.layout.free = std::find(fixed.begin(), fixed.end(), part.id) == fixed.end();
      object.collision.mesh = part.collision;
      m_model.objects.push_back(object);
      TriMesh surface = *part.collision;
      if (const auto& at = nodes[m_kept[i]]; !at.empty() && findCage(m_model.joint, part.id)) {
        const std::vector<VertexBinding> bound = bindToTets(*part.volume, surface.vertices);
        for (std::size_t v = 0; v < bound.size(); ++v) surface.vertices[v] = boundPosition(bound[v], at);
      }
      m_surfaces.push_back(std::move(surface));
    }
  }

  /// False where two parts overlap or the check was stopped.
  bool holds() {
    compileContacts(m_model);
    m_work.report.startPairs = static_cast<int>(m_model.collisionPairs.size());
    std::vector<std::span<const Vec3>> positions;
    for (const TriMesh& surface : m_surfaces) positions.push_back(surface.vertices);
    bool clear = true;
    for (const CollisionPair& pair : m_model.collisionPairs) {
      if (!m_work.goesOn()) return false;
      clear &= compare(pair, positions);
    }
    return clear;
  }

 private:
  const TriangleTree& tree(int object) {
    if (m_trees.empty()) m_trees.resize(m_surfaces.size());
    if (!m_trees[object]) m_trees[object].emplace(m_surfaces[object]);
    return *m_trees[object];
  }

  bool compare(const CollisionPair& pair, const std::vector<std::span<const Vec3>>& positions) {
    const TriMesh &a = m_surfaces[pair.surfaceA], &b = m_surfaces[pair.surfaceB];
    const Box3 boxA = boundsOf(a), boxB = boundsOf(b);
    if (!boxA.intersects(boxB)) return true;
    const auto cuts = startIntersections(m_model.collisionSurfaces, std::span(&pair, 1), positions);
    if (cuts.empty() && !(boxB.contains(boxA) || boxA.contains(boxB))) return true;
    const Depth ofA = depthOf(a.vertices, comparedVertices(a, pair.skipTriangleA), tree(pair.surfaceB), boxB);
    const Depth ofB = depthOf(b.vertices, comparedVertices(b, pair.skipTriangleB), tree(pair.surfaceA), boxA);
    const bool bInA = ofB.inside > 0 && ofA.inside == 0;
    const std::string &idA = m_model.objects[pair.surfaceA].id, &idB = m_model.objects[pair.surfaceB].id;
    if (cuts.empty()) {  // one may lie wholly inside the other without cutting it
      const TriMesh& inner = bInA ? b : a;
      const long inside = bInA ? ofB.inside : ofA.inside;
      if (inside == 0 || inside < static_cast<long>(inner.vertices.size())) return true;
    }
    Problem& problem = m_work.add(cuts.empty() ? ProblemKind::Swallowed : ProblemKind::Overlap, Severity::Error,
                                  cuts.empty() && bInA ? idB : idA);
    problem.other = cuts.empty() && bInA ? idA : idB;
    problem.figure = std::max(ofA.deepest, ofB.deepest);
    for (const int object : {pair.surfaceA, pair.surfaceB})
      if (!m_model.objects[object].layout.rigid) problem.parts.push_back(m_model.objects[object].id);
    if (!cuts.empty()) {
      problem.count = static_cast<long>(cuts[0].triangles.size());
      problem.element = cuts[0].triangles[0][0];
    }
    if (!cuts.empty() && problem.parts.empty()) problem.rigid = advice(m_model.joint.parts[pair.surfaceA], m_model.joint.parts[pair.surfaceB]);
    return false;
  }

  /// Tried once for the same surfaces: simplifying takes long.
  std::optional<RigidAdvice> advice(const Part& a, const Part& b) {
    const std::array key{a.visual, b.visual, a.collision, b.collision};
    const auto known = m_work.advice.find(key);
    const RigidAdvice found = known != m_work.advice.end() ? known->second : adviseRigid(a, b, [&] { return m_work.goesOn(); });
    if (m_work.stopped) return {};
    return m_work.adviceNow[key] = found;
  }

  Work& m_work;
  Model m_model;
  std::vector<std::size_t> m_kept;
  std::vector<TriMesh> m_surfaces;
  std::vector<std::optional<TriangleTree>> m_trees;
};

}  // namespace

Joint soundOnly(const Work& work, std::vector<std::size_t>& kept) {
  Joint sound = work.joint;
  sound.parts.clear();
  for (std::size_t i = 0; i < work.joint.parts.size(); ++i) {
    if (!work.usable[i]) continue;
    sound.parts.push_back(work.joint.parts[i]);
    kept.push_back(i);
  }
  std::erase_if(sound.couplings, [&](const Coupling& coupling) { return !hasHold(sound, coupling); });
  return sound;
}

CrushedTets crushedTets(const TetMesh& mesh, const std::vector<Vec3>& start_W, double limit) {
  CrushedTets crushed;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const double ratio = volumeAt(mesh.tets[t], start_W) / volumeAt(mesh.tets[t], mesh.nodes);
    crushed.below += ratio < limit;
    if (crushed.worst >= 0 && ratio >= crushed.least) continue;
    crushed.least = ratio;
    crushed.worst = static_cast<long>(t);
  }
  return crushed;
}

double usableWay(const Joint& joint, const Cage& cage) {
  const int index = findPart(joint, cage.part);
  if (index < 0 || !joint.parts[index].volume) return 0;
  const TetMesh& mesh = *joint.parts[index].volume;
  const auto weights = cageWeights({cage.rest_W, cage.triangles}, mesh.nodes);
  if (!weights) return 0;
  constexpr int kSteps = 64;
  for (int step = kSteps; step > 0; --step) {
    const double way = static_cast<double>(step) / kSteps;
    std::vector<Vec3> moved = cage.rest_W;
    for (std::size_t h = 0; h < moved.size(); ++h) moved[h] += way * (cage.moved_W[h] - cage.rest_W[h]);
    if (crushedTets(mesh, followCage(*weights, mesh.nodes, cage.rest_W, moved)).below == 0) return way;
  }
  return 0;
}

void checkAtStart(Work& work) {
  const Joint& joint = work.joint;
  std::vector<std::vector<Vec3>> nodes(joint.parts.size());
  bool clear = true;
  for (std::size_t i = 0; i < joint.parts.size() && work.goesOn(); ++i) {
    const Part& part = joint.parts[i];
    if (part.kind == PartKind::Rigid || !work.usable[i]) continue;
    if (auto at = nodesAtStart(work, part)) {
      nodes[i] = std::move(*at);
      checkCage(work, part, nodes[i]);
    } else {
      clear = false;
      work.usable[i] = 0;
    }
  }
  if (!work.goesOn()) return;
  clear &= StartComparison(work, nodes).holds();
  if (!work.goesOn()) return;
  if (joint.startProof && joint.startProof->of != startHash(joint)) {
    work.add(ProblemKind::ProofStale, Severity::Warning);
  } else if (!joint.startProof && clear && !joint.cages.empty()) {
    work.add(ProblemKind::ProofMissing, Severity::Note);
  }
}

}  // namespace glenoid::check
