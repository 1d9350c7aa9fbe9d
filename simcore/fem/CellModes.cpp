// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/fem/CellModes.h"

#include "simcore/fem/CellShape.h"

namespace glenoid {

Mat3 strainAt(const CellModes& modes, const Vec3& xi, const Mat38& u_E) {
  const std::array<double, 3> at{xi.x(), xi.y(), xi.z()};
  const Eigen::Matrix<double, 24, 1> u = u_E.reshaped();
  const Eigen::Matrix<double, 6, 1> e = strainsOf(shapeGradients(at, modes.corners_E)) * u +
                                        (modeStrains(at, modes.inMiddle_E) - modes.mean) * (modes.response * u);
  Mat3 strain;
  strain << e[0], 0.5 * e[3], 0.5 * e[5], 0.5 * e[3], e[1], 0.5 * e[4], 0.5 * e[5], 0.5 * e[4], e[2];
  return strain;
}

}  // namespace glenoid
