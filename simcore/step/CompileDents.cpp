// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of what tissue gives under a tip, made ready for a run.
#include <algorithm>

#include "simcore/base/PlainMath.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/TriangleUse.h"
#include "simcore/step/CompileObjects.h"
#include "simcore/step/StaticResponse.h"

namespace glenoid {

namespace {

bool isRound(const Tool& tool) { return tool.kind != ToolKind::Bar; }

/// Of tetrahedra five of which fill a cell.
double cellEdge(const TetMesh& mesh) {
  double volume = 0;
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) volume += tetVolume(mesh, t);
  return plain::cubeRoot(5 * volume / static_cast<double>(mesh.tets.size()));
}

/// Which use of a material each collision triangle shows: that of the visual triangle nearest to its middle.
std::vector<int> tissueOf(const Part& part) {
  const TriangleTree visual(*part.visual);
  const std::vector<int> uses = useOfTriangles(part);
  std::vector<int> tissue;
  for (const auto& c : part.collision->triangles) {
    const Vec3 middle = (part.collision->vertices[c[0]] + part.collision->vertices[c[1]] + part.collision->vertices[c[2]]) / 3;
    tissue.push_back(uses[static_cast<std::size_t>(visual.closest(middle).triangle)]);
  }
  return tissue;
}

/// The surface at each sample.
std::vector<DentField::Facing> facingsOf(const DentModel& dent, const std::vector<DentSample>& samples) {
  std::vector<DentField::Facing> facings;
  for (const DentSample& sample : samples) {
    const auto triangle = static_cast<std::size_t>(dent.surface->closest(sample.at_W).triangle);
    const auto& corners = dent.surface->mesh().triangles[triangle];
    const auto corner = [&](std::size_t k) -> const Vec3& { return dent.surface->mesh().vertices[static_cast<std::size_t>(corners[k])]; };
    facings.push_back({(corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized(), dent.tissue[triangle]});
  }
  return facings;
}

}  // namespace

std::vector<DentModel> compileDents(const Model& model) {
  std::vector<DentModel> dents(model.objects.size());
  bool any = false;
  for (std::size_t i = 0; i < model.joint.parts.size(); ++i) {  // parts come first, in the joint's order
    const Part& part = model.joint.parts[i];
    if (!part.dents || part.dents->basis != dentBasis(model.joint, part)) continue;
    dents[i].surface = std::make_shared<const TriangleTree>(*part.collision);
    dents[i].tissue = tissueOf(part);
    dents[i].field = DentField(*part.dents, facingsOf(dents[i], part.dents->samples));
    any = any || !dents[i].field.empty();
  }
  if (!any || std::none_of(model.scenario.tools.begin(), model.scenario.tools.end(), isRound)) dents.clear();
  return dents;
}

void bindDents(const Model& model, StepModel& inside) {
  if (inside.dents.empty()) return;
  for (std::size_t i = 0; i < inside.dents.size(); ++i) {
    DentModel& dent = inside.dents[i];
    if (dent.field.empty()) continue;
    const SceneObject& object = model.objects[i];
    dent.cell = cellEdge(*object.volume);
    if (!object.layout.free) continue;
    dent.own = StaticResponse::make(model, *inside.objects[i], static_cast<int>(i));
    if (!dent.own) dent.field = {};  // no rest to start from: it gives what its elements give
  }
  inside.balls.resize(model.objects.size());
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const SceneObject& object = model.objects[i];
    if (!object.tool) continue;
    inside.balls[i] = makeToolBalls(model.scenario.tools[static_cast<std::size_t>(object.toolIndex)]);
    const Vec3 centre_T = object.collision.mesh->vertices[0] - object.collision.vertices[0].r_B;
    for (ToolBall& ball : inside.balls[i]) ball.centre_T -= centre_T;
  }
}

}  // namespace glenoid
