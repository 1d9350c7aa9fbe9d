// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/GuessUnit.h"

#include <array>
#include <cmath>

#include "simcore/repair/NameHints.h"

namespace glenoid {
namespace {

struct Candidate {
  double metres, usual;  ///< usual: how often files come in it, relative
};
constexpr std::array<Candidate, 6> kCandidates{{{1e-3, 1}, {1e-2, 0.5}, {1, 0.5}, {0.0254, 0.15}, {1e-6, 0.1}, {0.3048, 0.03}}};
using Votes = std::array<double, kCandidates.size()>;

/// Weight of "none of these", and the least that a surface says for any unit where others vote too.
constexpr double kNone = 0.05, kLeast = 0.02;

double bell(double x, double middle, double spread) {
  const double d = std::log(x / middle) / spread;
  return std::exp(-d * d / 2);
}

/// How well an extent in metres fits what the name says; sizes of the parts of joints where it says nothing.
double fitOfSize(double metres, const SizeHint& hint) {
  if (hint.metres <= 0) return bell(metres, 0.13, 0.75);  // 10 mm to 400 mm, most about 130 mm
  if (hint.partial) return bell(metres, 0.25 * hint.metres, 0.6);
  // A scan may end within the bone; then it is shorter, never longer.
  return std::max(bell(metres, hint.metres, 0.3), 0.2 * bell(metres, 0.35 * hint.metres, 0.5));
}

struct Vote {
  Votes sizeOnly{}, fit{};
  bool named = false, placed = false;
};

Vote voteOf(const NamedBox& surface) {
  Vote vote;
  const double size = surface.box.sizes().maxCoeff(), away = surface.box.center().norm();
  const SizeHint hint = usualSize(surface.name);
  vote.named = hint.metres > 0;
  // Far from its origin a mesh stands in the frame of a whole body, whose shoulder is 1.2 m above the ground or so;
  // or in that of a scanner, which says nothing.
  vote.placed = away > 2.5 * size;
  for (std::size_t i = 0; i < kCandidates.size(); ++i) {
    vote.sizeOnly[i] = fitOfSize(size * kCandidates[i].metres, hint);
    vote.fit[i] = vote.sizeOnly[i] * (vote.placed ? 0.3 + bell(away * kCandidates[i].metres, 1.2, 0.6) : 1);
  }
  return vote;
}

std::size_t bestOf(const Votes& votes) { return static_cast<std::size_t>(std::max_element(votes.begin(), votes.end()) - votes.begin()); }

}  // namespace

UnitGuess guessUnit(std::span<const NamedBox> surfaces) {
  std::vector<Vote> votes;
  for (const NamedBox& surface : surfaces)
    if (!surface.box.isEmpty() && surface.box.sizes().maxCoeff() > 0) votes.push_back(voteOf(surface));
  if (votes.empty()) return {0, 0, "unclear"};
  // Surfaces of one file resemble each other, so n of them say no more than √n that know nothing of each other.
  const double weight = 1 / std::sqrt(static_cast<double>(votes.size())), least = votes.size() > 1 ? kLeast : 0;
  Votes fit{}, sizeOnly{};
  double none = std::log(kNone);
  bool named = false, placed = false;
  for (std::size_t i = 0; i < kCandidates.size(); ++i)
    for (const Vote& vote : votes) {
      fit[i] += weight * std::log(vote.fit[i] + least);
      sizeOnly[i] += weight * std::log(vote.sizeOnly[i] + least);
    }
  none *= weight * static_cast<double>(votes.size());
  for (const Vote& vote : votes) named = named || vote.named, placed = placed || vote.placed;
  double sum = std::exp(none);
  for (std::size_t i = 0; i < kCandidates.size(); ++i) {
    fit[i] = kCandidates[i].usual * std::exp(fit[i]);
    sizeOnly[i] = kCandidates[i].usual * std::exp(sizeOnly[i]);
    sum += fit[i];
  }
  const std::size_t best = bestOf(fit);
  UnitGuess guess{kCandidates[best].metres, fit[best] / sum, named ? "name" : "size"};
  if (placed && best != bestOf(sizeOnly)) guess.reason = "place";
  if (guess.confidence < 0.6) guess.reason = "unclear";
  return guess;
}

UnitGuess guessUnit(const Box3& box, const std::string& name) {
  const NamedBox one{box, name};
  return guessUnit(std::span<const NamedBox>(&one, 1));
}

std::vector<SurfaceDiagnosis> diagnoseFile(const ImportedFile& file, const std::string& fileName, DiagnosisOptions options) {
  std::vector<NamedBox> boxes;
  for (const ImportedSurface& surface : file.surfaces) boxes.push_back({boundsOf(surface.mesh), surface.name + " " + fileName});
  options.metresPerUnit = file.metresPerUnit;
  if (boxes.size() > 1) options.guess = guessUnit(boxes);
  std::vector<SurfaceDiagnosis> found;
  for (std::size_t i = 0; i < file.surfaces.size(); ++i) {
    options.name = boxes[i].name;
    found.push_back(diagnose(file.surfaces[i].mesh, options));
  }
  return found;
}

}  // namespace glenoid
