// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <istream>
#include <string>
#include <vector>

/// The scene of the peers as plain numbers, in the order that simcore/study/PeerProgram.h describes. SI units.
namespace bullet_peer {

using Point = std::array<double, 3>;

struct BlockNumbers {
  std::string name;
  double young = 0, poisson = 0;
  std::vector<Point> nodes;
  std::vector<double> mass;                ///< of each node
  std::vector<std::array<int, 4>> tets;
  std::vector<std::array<int, 3>> faces;   ///< outwards
  std::vector<int> fixed, moving;          ///< nodes bound to either bone
};

struct SceneNumbers {
  double dt = 0, radius = 0;
  long steps = 0;
  Point gravity{}, ridgeHalf{}, boneHalf{}, movingCentre{}, fixedCentre{};
  std::vector<BlockNumbers> blocks;
  std::vector<Point> ball, ridge;          ///< centres, the start first, then after each step
};

/// False where the text is not such a scene.
bool readScene(std::istream& in, SceneNumbers& scene);

}  // namespace bullet_peer
