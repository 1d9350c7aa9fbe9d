// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/train/DisturbedHands.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace glenoid {
namespace {

constexpr double kEvery = 0.01;  ///< s
constexpr int kSines = 6;

/// Root mean square 1 over long times.
class Sines {
 public:
  Sines(std::mt19937_64& random, double low, double high) {
    const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (Sine& sine : m_sines) sine = {2 * std::numbers::pi * (low + (high - low) * share()), 2 * std::numbers::pi * share()};
  }
  double at(double time) const {
    double sum = 0;
    for (const Sine& sine : m_sines) sum += std::sin(sine.omega * time + sine.phase);
    return sum * std::sqrt(2.0 / kSines);
  }

 private:
  struct Sine {
    double omega, phase;  ///< rad/s, rad
  };
  std::array<Sine, kSines> m_sines{};
};

}  // namespace

Recording disturbedHands(const Recording& recording, const Disturbance& disturbance) {
  Recording out = recording;
  out.jointHash = out.build = out.isa = out.stateHash = {};
  out.steps = 0;
  std::mt19937_64 random(disturbance.seed);
  for (HandTrack& track : out.tracks) {
    std::vector<Sines> tremor, wander;
    for (int axis = 0; axis < 3; ++axis) tremor.emplace_back(random, 4, 9), wander.emplace_back(random, 0.2, 0.8);
    if (track.keys.empty()) continue;
    const HandTrack steady = track;
    const double begin = steady.keys.front().time, end = steady.keys.back().time;
    track.keys.clear();
    for (long k = 0;; ++k) {
      const double time = std::min(begin + static_cast<double>(k) * kEvery, end);
      Pose hand = handAt(steady, time);
      for (int axis = 0; axis < 3; ++axis) hand.p_WB[axis] += disturbance.tremor * tremor[axis].at(time) + disturbance.wander * wander[axis].at(time);
      track.keys.push_back({time, hand});
      if (time >= end) break;
    }
  }
  return out;
}

}  // namespace glenoid
