// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid::truth {

/// A problem over a mapped quadrilateral times [0, thickness], solved by another program: CalculiX (`ccx`),
/// with quadratic bricks of 20 nodes whose faces follow the body. It shares nothing with the elements, grids
/// and stress of this project.
struct BrickProblem {
  std::function<Vec2(double, double)> map;  ///< as prism() has it
  int ns = 8, nt = 8, nz = 2;               ///< bricks; nz even where a middle is held
  double thickness = 1, young = 1, poisson = 0;
  /// Whether a node with these coordinates of the map, 0 … 1 each, is held along an axis.
  std::function<bool(double s, double t, double z, int axis)> held;
  char pressed = '+';   ///< mark of the side under pressure, 'd' (t = 1) or '+' (above)
  double pressure = 0;  ///< on it, inwards
  std::function<double(double, double)> lift = {};  ///< by how much the body stands higher over (s, t)
};

/// Whether the program is installed here.
bool hasCalculix();
/// Runs the program on NAME.inp in a folder; whether it ended well.
bool runCalculix(const std::string& folder, const std::string& name);

/// Stress (mean of the elements around) at the node at (s, t, z), 0 … 1 each; nothing where the program
/// failed. Its files stay in `folder`, which is there: NAME.inp, .dat, .frd and what it printed.
std::optional<Mat3> stressByCalculix(const BrickProblem& problem, double s, double t, double z,
                                     const std::string& folder, const std::string& name);
/// The lowest natural frequencies, 1/s, ascending, those of rigid motions of a free body too; nothing where
/// the program failed.
std::optional<std::vector<double>> frequenciesByCalculix(const BrickProblem& problem, double density,
                                                         int count, const std::string& folder,
                                                         const std::string& name);

}  // namespace glenoid::truth
