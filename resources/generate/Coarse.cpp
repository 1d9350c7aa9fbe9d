// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/Coarse.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::generate {

namespace {

constexpr int kRounds = 60;
constexpr int kSamples = 5;           ///< per edge of a coarse triangle
constexpr double kTail = 0.5;         ///< mm; what lies farther off than this counts more than squared
constexpr double kPitch = 0.6;        ///< of the way to each round's solution
constexpr double kHold = 2e-3;        ///< share of the mean weight that holds vertices where they are
constexpr double kLongestMove = 1.0;  ///< mm a round

struct Sample {
  Vec3 at;
  double weight;
};

std::vector<Sample> samplesOf(const TriMesh& fine, const Importance& importance) {
  std::vector<Sample> samples;
  for (const auto& t : fine.triangles) {
    const Vec3 &a = fine.vertices[t[0]], &b = fine.vertices[t[1]], &c = fine.vertices[t[2]];
    const Vec3 middle = (a + b + c) / 3;
    samples.push_back({middle, 0.5 * (b - a).cross(c - a).norm() * importance(middle)});
  }
  return samples;
}

/// Normal equations of: the point with these weights of three vertices moves by `distance` along `direction`.
class Equations {
 public:
  explicit Equations(int vertices)
      : m_left(MatX::Zero(3 * vertices, 3 * vertices)), m_right(VecX::Zero(3 * vertices)) {}
  void add(const std::array<int, 3>& vertices, const Vec3& weights, const Vec3& direction, double distance,
           double weight) {
    const double off = distance / kTail, w = weight * (1 + off * off);
    for (int k = 0; k < 3; ++k) {
      m_right.segment<3>(3 * vertices[k]) += w * weights[k] * distance * direction;
      for (int l = 0; l < 3; ++l)
        m_left.block<3, 3>(3 * vertices[k], 3 * vertices[l]) +=
            w * weights[k] * weights[l] * direction * direction.transpose();
    }
  }
  VecX solve() {
    m_left.diagonal().array() += kHold * m_left.diagonal().mean() + 1e-12;
    return m_left.ldlt().solve(m_right);
  }

 private:
  MatX m_left;
  VecX m_right;
};

/// One round; the answer is the sum that is made small, before the move.
double fitOnce(TriMesh& coarse, const std::vector<Sample>& samples, const Field& shape,
               const Importance& importance) {
  const TriangleTree tree(coarse);
  Equations equations(int(coarse.vertices.size()));
  double sum = 0;
  for (const Sample& s : samples) {
    const TriangleTree::Closest hit = tree.closest(s.at);
    const Vec3 way = s.at - hit.point;
    sum += s.weight * std::pow(hit.distance, 4);
    if (hit.distance < 1e-6) continue;
    equations.add(coarse.triangles[hit.triangle], hit.barycentric, way / hit.distance, hit.distance,
                  s.weight);
  }
  for (const auto& t : coarse.triangles) {
    const Vec3 &a = coarse.vertices[t[0]], &b = coarse.vertices[t[1]], &c = coarse.vertices[t[2]];
    const Vec3 cross = (b - a).cross(c - a), normal = cross.normalized();
    const double share = 0.5 * cross.norm() / ((kSamples + 1) * (kSamples + 2) / 2);
    for (int i = 0; i <= kSamples; ++i)
      for (int j = 0; i + j <= kSamples; ++j) {
        const Vec3 w(double(i) / kSamples, double(j) / kSamples, double(kSamples - i - j) / kSamples);
        const Vec3 p = w[0] * a + w[1] * b + w[2] * c;
        const double off = std::clamp(shape(p), -3.0, 3.0);
        equations.add(t, w, normal, -off, 0.3 * share * importance(p));
      }
  }
  const VecX move = equations.solve();
  for (std::size_t i = 0; i < coarse.vertices.size(); ++i) {
    Vec3 step = kPitch * move.segment<3>(3 * i);
    if (step.norm() > kLongestMove) step *= kLongestMove / step.norm();
    coarse.vertices[i] += step;
  }
  return sum;
}

bool sound(const TriMesh& mesh) {
  return healthOf(mesh).healthy() && countSelfIntersections(mesh) == 0;
}

}  // namespace

void fit(TriMesh& coarse, const TriMesh& fine, const Field& shape, const Importance& importance) {
  const std::vector<Sample> samples = samplesOf(fine, importance);
  TriMesh best = coarse;
  double least = 1e300;
  for (int round = 0; round <= kRounds; ++round) {
    TriMesh next = coarse;
    const double sum = fitOnce(next, samples, shape, importance);
    if (sum < least && sound(coarse)) least = sum, best = coarse;
    coarse = std::move(next);
  }
  coarse = std::move(best);
}

TriMesh thinned(const TriMesh& fine, int triangles, const Importance& importance) {
  SimplifyOptions options;
  options.keepVolume = false;
  for (const Vec3& p : fine.vertices) options.importance.push_back(importance(p));
  Result<TriMesh> answer = simplify(fine, triangles, options);
  if (!answer) {
    std::fprintf(stderr, "simplify: %s\n", toLogLine(answer.error()).c_str());
    std::abort();
  }
  return std::move(*answer);
}

TriMesh coarseOf(const TriMesh& fine, const Field& shape, int triangles, const Importance& importance) {
  TriMesh coarse = thinned(fine, triangles, importance);
  fit(coarse, fine, shape, importance);
  return coarse;
}

}  // namespace glenoid::generate
