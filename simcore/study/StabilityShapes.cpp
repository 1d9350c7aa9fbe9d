// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/StabilityShapes.h"

#include <random>

namespace glenoid {
namespace {

constexpr double kSqueeze = 0.1;
/// Where all nodes collapse to, as shares of the box from its middle: no plane of symmetry holds it.
const Vec3 kBeside(0.05, 0.1, 0.15);

}  // namespace

void misshape(const Model& model, int object, Misshape how, unsigned seed, State& state) {
  const ObjectLayout& layout = model.objects[static_cast<std::size_t>(object)].layout;
  Box3 box;
  for (int node = 0; node < layout.nodeCount; ++node) box.extend(Vec3(state.q.segment<3>(layout.qOffset + 3 * node)));
  const Vec3 middle = box.center(), size = box.sizes();
  int axis = 0;
  size.minCoeff(&axis);
  std::mt19937 draw(seed);
  const auto share = [&draw] { return draw() / 4294967296.0; };  // [0, 1)
  for (int node = 0; node < layout.nodeCount; ++node) {
    auto x = state.q.segment<3>(layout.qOffset + 3 * node);
    const Vec3 from = Vec3(x) - middle;
    Vec3 to = from;
    switch (how) {
      case Misshape::Scattered:
        for (int i = 0; i < 3; ++i) to[i] = size[i] * (share() - 0.5);
        break;
      case Misshape::CollapsedToPlane: to[axis] = 0; break;
      case Misshape::CollapsedToPoint: to = size.cwiseProduct(kBeside); break;
      case Misshape::Mirrored: to[axis] = -from[axis]; break;
      case Misshape::InsideOut: to = -from; break;
      case Misshape::Squeezed: to[axis] = kSqueeze * from[axis]; break;
    }
    x = middle + to;
  }
}

}  // namespace glenoid
