// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/CageWeights.h"

#include <algorithm>

#include "simcore/embed/MeanValue.h"
#include "simcore/mesh/MeshHealth.h"

namespace glenoid {

Result<CageWeights> cageWeights(const TriMesh& cage, std::span<const Vec3> points) {
  constexpr double kLeast = -0.05;
  if (const auto closed = requireClosed(cage); !closed) return closed.error();
  CageWeights answer;
  answer.weights.resize(static_cast<Eigen::Index>(points.size()), static_cast<Eigen::Index>(cage.vertices.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    answer.weights.row(static_cast<Eigen::Index>(i)) = meanValueCoordinates(cage, points[i]).transpose();
    answer.leastMeanValue =
        std::min(answer.leastMeanValue, answer.weights.row(static_cast<Eigen::Index>(i)).minCoeff());
  }
  if (answer.leastMeanValue >= kLeast) return answer;
  auto harmonic = harmonicCoordinates(cage, points);
  if (!harmonic) return harmonic.error();
  answer.kind = CageCoordinates::Harmonic;
  answer.weights = std::move(*harmonic);
  return answer;
}

std::vector<Vec3> followCage(const CageWeights& weights, std::span<const Vec3> points, std::span<const Vec3> rest,
                             std::span<const Vec3> moved) {
  MatX shift(static_cast<Eigen::Index>(rest.size()), 3);
  for (std::size_t j = 0; j < rest.size(); ++j)
    shift.row(static_cast<Eigen::Index>(j)) = (moved[j] - rest[j]).transpose();
  const MatX shifts = weights.weights * shift;
  std::vector<Vec3> at(points.begin(), points.end());
  for (std::size_t i = 0; i < at.size(); ++i) at[i] += shifts.row(static_cast<Eigen::Index>(i)).transpose();
  return at;
}

}  // namespace glenoid
