// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/StaticResponse.h"

namespace glenoid {

namespace {

constexpr double kLongStep = 100;  ///< s: mass is then a millionth of what a hold of 1 N/m is

/// This object's end of a spring, or null.
const VertexBinding* endOf(const SpringView& spring, int object) {
  if (spring.objectA == spring.objectB) return nullptr;
  return spring.objectA == object ? &spring.a : spring.objectB == object ? &spring.b : nullptr;
}

/// The object at rest, whatever its start: no force in it.
State restOf(const Model& model, int index) {
  State state = model.start;
  state.v.setZero();
  const SceneObject& object = model.objects[static_cast<std::size_t>(index)];
  for (std::size_t n = 0; n < object.volume->nodes.size(); ++n)
    state.q.segment<3>(object.layout.qOffset + 3 * static_cast<int>(n)) = object.volume->nodes[n];
  return state;
}

}  // namespace

std::shared_ptr<const StaticResponse> StaticResponse::make(const Model& model, const ContactObject& object, int index) {
  std::vector<std::array<int, 2>> pairs;
  object.appendBlockPairs(0, pairs);
  bool held = false;
  for (const SpringView& spring : model.springs) {
    const VertexBinding* end = endOf(spring, index);
    if (!end) continue;
    held = true;
    for (const int a : end->node)
      for (const int b : end->node) pairs.push_back({std::max(a, b), std::min(a, b)});
  }
  if (!held) return nullptr;
  const auto symbolic = std::make_shared<const BlockSymbolic>(object.blockCount(), pairs);
  BlockMatrix K(symbolic);
  StepSettings settings;
  settings.dt = kLongStep;
  settings.damping = false;
  settings.portable = true;
  State rest = restOf(model, index);
  VecX forces = VecX::Zero(object.layout().vSize);
  const std::vector<BlockEntry> entries = object.blockEntries(*symbolic, 0);
  object.assemble(settings, rest, entries, rest.rotations, K, forces);
  const double square = kLongStep * kLongStep;
  for (const SpringView& spring : model.springs)
    if (const VertexBinding* end = endOf(spring, index))
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
          const double both = i != j && end->node[i] == end->node[j] ? 2 : 1;  // an off-diagonal block stands for two
          if (const double k = both * square * spring.stiffness * end->weight[i] * end->weight[j]; k != 0)
            K.add(symbolic->entry(end->node[i], end->node[j]), k * Mat3::Identity());
        }
  for (double& value : K.values()) value /= square;
  std::shared_ptr<StaticResponse> response(new StaticResponse(symbolic));
  if (!response->m_factor.factor(K)) return nullptr;
  return response;
}

void StaticResponse::add(std::span<const SparseRow> rows, std::span<const int> rowIds, RowPanels& scratch, Eigen::Ref<MatX> W) const {
  m_factor.halfSolve(rows, scratch);
  m_factor.addDelassus(scratch, rowIds, W);
}

}  // namespace glenoid
