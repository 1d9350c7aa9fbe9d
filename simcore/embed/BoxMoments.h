// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "simcore/base/Math.h"

namespace glenoid {

/// A box at rest: corner i lies at origin + axes · (bits of i, lowest first, times edges).
struct CellBox {
  Vec3 origin = Vec3::Zero();    ///< m, W
  Mat3 axes = Mat3::Identity();  ///< columns: unit edges, a rotation
  Vec3 edges = Vec3::Ones();     ///< m, > 0

  /// ξ, η, ζ of a place: −1 and 1 at the faces.
  Vec3 coordinatesOf(const Vec3& x_W) const {
    return (2 * (axes.transpose() * (x_W - origin)).array() / edges.array() - 1).matrix();
  }
};

/// ∫ ξᵃ ηᵇ ζᶜ dV over the tissue in a box, m³, for a, b, c = 0, 1, 2, at a + 3 b + 9 c; ξ, η, ζ go from −1 to 1 along the
/// box's edges. They are all that an element of eight nodes asks of the shape of its tissue: its stiffness and mass are
/// integrals of polynomials of no higher degree in each coordinate.
struct BoxMoments {
  std::array<double, 27> value{};

  double volume() const { return value[0]; }  ///< m³
  BoxMoments& operator+=(const BoxMoments& o) {
    for (int k = 0; k < 27; ++k) value[k] += o.value[k];
    return *this;
  }
};

/// Of a box that is full, `volume` in m³.
BoxMoments fullBox(double volume);

/// Moments in another box with the same axes: of the same tissue, which may lie beyond that box.
BoxMoments inOtherBox(const BoxMoments& moments, const CellBox& from, const CellBox& to);

/// Mean of ξ, η, ζ over the tissue, and their variances.
Vec3 meanOf(const BoxMoments& moments);
Vec3 varianceOf(const BoxMoments& moments);

/// A place in the box and a weight, m³.
struct BoxPoint {
  std::array<double, 3> xi;
  double weight;  ///< may be negative
};

/// 27 places at −1, 0, 1 with weights that integrate exactly what the moments are of (moment fitting; Müller, Kummer,
/// Oberlack, "Highly accurate surface and volume integration on implicit domains by means of moment-fitting", Int. J.
/// Numer. Methods Eng. 96, 2013).
std::array<BoxPoint, 27> boxPoints(const BoxMoments& moments);

}  // namespace glenoid
