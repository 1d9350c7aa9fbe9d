// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "app/commands/Console.h"
#include "app/commands/JointReport.h"
#include "app/commands/JsonObject.h"
#include "simcore/body/SurfaceBinding.h"
#include "simcore/collide/Penetration.h"
#include "simcore/spatial/Intersect.h"

namespace glenoid {
namespace {

using Json = JsonValue;

SurfaceCheck checkSurface(const std::string& part, const TriMesh& mesh, bool collision) {
  SurfaceCheck check{part, collision, healthOf(mesh), 0};
  if (check.health.badIndices == 0) check.selfIntersections = static_cast<int>(selfIntersections(mesh).size());
  return check;
}

std::vector<StartIntersection> intersectionsOf(const Model& model) {
  std::vector<std::vector<Vec3>> positions;
  for (const SceneObject& object : model.objects) {
    positions.emplace_back(object.collision.vertices.size());
    surfacePositions(object.collision, object.layout, model.start.q, positions.back());
  }
  const std::vector<std::span<const Vec3>> spans(positions.begin(), positions.end());
  std::vector<StartIntersection> found;
  for (const PairIntersections& cut : startIntersections(model.collisionSurfaces, model.collisionPairs, spans)) {
    const CollisionPair& pair = model.collisionPairs[cut.pair];
    found.push_back({model.objects[pair.surfaceA].id, model.objects[pair.surfaceB].id, static_cast<int>(cut.triangles.size())});
  }
  return found;
}

/// What is wrong with a surface, in words; empty when nothing is.
std::string problemsOf(const SurfaceCheck& check) {
  const MeshHealth& h = check.health;
  std::string out;
  const auto add = [&](int count, const char* what) {
    if (count > 0) out += (out.empty() ? "" : ", ") + text("%d %s", count, what);
  };
  add(h.badIndices, "triangles of vertices that do not exist");
  add(h.notFinite, "vertices that are not finite");
  add(h.openEdges, "open edges");
  add(h.nonManifoldEdges, "edges of three or more triangles");
  add(h.misorientedEdges, "edges between triangles wound against each other");
  add(h.nonManifoldVertices, "vertices where the surface meets itself");
  add(h.degenerateTriangles, "triangles without area");
  add(check.selfIntersections, "pairs of triangles that cut each other");
  if (out.empty() && h.volume <= 0) out = "wound inwards";
  return out;
}

}  // namespace

bool JointCheck::holds() const {
  return std::all_of(surfaces.begin(), surfaces.end(), [](const SurfaceCheck& s) { return s.holds(); }) &&
         intersections.empty() && flatTetrahedra == 0;
}

JointCheck checkJoint(const Model& model) {
  JointCheck check;
  for (const Part& part : model.joint.parts) {
    if (part.visual) check.surfaces.push_back(checkSurface(part.id, *part.visual, false));
    if (part.collision) check.surfaces.push_back(checkSurface(part.id, *part.collision, true));
    if (part.volume)
      for (std::size_t t = 0; t < part.volume->tets.size(); ++t)
        if (!(tetVolume(*part.volume, static_cast<int>(t)) > 0)) ++check.flatTetrahedra;
  }
  check.intersections = intersectionsOf(model);
  std::vector<int> springs(model.joint.couplings.size(), 0);
  for (const SpringView& spring : model.springs) ++springs[spring.coupling];
  check.couplings = static_cast<int>(springs.size());
  check.springsMin = springs.empty() ? 0 : *std::min_element(springs.begin(), springs.end());
  return check;
}

std::string jointCheckText(const Model& model, const JointCheck& check) {
  std::string out = text("%s: %zu parts\n", model.joint.name.c_str(), model.joint.parts.size());
  int bad = 0;
  for (const SurfaceCheck& surface : check.surfaces) {
    const std::string problems = problemsOf(surface);
    if (problems.empty()) continue;
    bad += !surface.holds();
    out += text("  %s%s, %s surface: ", surface.holds() ? "note: " : "", surface.part.c_str(), surface.collision ? "collision" : "visual") + problems + "\n";
  }
  out += text("surfaces:       %zu, %s\n", check.surfaces.size(),
              bad ? text("%d with problems", bad).c_str() : "all closed, manifold and wound outwards");
  out += text("tetrahedra:     %s\n", check.flatTetrahedra ? text("%d without positive volume", check.flatTetrahedra).c_str()
                                                            : "all with positive volume");
  out += text("couplings:      %d, at least %d springs each\n", check.couplings, check.springsMin);
  for (const StartIntersection& cut : check.intersections)
    out += text("  %s and %s cut each other at the start: %d pairs of triangles\n", cut.partA.c_str(), cut.partB.c_str(), cut.pairs);
  out += text("at the start:   %s\n", check.intersections.empty()
                                           ? "no two collision surfaces that may collide cut each other"
                                           : text("%zu pairs of parts cut each other", check.intersections.size()).c_str());
  return out + (check.holds() ? "All checks hold.\n" : "");
}

std::string jointCheckJson(const Model& model, const JointCheck& check) {
  Json surfaces = Json::array();
  for (const SurfaceCheck& s : check.surfaces) {
    const MeshHealth& h = s.health;
    surfaces.append(jsonObject({{"part", s.part}, {"surface", s.collision ? "collision" : "visual"}, {"holds", s.holds()},
                                {"triangles", h.triangles}, {"openEdges", h.openEdges}, {"nonManifoldEdges", h.nonManifoldEdges},
                                {"misorientedEdges", h.misorientedEdges}, {"nonManifoldVertices", h.nonManifoldVertices},
                                {"degenerateTriangles", h.degenerateTriangles}, {"components", h.components},
                                {"genus", h.genus}, {"volume", h.volume}, {"area", h.area},
                                {"selfIntersections", s.selfIntersections}}));
  }
  Json intersections = Json::array();
  for (const StartIntersection& cut : check.intersections)
    intersections.append(jsonObject({{"partA", cut.partA}, {"partB", cut.partB}, {"trianglePairs", cut.pairs}}));
  return toText(jsonObject({{"id", model.joint.id}, {"holds", check.holds()}, {"surfaces", surfaces},
                            {"flatTetrahedra", check.flatTetrahedra}, {"couplings", check.couplings},
                            {"springsMin", check.springsMin}, {"startIntersections", intersections}}));
}

}  // namespace glenoid
