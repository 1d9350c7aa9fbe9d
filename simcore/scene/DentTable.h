// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// A place on a part's surface at rest and what the part gives there.
struct DentSample {
  static constexpr std::size_t kRadii = 3;
  Vec3 at_W = Vec3::Zero();                  ///< m
  double modulus = 0;                        ///< E/(1 − ν²) of the tissue at the surface, Pa, > 0
  std::array<double, kRadii> compliance{};   ///< of patches of each radius under an even pressure, against the surface behind, m/N, > 0
  double depthMost = 0;                      ///< m, >= 0: a tip sinks no deeper below what the run's own elements give

  bool operator==(const DentSample&) const = default;
};

/// How far a soft part, alone and held by its couplings, is pressed together by what presses its surface: found once by fine
/// static solves (simcore/author/MakeDents) and kept with the part. A run, whose cells are coarse, adds what they lack. It holds
/// while the part is what it was computed from; afterwards it counts as absent.
struct DentTable {
  std::array<double, DentSample::kRadii> radii{};  ///< of the patches, ascending, m, > 0
  std::vector<DentSample> samples;                 ///< spread over the surface; never empty
  std::string basis;                               ///< dentBasis() of what it was computed from

  bool operator==(const DentTable&) const = default;
};

/// What the tissue at one place gives: as a DentSample, between the places of a table.
struct TissueGive {
  double modulus = 0;                                   ///< E/(1 − ν²) at the surface, Pa
  std::array<double, DentSample::kRadii> compliance{};  ///< under patches of the table's radii, m/N
  double depthMost = 0;                                 ///< m
};

/// A table made ready to be asked: the logarithms of its samples but for the depth, each interpolated by Σ b_i |x − x_i| + b_0 with Σ b_i = 0 (the
/// biharmonic spline of three dimensions), so what is even between its samples stays even; cut at the least and the most of them.
/// Places count as farther apart the less their surface faces alike, by kTurn for a right angle, and by kOther where their tissue is another: what
/// a rim gives says little about the face beside it, and a belly's little about its tendon.
/// The same on every processor. Empty: nothing may be asked.
class DentField {
 public:
  static constexpr double kTurn = 0.02, kOther = 0.05;  ///< m
  /// What a place of the surface is, beside where it lies.
  struct Facing {
    Vec3 normal_W;   ///< unit, outwards
    int tissue = 0;  ///< which use of a material
  };

  DentField() = default;
  /// `facings`: of the surface at each sample.
  DentField(const DentTable& table, std::span<const Facing> facings);
  bool empty() const { return m_places.empty(); }
  const std::array<double, DentSample::kRadii>& radii() const { return m_radii; }
  TissueGive at(const Vec3& place_W, const Facing& facing) const;  ///< at rest, m

 private:
  static constexpr std::size_t kValues = DentSample::kRadii + 2;
  using Values = std::array<double, kValues>;  ///< log modulus, log compliances, depth
  struct Place {
    Vec3 at_W;
    Facing facing;
    Values factor{};
  };
  std::vector<Place> m_places;
  Values m_even{}, m_least{}, m_most{};
  std::array<double, DentSample::kRadii> m_radii{};
};

}  // namespace glenoid
