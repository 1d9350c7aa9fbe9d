// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <vector>

#include "simcore/collide/MovingSurface.h"

namespace glenoid {

/// Which stretches of a surface can touch each other at all: two features touch along a direction that lies in the normal
/// cone of the one and, turned round, in that of the other, so not where the normals of both look the same way, to within
/// 58° of a common axis. Told for every node of the surface's tree by a bit for each of 26 axes, so that a walk of the tree
/// against itself leaves out what is flat or bulges, which is nearly everything. Scratch of one step.
/// Source: P. Volino, N. Magnenat-Thalmann, "Efficient self-collision detection on smoothly discretized surface animations
/// using geometrical shape regularity", Computer Graphics Forum 13(3), 1994.
class SelfFacing {
 public:
  void update(const MovingSurface& surface);
  bool mayTouch(int nodeA, int nodeB) const { return (m_ofNode[nodeA] & m_ofNode[nodeB]) == 0; }

 private:
  std::vector<std::uint32_t> m_ofTriangle, m_ofVertex, m_ofNode;
};

}  // namespace glenoid
