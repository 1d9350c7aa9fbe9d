// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "simcore/haptic/DeviceProfile.h"
#include "tests/simcore/haptic/Walls.h"

namespace glenoid {
namespace {

using test::T;

TEST(PassivityBound, withoutDelayIsThatOfColgate) {
  for (const double K : {100.0, 1000.0, 5000.0})
    for (const double B : {0.0, 0.3, 2.0}) EXPECT_NEAR(dampingNeeded(K, B, T, 0), K * T / 2 + B, 1e-9 * K);
}

/// The published condition as it stands: b > T/2 / (1 − cos ωT) · Re{(1 − e^{−jωT}) H(e^{jωT})}, H = z⁻ⁿ (K + B (z − 1)/(T z)).
double conditionAt(double K, double B, double n, double omega) {
  using C = std::complex<double>;
  const C z = std::polar(1.0, omega * T);
  const C H = std::polar(1.0, -n * omega * T) * (K + B * (z - 1.0) / (T * z));
  return T / 2 / (1 - std::cos(omega * T)) * ((1.0 - 1.0 / z) * H).real();
}

TEST(PassivityBound, withDelayIsTheLeastUpperBoundOfThePublishedConditionOverAllFrequencies) {
  for (const double K : {100.0, 1000.0})
    for (const double B : {0.0, 0.5, 2.0})
      for (const double n : {0.0, 0.5, 1.0, 2.0, 5.0}) {
        double most = -1e300;
        for (int i = 1; i < 40000; ++i) most = std::max(most, conditionAt(K, B, n, std::numbers::pi / T * i / 40000.0));
        EXPECT_NEAR(dampingNeeded(K, B, T, n * T), most, 1e-3 * (K * T * (n + 0.5) + B)) << K << " " << B << " " << n;
        EXPECT_LE(dampingNeeded(K, B, T, n * T), dampingEnough(K, B, T, n * T) * (1 + 1e-12));
      }
}

TEST(CouplingGains, areNearTheBoundAndPassiveAtEveryDelay) {
  DeviceProfile device = unknownDevice();
  for (const double b : {0.1, 2.0})
    for (const double added : {0.0, 0.001, 0.002, 0.005}) {
      device.damping = b;
      device.delay = 0.0003;
      const CouplingGains gains = gainsFor(device, 1e9, 1 / T, added);
      EXPECT_NEAR(gains.bound, b / (T / 2 + 0.0003 + added), 1e-9 * gains.bound);
      EXPECT_GE(gains.stiffness, 0.8 * gains.bound);
      EXPECT_LE(dampingNeeded(gains.stiffness, gains.damping, T, 0.0003 + added), b * (1 + 1e-12));
      EXPECT_EQ(gains.limit, GainLimit::Damping);
    }
}

TEST(CouplingGains, areNoStifferThanWishedAndSayWhetherTheyAre) {
  const DeviceProfile device = unknownDevice();
  const CouplingGains soft = gainsFor(device, 50, 1000);
  EXPECT_EQ(soft.stiffness, 50);
  EXPECT_EQ(soft.limit, GainLimit::Wish);
  EXPECT_EQ(gainsFor(device, 181, 1000).limit, GainLimit::Damping);
}

TEST(CouplingGains, stepsOfAnEncoderLimitThemWhereFrictionIsKnown) {
  DeviceProfile device = unknownDevice();
  device.damping = 2;
  device.friction = 0.05;
  device.resolution = 1e-4;  // Abbott and Okamura: K ≤ 2 f_c/Δ = 1000 N/m
  const CouplingGains gains = gainsFor(device, 1e9, 1000);
  EXPECT_DOUBLE_EQ(gains.stiffness, 1000);
  EXPECT_DOUBLE_EQ(gains.bound, 1000);
  EXPECT_EQ(gains.limit, GainLimit::Resolution);
}

TEST(DeviceProfiles, whatShipsIsReadAndHoldsTheUnknownOne) {
  const auto devices = readDeviceProfiles(GLENOID_SOURCE_DIR "/resources/devices/devices.json");
  ASSERT_TRUE(devices) << toLogLine(devices.error());
  const DeviceProfile assumed = unknownDevice();
  bool found = false;
  for (const DeviceProfile& device : *devices) {
    EXPECT_GT(device.source.size(), 20u) << device.id;
    if (device.id != "unknown") continue;
    found = true;
    EXPECT_EQ(device.damping, assumed.damping);
    EXPECT_EQ(device.forceMax, assumed.forceMax);
    EXPECT_EQ(device.slewMax, assumed.slewMax);
  }
  EXPECT_TRUE(found);
}

Result<std::vector<DeviceProfile>> readText(const std::string& text) {
  const std::string path = (std::filesystem::temp_directory_path() / "glenoid-device-profile-test.json").string();
  std::ofstream(path) << text;
  auto read = readDeviceProfiles(path);
  std::filesystem::remove(path);
  return read;
}

TEST(DeviceProfiles, whatIsWrongIsNamedWithItsPlace) {
  const char* const good = R"("id": "a", "name": "A", "source": "s", "damping": 1, "forceMax": 3, "slewMax": 100)";
  EXPECT_TRUE(readText(std::string("{\"devices\": [{") + good + "}]}"));
  const auto twice = readText(std::string("{\"devices\": [{") + good + "}, {" + good + "}]}");
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().fault, Fault::DuplicateId);
  const auto nothing = readText("{}");
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().fault, Fault::SchemaMismatch);
  const auto noSource = readText(R"({"devices": [{"id": "a", "name": "A", "damping": 1, "forceMax": 3, "slewMax": 100}]})");
  ASSERT_FALSE(noSource);
  EXPECT_EQ(noSource.error().place.pointer, "/devices/0/source");
  const auto negative = readText(R"({"devices": [{"id": "a", "name": "A", "source": "s", "damping": -1, "forceMax": 3, "slewMax": 100}]})");
  ASSERT_FALSE(negative);
  EXPECT_EQ(negative.error().fault, Fault::OutOfRange);
  EXPECT_EQ(negative.error().place.pointer, "/devices/0/damping");
}

}  // namespace
}  // namespace glenoid
