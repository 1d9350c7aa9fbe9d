// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>

#include "simcore/fem/CorotCell.h"

namespace glenoid::test {

/// Moments of the part of a box between two corners given in its coordinates −1 … 1; `volume` of the whole box, m³.
inline BoxMoments momentsOfPart(const Vec3& low, const Vec3& high, double volume) {
  BoxMoments moments;
  for (int k = 0; k < 27; ++k) {
    const int power[3] = {k % 3, k / 3 % 3, k / 9};
    moments.value[k] = volume;
    for (int a = 0; a < 3; ++a) {
      const int p = power[a] + 1;
      moments.value[k] *= (std::pow(high[a], p) - std::pow(low[a], p)) / (2 * p);
    }
  }
  return moments;
}

/// A cantilever along X of cells of one size, held at x = 0, that holds a slab of tissue: all of X, all of Y, and from
/// `bottom` to `top` of Z, m. nx × ny × nz cells.
struct BandBeam {
  double cell = 0.008;
  int nx = 7, ny = 1, nz = 1;
  double bottom = 0, top = 0.008;
  double young = 1e6, nu = 0.3;
  bool glued = false;  ///< nothing moves at x = 0; otherwise the section may widen and curl in its plane, as in beam theory

  /// Mean deflection of the tissue's end under a force spread over it, over that of beam theory: Euler and Bernoulli with
  /// the shear of Timoshenko.
  double ratio() const;
};

}  // namespace glenoid::test
