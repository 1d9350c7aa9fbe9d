// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/CouplingFigures.h"

#include <algorithm>

#include "simcore/coupling/CouplingAnchors.h"
#include "simcore/coupling/Islands.h"
#include "simcore/scene/CouplingHold.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

std::vector<int> islandsOfParts(const Joint& joint, const std::vector<std::string>& fixedParts) {
  std::vector<bool> isFree;
  for (const Part& part : joint.parts)
    isFree.push_back(std::find(fixedParts.begin(), fixedParts.end(), part.id) == fixedParts.end());
  std::vector<std::array<int, 2>> pairs;
  for (const Coupling& coupling : joint.couplings) {
    const int a = findPart(joint, coupling.partA), b = findPart(joint, coupling.partB);
    if (a >= 0 && b >= 0) pairs.push_back({a, b});
  }
  return findCouplingIslands(isFree, pairs).islandOfObject;
}

Result<CouplingFigures> couplingFigures(const Joint& joint, int index,
                                        const std::vector<std::string>& fixedParts) {
  const Coupling& coupling = joint.couplings[index];
  std::vector<CoupledPart> parts;
  for (const Part& part : joint.parts) parts.push_back({&part, Vec3::Zero()});
  for (const std::string& id : {coupling.partA, coupling.partB}) {
    const int part = findPart(joint, id);
    if (part >= 0 && joint.parts[part].kind == PartKind::Soft &&
        (!joint.parts[part].volume || joint.parts[part].volume->tets.empty()))
      return Error{Fault::Unusable, {"", "", id, {}}, {"volume"}, "a soft part without tetrahedra"};
  }
  const auto springs = deriveSprings(joint, index, parts);
  if (!springs) return springs.error();

  const Part& a = joint.parts[findPart(joint, coupling.partA)];
  const Part& b = joint.parts[findPart(joint, coupling.partB)];
  CouplingFigures figures;
  figures.springs = static_cast<int>(springs->size());
  for (const CouplingSpring& spring : *springs) figures.stiffness += spring.stiffness;
  const auto anchors = couplingAnchors(joint, index, {&a, Vec3::Zero()}, b);
  if (!anchors) return anchors.error();
  for (const CouplingAnchor& anchor : *anchors) figures.anchors_W.push_back(anchor.rest_W);

  const HeldSurface held = heldSurface(a, coupling);
  const TriMesh& mesh = held.surface == SurfaceKind::Visual ? *a.visual : *a.collision;
  const auto areaOfTriangle = [&mesh](int t) {
    const auto& c = mesh.triangles[t];
    const Vec3& x = mesh.vertices[c[0]];
    return (mesh.vertices[c[1]] - x).cross(mesh.vertices[c[2]] - x).norm() / 2;
  };
  double whole = 0, weights = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) whole += areaOfTriangle(static_cast<int>(t));
  const TriangleTree other(*b.visual);
  const auto stands = [&](const Vec3& place, double weight) {
    const double gap = std::max(0.0, other.signedDistance(place));
    weights += weight;
    figures.meanGap += weight * gap;
    figures.maxGap = std::max(figures.maxGap, gap);
  };
  for (const int t : held.triangles) {
    const auto& c = mesh.triangles[t];
    const double area = areaOfTriangle(t);
    figures.area += area;
    if (!coupling.byNodes()) stands((mesh.vertices[c[0]] + mesh.vertices[c[1]] + mesh.vertices[c[2]]) / 3, area);
  }
  if (coupling.byNodes())
    for (const Vec3& anchor : figures.anchors_W) stands(anchor, 1);
  figures.meanGap /= weights;
  figures.coverage = figures.area / whole;
  const std::vector<int> islands = islandsOfParts(joint, fixedParts);
  figures.island =
      std::max(islands[findPart(joint, coupling.partA)], islands[findPart(joint, coupling.partB)]);
  return figures;
}

double suggestedNodeStiffness(const Joint& joint, const std::string& partA, const std::string& partB) {
  const int a = findPart(joint, partA);
  const double cell = a < 0 ? 0 : cellEdgeOf(joint.parts[a]);
  return suggestedStiffness(joint, partA, partB) * cell * cell;
}

double suggestedStiffness(const Joint& joint, const std::string& partA, const std::string& partB) {
  constexpr double kLayer = 5e-3, kTissue = 5e4;
  double young = 0, thickness = 0;
  for (const bool soft : {true, false}) {  // a bone says nothing about a bond with tissue
    for (const std::string& id : {partA, partB}) {
      const int index = findPart(joint, id);
      if (index < 0) continue;
      const Part& part = joint.parts[index];
      if ((part.kind == PartKind::Soft) != soft || part.materials.empty()) continue;
      const int material = findMaterial(joint, part.materials[0].material);
      if (material < 0) continue;
      const double modulus = joint.materials[material].youngsModulus;
      young = young > 0 ? std::min(young, modulus) : modulus;
      if (soft && part.cellSize > 0)
        thickness = thickness > 0 ? std::min(thickness, part.cellSize) : part.cellSize;
    }
    if (young > 0) break;
  }
  return (young > 0 ? young : kTissue) / (thickness > 0 ? thickness : kLayer);
}

}  // namespace glenoid
