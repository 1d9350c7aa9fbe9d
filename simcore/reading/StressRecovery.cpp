// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/StressRecovery.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace glenoid {

namespace {

constexpr double kReachInCells = 1.6;
constexpr std::size_t kEnough = 12;  ///< samples: three times what a linear field has
/// Where samples spread less than this share of the reach, a slope would be noise.
constexpr double kLeastSpread = 0.02;

struct Neighbour {
  int index;
  double weight;
};

bool alike(const Lame& a, const Lame& b) { return a.lambda == b.lambda && a.mu == b.mu; }

/// Samples of one material within reach, by volume and a bell that ends there.
std::vector<Neighbour> neighboursOf(std::span<const TissueSample> samples, const Vec3& at, double reach, const Lame& material) {
  std::vector<Neighbour> near;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double share = (samples[i].at_E - at).squaredNorm() / (reach * reach);
    if (alike(samples[i].lame, material) && share < 1) near.push_back({static_cast<int>(i), samples[i].volume * (1 - share) * (1 - share)});
  }
  return near;
}

}  // namespace

std::vector<SampleWeight> recoveryWeights(std::span<const TissueSample> samples, const Vec3& at_E, double reach) {
  if (samples.empty() || !(reach > 0)) return {};
  const auto nearest = std::min_element(samples.begin(), samples.end(), [&](const TissueSample& a, const TissueSample& b) {
    return (a.at_E - at_E).squaredNorm() < (b.at_E - at_E).squaredNorm();
  });
  const Lame material = nearest->lame;
  std::size_t all = 0;
  for (const TissueSample& sample : samples) all += alike(sample.lame, material);
  reach = std::max(reach, 1.2 * (nearest->at_E - at_E).norm());
  std::vector<Neighbour> near = neighboursOf(samples, at_E, reach, material);
  while (near.size() < std::min(kEnough, all)) near = neighboursOf(samples, at_E, reach *= 1.5, material);

  double sum = 0;
  Vec3 mean = Vec3::Zero();
  for (const Neighbour& n : near) sum += n.weight, mean += n.weight * samples[n.index].at_E;
  mean /= sum;
  Mat3 spread = Mat3::Zero();
  for (const Neighbour& n : near) {
    const Vec3 d = samples[n.index].at_E - mean;
    spread += n.weight / sum * d * d.transpose();
  }
  // The fit's value at the place: the mean and, along each principal direction of the samples, the slope times the way.
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
  Vec3 slope = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    if (const double variance = axes.eigenvalues()[k]; variance > kLeastSpread * kLeastSpread * reach * reach)
      slope += axes.eigenvectors().col(k) * (axes.eigenvectors().col(k).dot(at_E - mean) / variance);
  std::vector<SampleWeight> weights;
  for (const Neighbour& n : near) weights.push_back({n.index, n.weight / sum * (1 + slope.dot(samples[n.index].at_E - mean))});
  return weights;
}

ElementReading recovered(std::span<const SampleWeight> weights, std::span<const ElementReading> readings) {
  ElementReading sum{Mat3::Zero(), Mat3::Zero()};
  for (const SampleWeight& w : weights) {
    sum.strain_W += w.weight * readings[w.index].strain_W;
    sum.stress_W += w.weight * readings[w.index].stress_W;
  }
  return sum;
}

double recoveryReach(const TetMesh& mesh) {
  double volume = 0;
  for (const auto& tet : mesh.tets) {
    Mat3 edges;
    for (int i = 0; i < 3; ++i) edges.col(i) = mesh.nodes[tet[i + 1]] - mesh.nodes[tet[0]];
    volume += std::abs(edges.determinant()) / 6;
  }
  return mesh.tets.empty() ? 0 : kReachInCells * std::cbrt(5 * volume / static_cast<double>(mesh.tets.size()));
}

}  // namespace glenoid
