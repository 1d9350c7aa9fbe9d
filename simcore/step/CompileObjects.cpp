// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/CompileObjects.h"

#include <algorithm>
#include <optional>

#include "simcore/body/PartMass.h"
#include "simcore/body/RigidObject.h"
#include "simcore/body/SoftObject.h"
#include "simcore/embed/Bind.h"
#include "simcore/embed/Fill.h"
#include "simcore/embed/WholeCells.h"
#include "simcore/scene/Start.h"
#include "simcore/scene/TriangleUse.h"
#include "simcore/tool/FingerShape.h"
#include "simcore/tool/ToolShape.h"

namespace glenoid {

namespace {

Error about(Error error, const std::string& part) {
  error.place.part = part;
  return error;
}

SurfaceBinding bindSurface(const std::shared_ptr<const TriMesh>& mesh, const TetMesh* volume, const Vec3& centre) {
  return {mesh, volume ? bindToTets(*volume, mesh->vertices) : bindToRigid(mesh->vertices, centre)};
}

Result<std::vector<ElementTissue>> tissueOf(const Joint& joint, const Part& part) {
  const std::vector<Eigen::Matrix4d> moments = enclosedMoments(*part.volume, *part.visual);
  std::vector<double> enclosed;
  for (const Eigen::Matrix4d& m : moments) enclosed.push_back(m.sum());
  const std::vector<double> fill = fillFractions(*part.volume, enclosed);
  const std::vector<int> label = labelTets(*part.volume, *part.visual, useOfTriangles(part));
  std::vector<ElementTissue> tissue;
  for (std::size_t tet = 0; tet < fill.size(); ++tet) {
    const std::string& id = part.materials[label[tet]].material;
    const int index = findMaterial(joint, id);
    if (index < 0) return Error{Fault::UnknownId, {"", "", part.id, {}}, {id, "material"}, ""};
    const Material& material = joint.materials[index];
    tissue.push_back({lameFrom(material.youngsModulus, material.poissonRatio), material.density, material.massDamping,
                      material.stiffnessDamping, fill[tet], moments[tet]});
  }
  return tissue;
}

/// Tetrahedra, or cells on a volume of whole cells.
Result<std::unique_ptr<SoftObject>> makeSoft(const Joint& joint, const Part& part, const ObjectLayout& layout, const CellMesh* cells,
                                             int rotationOffset) {
  Result<std::vector<ElementTissue>> tissue = tissueOf(joint, part);
  if (!tissue) return tissue.error();
  return cells ? SoftObject::makeOfCells(layout, part.volume, *cells, *tissue, rotationOffset)
               : SoftObject::make(layout, part.volume, *tissue, rotationOffset);
}

/// Where the nodes of whole cells start: corners that the tetrahedra lacked go on as the nearest of these does.
std::vector<Vec3> startOfCells(const TetMesh& cut, const std::vector<Vec3>& start, const CellMesh& cells) {
  if (start == cut.nodes) return cells.mesh.nodes;
  std::vector<Vec3> nodes;
  for (const VertexBinding& binding : bindToTets(cut, cells.mesh.nodes)) nodes.push_back(boundPosition(binding, start));
  return nodes;
}

/// Takes the next stretch of the state for an object.
void place(ObjectLayout& layout, int nodeCount, int& q, int& v) {
  layout.nodeCount = layout.rigid ? 0 : nodeCount;
  layout.qSize = layout.rigid ? 7 : 3 * nodeCount;
  layout.vSize = !layout.free ? 0 : layout.rigid ? 6 : 3 * nodeCount;
  layout.qOffset = q;
  layout.vOffset = v;
  q += layout.qSize;
  v += layout.vSize;
}

}  // namespace

Result<Done> compileObjects(Model& model, StepModel& inside, std::vector<Vec3>& centres) {
  Joint& joint = model.joint;
  const Scenario& scenario = model.scenario;
  int q = 0, v = 0, rotations = 0;
  std::vector<std::pair<int, Pose>> rigidStarts;
  std::vector<std::pair<int, std::vector<Vec3>>> softStarts;

  for (Part& part : joint.parts) {
    SceneObject object;
    object.id = part.id;
    object.name = part.name;
    object.number = part.number;
    object.color = part.color;
    object.layout.rigid = part.kind == PartKind::Rigid;
    object.layout.free = std::find(scenario.fixedParts.begin(), scenario.fixedParts.end(), part.id) == scenario.fixedParts.end();
    if (part.materials.empty()) return Error{Fault::Unusable, {"", "", part.id, {}}, {"material"}, "no material"};
    const int material = findMaterial(joint, part.materials[0].material);
    if (material < 0) return Error{Fault::UnknownId, {"", "", part.id, {}}, {part.materials[0].material, "material"}, ""};

    Vec3 centre = Vec3::Zero();
    if (object.layout.rigid) {
      Result<MassProperties> properties = massPropertiesOf(joint, part);
      if (!properties) return about(properties.error(), part.id);
      centre = properties->centre;
      object.mass = properties->mass;
      place(object.layout, 0, q, v);
      rigidStarts.push_back({object.layout.qOffset, {centre, Quat::Identity()}});
      inside.objects.push_back(std::make_unique<RigidObject>(object.layout, *properties, joint.materials[material].massDamping, true));
    } else {
      if (!part.volume || part.volume->tets.empty())
        return Error{Fault::Unusable, {"", "", part.id, {}}, {"volume"}, "a soft part without tetrahedra"};
      Result<std::vector<Vec3>> nodes = startNodes(joint, part);
      if (!nodes) return nodes.error();
      object.authored = part.volume;
      object.authoredTets = static_cast<int>(part.volume->tets.size());
      std::optional<CellMesh> cells;
      const bool wantsCells = scenario.elements.value_or(part.elements) == Elements::Cells && scenario.profile != Profile::Paper;
      if (wantsCells) {
        Result<CellMesh> whole = wholeCells(*part.volume, *part.visual);
        if (!whole) return about(whole.error(), part.id);
        cells = std::move(*whole);
        *nodes = startOfCells(*part.volume, *nodes, *cells);
        part.volume = std::make_shared<TetMesh>(cells->mesh);
      }
      object.cells = wantsCells;
      object.volume = part.volume;
      place(object.layout, static_cast<int>(part.volume->nodes.size()), q, v);
      softStarts.push_back({object.layout.qOffset, std::move(*nodes)});
      Result<std::unique_ptr<SoftObject>> soft = makeSoft(joint, part, object.layout, cells ? &*cells : nullptr, rotations);
      if (!soft) return about(soft.error(), part.id);
      object.elements = (*soft)->rotationCount();
      rotations += 4 * object.elements;
      object.mass = (*soft)->mass();
      inside.objects.push_back(std::move(*soft));
    }
    object.visual = bindSurface(part.visual, object.volume.get(), centre);
    object.collision = bindSurface(part.collision, object.volume.get(), centre);
    centres.push_back(centre);
    model.objects.push_back(std::move(object));
  }

  for (std::size_t index = 0; index < scenario.tools.size(); ++index) {
    const Tool& tool = scenario.tools[index];
    SceneObject object;
    object.id = tool.id;
    object.name = tool.name;
    object.tool = true;
    object.toolIndex = static_cast<int>(index);
    const bool finger = tool.kind == ToolKind::Finger;
    object.color = finger ? std::array{0.87f, 0.69f, 0.59f} : std::array{0.72f, 0.74f, 0.78f};
    const TriMesh solid = makeToolSurface(tool, kToolVisualSegments);
    const auto visual = std::make_shared<TriMesh>(finger ? makeFingerLook(tool) : solid);
    const auto collision = std::make_shared<TriMesh>(makeToolSurface(tool, kToolCollisionSegments));
    Result<MassProperties> properties = massPropertiesOf(solid, tool.mass / enclosedVolume(solid));
    if (!properties) return about(properties.error(), tool.id);
    object.mass = properties->mass;
    place(object.layout, 0, q, v);
    rigidStarts.push_back({object.layout.qOffset, {tool.home * properties->centre, tool.home.q_WB.normalized()}});
    object.visual = bindSurface(visual, nullptr, properties->centre);
    object.collision = bindSurface(collision, nullptr, properties->centre);
    inside.objects.push_back(std::make_unique<RigidObject>(object.layout, *properties, 0.0, false));
    centres.push_back(properties->centre);
    model.objects.push_back(std::move(object));
  }

  State& start = model.start;
  start.q.setZero(q);
  start.v.setZero(v);
  for (const auto& [offset, pose] : rigidStarts) setPoseAt(start.q, offset, pose);
  for (const auto& [offset, nodes] : softStarts)
    for (std::size_t i = 0; i < nodes.size(); ++i) start.q.segment<3>(offset + 3 * static_cast<int>(i)) = nodes[i];
  start.rotations.setZero(rotations);
  for (int i = 3; i < rotations; i += 4) start.rotations[i] = 1;
  start.hands.resize(7 * static_cast<int>(scenario.tools.size()));
  for (std::size_t index = 0; index < scenario.tools.size(); ++index)
    setPoseAt(start.hands, 7 * static_cast<int>(index), {scenario.tools[index].home.p_WB, scenario.tools[index].home.q_WB.normalized()});
  return Done{};
}

}  // namespace glenoid
