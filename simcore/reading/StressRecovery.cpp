// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/StressRecovery.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

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

/// Samples by the cube of edge `reach` they lie in, so that all within reach of a place are in the 27 around it.
class SampleGrid {
 public:
  SampleGrid(std::span<const TissueSample> samples, double reach) : m_samples(samples), m_reach(reach) {
    for (std::size_t i = 0; i < samples.size(); ++i) m_cubes[cubeOf(samples[i].at_E)].push_back(static_cast<int>(i));
  }
  /// Samples around a place, ascending. Nothing where these may not be all that recoveryWeights would take: too few of the
  /// nearest one's material within reach.
  std::vector<int> around(const Vec3& at) const {
    std::vector<int> found;
    const std::array<int, 3> middle = cubeOf(at);
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (const auto cube = m_cubes.find({middle[0] + x, middle[1] + y, middle[2] + z}); cube != m_cubes.end())
            found.insert(found.end(), cube->second.begin(), cube->second.end());
    if (found.empty()) return {};
    std::sort(found.begin(), found.end());
    const auto away = [&](int i) { return (m_samples[i].at_E - at).squaredNorm(); };
    const int nearest = *std::min_element(found.begin(), found.end(), [&](int a, int b) { return away(a) < away(b); });
    const double sure = m_reach * m_reach / 1.45;  // 1.2²: so near that the reach is not grown
    std::size_t enough = 0;
    for (const int i : found) enough += alike(m_samples[i].lame, m_samples[nearest].lame) && away(i) < m_reach * m_reach;
    return away(nearest) < sure && enough >= kEnough ? found : std::vector<int>();
  }

 private:
  std::array<int, 3> cubeOf(const Vec3& at) const {
    return {static_cast<int>(std::floor(at.x() / m_reach)), static_cast<int>(std::floor(at.y() / m_reach)), static_cast<int>(std::floor(at.z() / m_reach))};
  }
  std::span<const TissueSample> m_samples;
  double m_reach;
  std::map<std::array<int, 3>, std::vector<int>> m_cubes;
};

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

RecoveryTable recoveryTable(std::span<const TissueSample> samples, std::span<const Vec3> places_E, double reach) {
  RecoveryTable table;
  if (samples.empty() || !(reach > 0)) return table;
  const SampleGrid grid(samples, reach);
  table.first.push_back(0);
  std::vector<TissueSample> near;
  for (const Vec3& place : places_E) {
    const std::vector<int> around = grid.around(place);
    near.clear();
    for (const int i : around) near.push_back(samples[i]);
    for (const SampleWeight& w : recoveryWeights(around.empty() ? samples : std::span<const TissueSample>(near), place, reach)) {
      table.index.push_back(around.empty() ? w.index : around[w.index]);
      table.weight.push_back(static_cast<float>(w.weight));
    }
    table.first.push_back(static_cast<int>(table.index.size()));
  }
  return table;
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
