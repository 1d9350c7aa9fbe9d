// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/Tissue.h"

#include <cmath>

#include "simcore/export/VtuGrid.h"
#include "simcore/step/PaperSettings.h"
#include "simcore/step/StepModel.h"

namespace glenoid {

std::vector<ElementReading> readTissue(const Model& model, const State& state, int object, std::optional<bool> stretchLaw) {
  const auto& soft = static_cast<const SoftObject&>(*model.inside->objects[object]);
  std::vector<ElementReading> elements;
  const bool law = stretchLaw.value_or(hasStretchLaw(model.scenario.profile));
  for (int e = 0; e < soft.elementCount(); ++e) elements.push_back(soft.readElement(e, state, law));
  return elements;
}

double vonMises(const Mat3& stress) {
  const Mat3 deviator = stress - stress.trace() / 3 * Mat3::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

Result<std::string> tissueVtu(const Model& model, const State& state, std::optional<bool> stretchLaw) {
  VtuGrid grid;
  grid.pointFields = {{"displacement", 3, false, {}}, {"velocity", 3, false, {}}};
  grid.cellFields = {{"part", 1, true, {}}, {"strain", 9, false, {}}, {"stress", 9, false, {}}, {"vonMises", 1, false, {}}};
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const SceneObject& object = model.objects[i];
    if (object.layout.rigid) continue;
    grid.append(*object.volume);
    for (int node = 0; node < object.layout.nodeCount; ++node) {
      grid.pointFields[0].append(Vec3(state.q.segment<3>(object.layout.qOffset + 3 * node) - object.volume->nodes[node]));
      grid.pointFields[1].append(object.layout.free ? Vec3(state.v.segment<3>(object.layout.vOffset + 3 * node)) : Vec3::Zero().eval());
    }
    for (const ElementReading& element : readTissue(model, state, static_cast<int>(i), stretchLaw)) {
      grid.cellFields[0].values.push_back(object.number);
      grid.cellFields[1].append(element.strain_W);
      grid.cellFields[2].append(element.stress_W);
      grid.cellFields[3].values.push_back(vonMises(element.stress_W));
    }
  }
  if (grid.tets.empty()) return Error{Fault::Unusable, {}, {"it has no soft part whose tissue could be written"}, ""};
  return vtuText(grid);
}

}  // namespace glenoid
