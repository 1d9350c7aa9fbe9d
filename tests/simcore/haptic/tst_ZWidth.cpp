// SPDX-License-Identifier: GPL-3.0-or-later
// The loop against theory: at which stiffness a wall begins to swing up, measured by playing the loop against a mass that
// nobody holds, beside the eigenvalues of one tick and the published limit.
#include <gtest/gtest.h>

#include <cmath>

#include "simcore/haptic/DeviceProfile.h"
#include "simcore/haptic/LocalProxy.h"
#include "simcore/haptic/VirtualHand.h"
#include "simcore/haptic/ZWidth.h"
#include "tests/simcore/haptic/Walls.h"

namespace glenoid {
namespace {

/// Whether a small knock on a device that is pushed into the wall by 5 N grows within 2 s.
bool swingsUp(const WallDevice& device, double K, double B) {
  VirtualHandSettings settings;
  settings.mass = device.mass;
  settings.stiffness = settings.damping = 0;
  settings.deviceDamping = device.damping;
  settings.period = device.period;
  settings.delay = device.delayTicks * device.period;
  settings.push = Vec3(0, -5, 0);
  const double rest = -5 / K;
  VirtualHand hand(settings, Vec3(0, rest * 1.02, 0));  // in the wall throughout: the swing is linear while it is small
  LocalProxy proxy;
  const LocalProblem wall = test::wall();
  double early = 0, late = 0;
  const int ticks = 2000;
  for (int k = 0; k < ticks; ++k) {
    const Vec3 force = proxy.solve(wall, {hand.position(), Quat::Identity()}, {K, B, 2, 0}, device.period, 0).force;
    hand.tick(force, Vec3::Zero(), Vec3::Zero());
    const double off = std::abs(hand.position().y() - rest);
    if (off > 1.0 * std::abs(rest)) return true;  // out of the wall: it has grown fifty-fold
    double& most = k < ticks / 2 ? early : late;
    if (k >= ticks / 4) most = std::max(most, off);
  }
  return late > early;
}

double measuredLimit(const WallDevice& device, double B) {
  double low = 1, high = 1e6;
  while (high / low > 1.005) {
    const double middle = std::sqrt(low * high);
    (swingsUp(device, middle, B) ? high : low) = middle;
  }
  return low;
}

// The delay's first ticks send nothing, which throws the device out of place by far more than a small knock, so delays start
// from rest in the comparison of eigenvalues below instead.
TEST(ZWidth, theLoopSwingsUpWhereTheEigenvaluesOfATickSay) {
  for (const double b : {0.5, 2.0})
    for (const double B : {0.0, 0.5, 3.0}) {
      const WallDevice device{0.15, b, 0.001, 0};
      const double exact = stiffestStable(device, B);
      EXPECT_NEAR(measuredLimit(device, B), exact, 0.03 * exact) << b << " " << B;
    }
}

TEST(ZWidth, aHeavyDeviceIsStableUpToTheLimitOfGilAndHulin) {
  // K < (b + B)/(T/2 + t_d), for a device so heavy that b T/m is small.
  for (const double b : {0.3, 1.0})
    for (const double B : {0.0, 1.0})
      for (const int n : {0, 1, 2, 5}) {
        const WallDevice device{5.0, b, 0.001, n};
        const double limit = (b + B) / (0.001 * (0.5 + n));
        EXPECT_NEAR(stiffestStable(device, B), limit, 0.03 * limit) << b << " " << B << " " << n;
      }
}

TEST(ZWidth, whatIsPassiveIsStable) {
  for (const double m : {0.05, 0.2})
    for (const double b : {0.5, 2.0})
      for (const double B : {0.0, 0.2, 0.45})
        for (const int n : {0, 1, 2, 5}) {
          const WallDevice device{m, b, 0.001, n};
          const double passive = stiffestPassive(device, B);
          EXPECT_LE(passive, stiffestStable(device, B) * (1 + 1e-5));
          for (const double share : {0.25, 0.5, 0.75}) EXPECT_LE(wallGrowth(device, share * passive, B), 1 + 1e-9);
        }
}

TEST(ZWidth, withoutADamperThePassiveWallIsTheBound) {
  const WallDevice device{0.1, 2, 0.001, 2};
  EXPECT_NEAR(stiffestPassive(device, 0), 2 / (0.001 * 2.5), 1e-2);
  EXPECT_EQ(stiffestPassive({0.1, 0.5, 0.001, 0}, 0.6), 0);
}

}  // namespace
}  // namespace glenoid
