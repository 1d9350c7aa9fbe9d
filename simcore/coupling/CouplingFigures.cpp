// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/CouplingFigures.h"

#include <algorithm>

#include "simcore/coupling/Islands.h"
#include "simcore/coupling/RegionAnchors.h"
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
  const Region& region = *findRegion(a, coupling.regionA);
  CouplingFigures figures;
  figures.springs = static_cast<int>(springs->size());
  for (const CouplingSpring& spring : *springs) figures.stiffness += spring.stiffness;
  for (const RegionAnchor& anchor : regionAnchors({&a, Vec3::Zero()}, region, &b, joint.axes_W))
    figures.anchors_W.push_back(anchor.rest_W);

  const TriMesh& mesh = region.surface == SurfaceKind::Visual ? *a.visual : *a.collision;
  const auto areaOfTriangle = [&mesh](int t) {
    const auto& c = mesh.triangles[t];
    const Vec3& x = mesh.vertices[c[0]];
    return (mesh.vertices[c[1]] - x).cross(mesh.vertices[c[2]] - x).norm() / 2;
  };
  double whole = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) whole += areaOfTriangle(static_cast<int>(t));
  const TriangleTree other(*b.visual);
  for (const int t : trianglesOf(region)) {
    const auto& c = mesh.triangles[t];
    const Vec3 centre = (mesh.vertices[c[0]] + mesh.vertices[c[1]] + mesh.vertices[c[2]]) / 3;
    const double gap = std::max(0.0, other.signedDistance(centre)), area = areaOfTriangle(t);
    figures.area += area;
    figures.meanGap += area * gap;
    figures.maxGap = std::max(figures.maxGap, gap);
  }
  figures.meanGap /= figures.area;
  figures.coverage = figures.area / whole;
  const std::vector<int> islands = islandsOfParts(joint, fixedParts);
  figures.island =
      std::max(islands[findPart(joint, coupling.partA)], islands[findPart(joint, coupling.partB)]);
  return figures;
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
