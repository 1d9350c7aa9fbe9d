// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/ContactObject.h"

#include <cassert>

namespace glenoid {

namespace {
void addNode(MaterialPoint& point, int node, double weight) {
  if (weight == 0) return;
  int at = 0;
  while (at < point.count && point.node[at] < node) ++at;
  if (at < point.count && point.node[at] == node) {
    point.weight[at] += weight;
    return;
  }
  assert(point.count < 12);
  for (int i = point.count; i > at; --i) {
    point.node[i] = point.node[i - 1];
    point.weight[i] = point.weight[i - 1];
  }
  point.node[at] = node;
  point.weight[at] = weight;
  ++point.count;
}
}  // namespace

MaterialPoint pointAt(const VertexBinding& binding, bool rigid) {
  MaterialPoint point;
  if (rigid) {
    point.r_B = binding.r_B;
    return point;
  }
  for (int i = 0; i < 4; ++i) addNode(point, binding.node[i], binding.weight[i]);
  return point;
}

MaterialPoint pointAt(const SurfaceBinding& surface, bool rigid, std::span<const int> vertices,
                      std::span<const double> weights) {
  MaterialPoint point;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const VertexBinding& binding = surface.vertices[vertices[k]];
    if (rigid) {
      point.r_B += weights[k] * binding.r_B;
    } else {
      for (int i = 0; i < 4; ++i) addNode(point, binding.node[i], weights[k] * binding.weight[i]);
    }
  }
  return point;
}

}  // namespace glenoid
