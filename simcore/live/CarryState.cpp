// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/CarryState.h"

#include <algorithm>

namespace glenoid {
namespace {

template <class T>
bool sameContent(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && *a == *b);
}

bool sameDynamics(const SceneObject& a, const SceneObject& b) {
  if (a.layout.rigid != b.layout.rigid || a.layout.qSize != b.layout.qSize) return false;
  // A rigid q is about the mass centre, which another surface would move.
  return a.layout.rigid ? sameContent(a.visual.mesh, b.visual.mesh) : sameContent(a.volume, b.volume);
}

}  // namespace

State carryState(const Model& from, const State& state, const Model& to) {
  State carried = to.start;
  carried.time = state.time;
  carried.step = state.step;
  bool sameObjects = from.objects.size() == to.objects.size();
  for (std::size_t i = 0; i < to.objects.size(); ++i) {
    const SceneObject& target = to.objects[i];
    const auto source = std::find_if(from.objects.begin(), from.objects.end(),
                                     [&](const SceneObject& object) { return object.id == target.id; });
    const bool carries = source != from.objects.end() && sameDynamics(*source, target);
    sameObjects = sameObjects && carries && source - from.objects.begin() == static_cast<std::ptrdiff_t>(i);
    if (!carries || !target.layout.free) continue;
    const ObjectLayout &a = source->layout, &b = target.layout;
    carried.q.segment(b.qOffset, b.qSize) = state.q.segment(a.qOffset, a.qSize);
    if (a.vSize == b.vSize) carried.v.segment(b.vOffset, b.vSize) = state.v.segment(a.vOffset, a.vSize);
  }
  if (sameObjects) carried.impulses = state.impulses;
  return carried;
}

}  // namespace glenoid
