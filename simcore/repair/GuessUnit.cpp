// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cctype>
#include <cmath>

#include "simcore/repair/Diagnose.h"
#include "simcore/repair/NameHints.h"

namespace glenoid {
namespace {

struct Candidate {
  double metres, usual;  ///< usual: how often files come in it, relative
};
constexpr std::array<Candidate, 4> kCandidates{{{1e-3, 1}, {1e-2, 0.5}, {1, 0.5}, {0.0254, 0.15}}};

/// Weight of "none of these".
constexpr double kNone = 0.05;

double bell(double x, double middle, double spread) {
  const double d = std::log(x / middle) / spread;
  return std::exp(-d * d / 2);
}

}  // namespace

UnitGuess guessUnit(const Box3& box, const std::string& name) {
  if (box.isEmpty() || !(box.sizes().maxCoeff() > 0)) return {0, 0, "unclear"};
  const double size = box.sizes().maxCoeff(), away = box.center().norm();
  const double known = usualSize(name);
  // Parts of a shoulder measure 10 mm to 400 mm, most about 130 mm; with a name it is known within a third.
  const double middle = known > 0 ? known : 0.13, spread = known > 0 ? 0.3 : 0.75;
  // Far from its origin a mesh stands in the frame of a whole body, whose shoulder is 1.2 m above the ground or so;
  // or in that of a scanner, which says nothing.
  const bool placed = away > 2.5 * size;
  std::array<double, kCandidates.size()> fit{};
  double sum = kNone;
  std::size_t best = 0, bySize = 0;
  std::array<double, kCandidates.size()> sizeOnly{};
  for (std::size_t i = 0; i < kCandidates.size(); ++i) {
    const Candidate& unit = kCandidates[i];
    sizeOnly[i] = unit.usual * bell(size * unit.metres, middle, spread);
    fit[i] = sizeOnly[i] * (placed ? 0.3 + bell(away * unit.metres, 1.2, 0.6) : 1);
    sum += fit[i];
    if (fit[i] > fit[best]) best = i;
    if (sizeOnly[i] > sizeOnly[bySize]) bySize = i;
  }
  UnitGuess guess{kCandidates[best].metres, fit[best] / sum, "size"};
  if (known > 0) guess.reason = "name";
  if (placed && best != bySize) guess.reason = "place";
  if (guess.confidence < 0.6) guess.reason = "unclear";
  return guess;
}

}  // namespace glenoid
