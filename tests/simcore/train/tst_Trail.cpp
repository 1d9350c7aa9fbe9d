// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simcore/train/DisturbedHands.h"
#include "simcore/train/Trail.h"

namespace glenoid {
namespace {

constexpr double kPi = std::numbers::pi;

template <class F>
std::vector<Vec3> sampled(double seconds, double dt, F&& at) {
  std::vector<Vec3> trail;
  for (long i = 0; i <= std::lround(seconds / dt); ++i) trail.push_back(at(static_cast<double>(i) * dt));
  return trail;
}

/// n periods of a sine: ∫ x‴² dt · T⁵ / L² = (2π)⁶ n⁴ / 32, whatever its amplitude, so whatever a filter leaves of it.
TEST(Trail, theJerkOfASineIsItsClosedForm) {
  const Vec3 way = Vec3(1, -2, 0.5).normalized();
  for (const double amplitude : {0.01, 0.1})
    for (const double hertz : {0.5, 2.0}) {
      const double n = 40;
      const auto trail = sampled(n / hertz, 0.005, [&](double t) -> Vec3 { return amplitude * std::sin(2 * kPi * hertz * t) * way; });
      EXPECT_NEAR(pathLength(trail), 4 * amplitude * n, 0.004 * 4 * amplitude * n);
      const auto jerk = logJerk(trail, 0.005);
      ASSERT_TRUE(jerk);
      EXPECT_NEAR(*jerk, std::log(std::pow(2 * kPi, 6) * std::pow(n, 4) / 32), 0.05) << amplitude << " " << hertz;
    }
}

/// The smoothest reach from rest to rest has 720 (Hogan and Sternad 2009).
TEST(Trail, theSmoothestReachHasItsPublishedValue) {
  const double seconds = 3;
  const auto trail = sampled(seconds + 0.1, 0.005, [&](double t) -> Vec3 {
    const double s = std::clamp((t - 0.05) / seconds, 0.0, 1.0);  // at rest for the reach of the filter
    return Vec3(0.2 * s * s * s * (10 - 15 * s + 6 * s * s), 0, 0);
  });
  const auto jerk = logJerk(trail, 0.005);
  ASSERT_TRUE(jerk);
  EXPECT_NEAR(std::exp(*jerk), 720, 0.1 * 720);  // the jumps of its third derivative at both ends are smoothed
}

TEST(Trail, whatDoesNotMoveOrIsTooShortHasNoJerk) {
  EXPECT_FALSE(logJerk({}, 0.005));
  EXPECT_FALSE(logJerk(std::vector<Vec3>(4, Vec3::Zero()), 0.005));
  EXPECT_FALSE(logJerk(std::vector<Vec3>(400, Vec3(1, 2, 3)), 0.005));
}

/// Half the power of 10 Hz goes through, nearly all of 1 Hz, nearly nothing of 40 Hz.
TEST(Trail, theFilterHalvesThePowerAtItsFrequency) {
  const auto share = [](double hertz) {
    const auto trail = sampled(4, 0.001, [&](double t) -> Vec3 { return Vec3(0, std::sin(2 * kPi * hertz * t), 0); });
    const auto smooth = filteredTrail(trail, 0.001);
    double before = 0, after = 0;
    for (std::size_t i = 0; i < smooth.size(); ++i) before += trail[i + (trail.size() - smooth.size()) / 2].squaredNorm(), after += smooth[i].squaredNorm();
    return after / before;
  };
  EXPECT_NEAR(share(kTrailCutOff), 0.5, 0.005);
  EXPECT_GT(share(1), 0.99);
  EXPECT_LT(share(40), 1e-4);
}

TEST(DisturbedHands, shakeByWhatWasAskedForAndTheSameForASeed) {
  Recording steady;
  steady.stateHash = "00";
  steady.tracks = {{"finger", {{0, {Vec3(0.1, 0, 0), Quat::Identity()}}, {40, {Vec3(0.1, 0, 0), Quat::Identity()}}}}};
  const Recording shaking = disturbedHands(steady, {1e-3, 0, 7});
  ASSERT_EQ(shaking.tracks.size(), 1u);
  Vec3 squares = Vec3::Zero();
  for (const HandKey& key : shaking.tracks[0].keys) squares += (key.hand.p_WB - Vec3(0.1, 0, 0)).cwiseAbs2();
  squares /= static_cast<double>(shaking.tracks[0].keys.size());
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(std::sqrt(squares[axis]), 1e-3, 0.15e-3);
  EXPECT_EQ(shaking.tracks[0].keys.back().time, 40);
  EXPECT_TRUE(shaking.stateHash.empty());
  const Recording again = disturbedHands(steady, {1e-3, 0, 7}), other = disturbedHands(steady, {1e-3, 0, 8});
  EXPECT_EQ(again.tracks[0].keys[5].hand.p_WB, shaking.tracks[0].keys[5].hand.p_WB);
  EXPECT_NE(other.tracks[0].keys[5].hand.p_WB, shaking.tracks[0].keys[5].hand.p_WB);
}

}  // namespace
}  // namespace glenoid
