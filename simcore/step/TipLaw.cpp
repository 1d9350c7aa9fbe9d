// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/TipLaw.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/base/PlainMath.h"

namespace glenoid {

namespace {

constexpr double kLeastContact = 0.3;  ///< share of the ball's radius

/// Under an even pressure on a disk of a half-space: mean displacement for each newton, m/N.
double halfSpace(double modulus, double radius) { return 16 / (3 * std::numbers::pi * std::numbers::pi * modulus * radius); }

/// k(a) − c(a): what the tissue gives less than a half-space, m/N; negative where it gives more.
double missing(const TipLaw& law, double a) {
  const auto at = [&](std::size_t k) { return halfSpace(law.give.modulus, law.radii[k]) - law.give.compliance[k]; };
  std::size_t k = 1;
  while (k + 1 < law.radii.size() && a > law.radii[k]) ++k;
  const double share = std::max(0.0, (a - law.radii[k - 1]) / (law.radii[k] - law.radii[k - 1]));
  const double between = (1 - share) * at(k - 1) + share * at(k);
  // Past the last radius no less may be left than a patch that is pressed evenly leaves of a thin layer.
  const double last = law.radii.back();
  return a <= last ? between : std::min(between, halfSpace(law.give.modulus, a) - law.give.compliance.back() * last * last / (a * a));
}

}  // namespace

double TipLaw::contactRadius(double force) const {
  return std::clamp(plain::cubeRoot(0.75 * std::max(force, 0.0) * radius / give.modulus), kLeastContact * radius, radius);
}

double TipLaw::depth(double force) const {
  const double a = contactRadius(force), least = kLeastContact * radius;
  const double begins = 4.0 / 3 * give.modulus * least * least * least / radius, ends = 4.0 / 3 * give.modulus * radius * radius;
  double local = a * a / radius;
  if (force < begins) local = least * least / radius * force / begins;
  if (force > ends) local += (force - ends) / (2 * radius * give.modulus);
  return local - missing(*this, a) * force;
}

double TipLaw::slope(double force) const {
  const double a = contactRadius(force), least = kLeastContact * radius;
  const double begins = 4.0 / 3 * give.modulus * least * least * least / radius;
  const double local = force < begins ? least * least / radius / begins : 1 / (2 * a * give.modulus);
  return std::max(local - missing(*this, a), 1e-3 * local);
}

double TipLaw::force(double wanted) const {
  if (!(wanted > 0)) return 0;
  const double shallow = std::min(wanted, radius);
  double f = 4.0 / 3 * give.modulus * shallow * std::sqrt(radius * shallow);
  for (int n = 0; n < 8; ++n) f = std::max(0.5 * f, f + (wanted - depth(f)) / slope(f));
  return f;
}

}  // namespace glenoid
