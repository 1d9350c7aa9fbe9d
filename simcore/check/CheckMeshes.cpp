// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "simcore/check/CheckParts.h"
#include "simcore/file/Vtk.h"
#include "simcore/mesh/TetTools.h"

namespace glenoid::check {
namespace {

/// Longest edge of a tetrahedron, m.
double longestEdge(const TetMesh& mesh, const std::array<int, 4>& tet) {
  double longest = 0;
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b) longest = std::max(longest, (mesh.nodes[tet[a]] - mesh.nodes[tet[b]]).norm());
  return longest;
}

bool isSound(const TetMesh& mesh) {
  const int size = static_cast<int>(mesh.nodes.size());
  for (const auto& tet : mesh.tets)
    for (const int node : tet)
      if (node < 0 || node >= size) return false;
  return !mesh.tets.empty() && std::all_of(mesh.nodes.begin(), mesh.nodes.end(), [](const Vec3& x) { return x.allFinite(); });
}

/// The default material that most parts of a kind have; empty when there is none.
std::string usualMaterial(const Joint& joint, PartKind kind) {
  std::map<std::string, int> uses;
  for (const Part& part : joint.parts)
    if (part.kind == kind && !part.materials.empty() && findMaterial(joint, part.materials[0].material) >= 0)
      ++uses[part.materials[0].material];
  const auto most = std::max_element(uses.begin(), uses.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == uses.end() ? std::string() : most->first;
}

}  // namespace

bool isSound(const std::shared_ptr<const TriMesh>& mesh) {
  if (!mesh || mesh->triangles.empty()) return false;
  const int size = static_cast<int>(mesh->vertices.size());
  for (const auto& triangle : mesh->triangles)
    for (const int vertex : triangle)
      if (vertex < 0 || vertex >= size) return false;
  return std::all_of(mesh->vertices.begin(), mesh->vertices.end(), [](const Vec3& x) { return x.allFinite(); });
}

void checkSurface(Work& work, const SurfaceFindings& findings) {
  const MeshHealth& health = findings.health;
  const auto add = [&](ProblemKind kind, Severity severity, long count) -> Problem& {
    Problem& problem = work.add(kind, severity, findings.part);
    problem.surface = findings.kind;
    problem.count = count;
    return problem;
  };
  const int tangled = health.nonManifoldEdges + health.misorientedEdges + health.nonManifoldVertices + health.degenerateTriangles;
  if (health.openEdges > 0) add(ProblemKind::SurfaceOpen, Severity::Error, health.openEdges);
  if (tangled > 0) add(ProblemKind::SurfaceTangled, Severity::Error, tangled);
  if (health.closed() && health.misorientedEdges == 0 && health.volume <= 0)
    add(ProblemKind::SurfaceInwards, Severity::Error, 0).figure = health.volume;
  // A visual surface that cuts itself is drawn wrong in one place; a collision surface that does pushes the wrong way.
  if (findings.cuts > 0)
    add(ProblemKind::SurfaceCutsItself, findings.kind == SurfaceKind::Collision ? Severity::Error : Severity::Note, findings.cuts)
        .element = findings.firstCut;
}

void checkVolume(Work& work, std::size_t index) {
  const Part& part = work.joint.parts[index];
  if (part.kind == PartKind::Rigid) return;
  work.usable[index] = 0;
  if (!part.volume || !isSound(*part.volume)) {
    work.add(ProblemKind::NoVolume, Severity::Error, part.id);
    return;
  }
  const TetMesh& mesh = *part.volume;
  struct Group {
    long count = 0, worst = -1;
    double volume = 0;
  } flat, inverted;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const double volume = tetVolume(mesh, static_cast<int>(t)), edge = longestEdge(mesh, mesh.tets[t]);
    const double least = kFlatTetrahedron * edge * edge * edge;
    if (volume > least) continue;
    Group& group = volume < -least ? inverted : flat;
    if (group.count++ == 0 || volume < group.volume) {
      group.worst = static_cast<long>(t);
      group.volume = volume;
    }
  }
  const auto report = [&](ProblemKind kind, const Group& group) {
    if (group.count == 0) return;
    Problem& problem = work.add(kind, Severity::Error, part.id);
    problem.count = group.count;
    problem.element = group.worst;
    problem.figure = group.volume;
  };
  report(ProblemKind::FlatTetrahedra, flat);
  report(ProblemKind::InvertedTetrahedra, inverted);
  work.usable[index] = work.surfaces[index] && flat.count + inverted.count == 0;
}

void checkMaterials(Work& work, const Part& part) {
  const auto report = [&](const std::string& material) {
    Problem& problem = work.add(ProblemKind::NoMaterial, Severity::Error, part.id);
    problem.material = material;
    problem.other = usualMaterial(work.joint, part.kind);
  };
  if (part.materials.empty()) return report({});
  for (const MaterialUse& use : part.materials)
    if (findMaterial(work.joint, use.material) < 0) return report(use.material);
}

}  // namespace glenoid::check
