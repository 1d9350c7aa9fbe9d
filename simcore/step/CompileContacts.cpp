// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>

#include "simcore/scene/CouplingHold.h"
#include "simcore/scene/TriangleUse.h"
#include "simcore/spatial/TriangleTree.h"
#include "simcore/step/CompileObjects.h"

namespace glenoid {

namespace {

constexpr double kCouplingMargin = 3e-3;  ///< m

bool isExcluded(const Joint& joint, const std::string& a, const std::string& b) {
  return std::any_of(joint.exclusions.begin(), joint.exclusions.end(), [&](const Exclusion& e) {
    return (e.partA == a && e.partB == b) || (e.partA == b && e.partB == a);
  });
}

bool perforates(const Scenario& scenario, const SceneObject& tool, const SceneObject& other) {
  if (!tool.tool || other.tool) return false;
  const auto& parts = scenario.tools[tool.toolIndex].perforates;
  return std::find(parts.begin(), parts.end(), other.id) != parts.end();
}

/// Marks the triangles of `surface` that lie within the margin of the region.
void markNear(const TriMesh& surface, const TriMesh& region, std::vector<char>& skip) {
  skip.resize(surface.triangles.size(), 0);
  const TriangleTree regionTree(region), surfaceTree(surface);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& tri = surface.triangles[t];
    const Vec3 &a = surface.vertices[tri[0]], &b = surface.vertices[tri[1]], &c = surface.vertices[tri[2]];
    for (const Vec3& sample : {a, b, c, Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a)), Vec3((a + b + c) / 3)})
      if (regionTree.closest(sample).distance < kCouplingMargin) skip[t] = 1;
  }
  // A triangle much larger than the region holds it inside, with every sample far away.
  for (const Vec3& vertex : region.vertices)
    if (const auto closest = surfaceTree.closest(vertex); closest.distance < kCouplingMargin) skip[closest.triangle] = 1;
}

/// Coulomb's coefficient at each collision vertex of a part: that of the material at the nearest visual triangle.
std::vector<double> frictionOf(const Joint& joint, const Part& part) {
  const auto coefficient = [&](int use) {
    const int material = findMaterial(joint, part.materials[use].material);
    return material >= 0 ? joint.materials[material].friction : 0.0;
  };
  std::vector<double> friction(part.collision->vertices.size(), coefficient(0));
  if (part.materials.size() < 2) return friction;
  const TriangleTree visual(*part.visual);
  const std::vector<int> use = useOfTriangles(part);
  for (std::size_t v = 0; v < friction.size(); ++v)
    friction[v] = coefficient(use[visual.closest(part.collision->vertices[v]).triangle]);
  return friction;
}

bool linked(const Scenario& scenario, const SceneObject& a, const SceneObject& b) {
  return scenario.tools[a.toolIndex].link == b.id || scenario.tools[b.toolIndex].link == a.id;
}

/// Whether the scene asks that a part may fold onto itself.
bool foldsOntoItself(const Scenario& scenario, const SceneObject& object) {
  if (scenario.effects.selfContact == Wish::Off || object.layout.rigid || !object.layout.free) return false;
  const auto& named = scenario.selfContactParts;
  if (named.empty()) return scenario.effects.selfContact == Wish::On;
  return std::find(named.begin(), named.end(), object.id) != named.end();
}

/// The element that drives each collision vertex of a soft object; −1: none that is known.
std::vector<int> elementsOfVertices(const SceneObject& object) {
  constexpr int kTetsOfCell = 5;
  std::map<std::array<int, 4>, int> tetOf;
  if (object.volume)
    for (std::size_t t = 0; t < object.volume->tets.size(); ++t) {
      std::array<int, 4> nodes = object.volume->tets[t];
      std::sort(nodes.begin(), nodes.end());
      tetOf.emplace(nodes, static_cast<int>(t));
    }
  std::vector<int> elements;
  for (const VertexBinding& vertex : object.collision.vertices) {
    std::array<int, 4> nodes = vertex.node;
    std::sort(nodes.begin(), nodes.end());
    const auto found = tetOf.find(nodes);
    elements.push_back(found == tetOf.end() ? -1 : object.cells ? found->second / kTetsOfCell : found->second);
  }
  return elements;
}

bool rough(const SceneObject& object) {
  return std::any_of(object.friction.begin(), object.friction.end(), [](double mu) { return mu > 0; });
}

}  // namespace

bool compileFriction(Model& model) {
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    SceneObject& object = model.objects[i];
    if (object.tool)
      object.friction.assign(object.collision.vertices.size(), model.scenario.tools[object.toolIndex].friction);
    else
      object.friction = frictionOf(model.joint, model.joint.parts[i]);  // parts come first, in the joint's order
  }
  return std::any_of(model.collisionPairs.begin(), model.collisionPairs.end(), [&](const CollisionPair& pair) {
    return rough(model.objects[pair.surfaceA]) && rough(model.objects[pair.surfaceB]);
  });
}

void compileContacts(Model& model) {
  const Joint& joint = model.joint;
  const int count = static_cast<int>(model.objects.size());
  for (const SceneObject& object : model.objects)
    model.collisionSurfaces.push_back(makeCollisionSurface(*object.collision.mesh, !object.layout.rigid));
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      const SceneObject &objectA = model.objects[a], &objectB = model.objects[b];
      if (!objectA.layout.free && !objectB.layout.free) continue;
      if (perforates(model.scenario, objectA, objectB) || perforates(model.scenario, objectB, objectA)) continue;
      if (objectA.tool && objectB.tool && linked(model.scenario, objectA, objectB)) continue;
      if (!objectA.tool && !objectB.tool && isExcluded(joint, objectA.id, objectB.id)) continue;
      CollisionPair pair;
      pair.surfaceA = a;
      pair.surfaceB = b;
      for (const Coupling& coupling : joint.couplings) {
        const bool forward = coupling.partA == objectA.id && coupling.partB == objectB.id;
        const bool backward = coupling.partA == objectB.id && coupling.partB == objectA.id;
        if (objectA.tool || objectB.tool || (!forward && !backward)) continue;
        const int owner = findPart(joint, coupling.partA);
        if (!coupling.byNodes() && !findRegion(joint.parts[owner], coupling.regionA)) continue;
        const TriMesh mesh = heldMesh(joint.parts[owner], heldSurface(joint.parts[owner], coupling, model.objects[owner].authored.get()));
        if (mesh.triangles.empty()) continue;
        markNear(*objectA.collision.mesh, mesh, pair.skipTriangleA);
        markNear(*objectB.collision.mesh, mesh, pair.skipTriangleB);
      }
      model.collisionPairs.push_back(std::move(pair));
    }
  }
  // After all others, so that what these are called does not depend on the effect.
  for (int object = 0; object < count; ++object) {
    if (!foldsOntoItself(model.scenario, model.objects[object])) continue;
    CollisionPair pair;
    pair.surfaceA = pair.surfaceB = object;
    pair.cellOfVertex = elementsOfVertices(model.objects[object]);
    model.collisionPairs.push_back(std::move(pair));
  }
}

}  // namespace glenoid
