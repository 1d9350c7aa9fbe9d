// SPDX-License-Identifier: GPL-3.0-or-later
// Judged by the C library in extended precision, whose 11 more bits make its own error invisible here.
#include "simcore/base/PlainMath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace glenoid {
namespace {

static_assert(std::numeric_limits<long double>::digits > 60, "the reference has more digits than a double");

/// |value − exact| in units of the last place of a double of that size.
double ulps(double value, long double exact) {
  const double size = std::abs(static_cast<double>(exact));
  const double unit = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) / unit);
}

/// Worst error over arguments spread over a range, and over others near each power of two in it.
template <class Function, class Reference>
double worst(Function f, Reference reference, double low, double high) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> spread(low, high), octave(-60, 60);
  double most = 0;
  for (int i = 0; i < 200000; ++i) {
    double x = spread(random);
    if (i % 4 == 0) {
      x = std::copysign(std::exp2(octave(random)), x);
      if (x < low || x > high) continue;
    }
    most = std::max(most, ulps(f(x), reference(static_cast<long double>(x))));
  }
  return most;
}

// The limits are those that the header promises.

TEST(PlainMath, sineAndCosineAreRightToTheLastDigit) {
  EXPECT_LT(worst(plain::sine, [](long double x) { return sinl(x); }, -7, 7), 1);
  EXPECT_LT(worst(plain::cosine, [](long double x) { return cosl(x); }, -7, 7), 1);
  EXPECT_LT(worst(plain::sine, [](long double x) { return sinl(x); }, -1e5, 1e5), 1);
  EXPECT_LT(worst(plain::cosine, [](long double x) { return cosl(x); }, -1e5, 1e5), 1);
  // Near the zeros all digits come from what the reduction keeps: 1.22e-16 at the double nearest to π.
  for (int k = 1; k < 2000; ++k) {
    const double x = k * (std::numbers::pi / 2);
    EXPECT_LT(ulps(plain::sine(x), sinl(x)), 1) << k;
    EXPECT_LT(ulps(plain::cosine(x), cosl(x)), 1) << k;
  }
  EXPECT_EQ(plain::sine(0.0), 0.0);
  EXPECT_EQ(plain::cosine(0.0), 1.0);
  EXPECT_EQ(plain::sine(1e-300), 1e-300);
  EXPECT_TRUE(std::isnan(plain::sine(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(plain::cosine(std::nan(""))));
}

TEST(PlainMath, anglesOfPointsAreRightInEveryQuadrant) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> side(-1, 1), octave(-40, 40);
  double most = 0;
  for (int i = 0; i < 400000; ++i) {
    const double scale = i % 2 ? std::exp2(octave(random)) : 1, y = side(random) * scale, x = side(random);
    most = std::max(most, ulps(plain::arcTangent(y, x), atan2l(y, x)));
  }
  EXPECT_LT(most, 2);
  for (const double y : {0.0, -0.0, 1.0, -1.0, 0.25, 0.5, 0.75, 3.0})
    for (const double x : {0.0, -0.0, 1.0, -1.0, 4.0, 0.25}) {
      EXPECT_LT(std::abs(plain::arcTangent(y, x) - std::atan2(y, x)), 1e-15) << y << " " << x;
      EXPECT_EQ(std::signbit(plain::arcTangent(y, x)), std::signbit(std::atan2(y, x))) << y << " " << x;
    }
  EXPECT_TRUE(std::isnan(plain::arcTangent(std::nan(""), 1)));
}

TEST(PlainMath, arcSines) {
  EXPECT_LT(worst(plain::arcSine, [](long double x) { return asinl(x); }, -1, 1), 3);
  EXPECT_EQ(plain::arcSine(1.5), plain::arcSine(1.0));
  EXPECT_EQ(plain::arcSine(1.0), std::numbers::pi / 2);
}

TEST(PlainMath, exponentialsAndLogarithms) {
  EXPECT_LT(worst(plain::exponential, [](long double x) { return expl(x); }, -1, 1), 1);
  EXPECT_LT(worst(plain::exponential, [](long double x) { return expl(x); }, -700, 700), 1);
  EXPECT_LT(worst(plain::logarithm, [](long double x) { return logl(x); }, 1e-18, 2), 1);
  EXPECT_LT(worst(plain::logarithm, [](long double x) { return logl(x); }, 0.9, 1.1), 1);
  EXPECT_LT(worst(plain::logarithm, [](long double x) { return logl(x); }, 1e-300, 1e300), 1);
  EXPECT_EQ(plain::exponential(0), 1);
  EXPECT_EQ(plain::exponential(-800), 0);
  EXPECT_TRUE(std::isinf(plain::exponential(800)));
  EXPECT_NEAR(plain::exponential(-740) / std::exp(-740), 1, 0.01);  // a subnormal has few digits
  EXPECT_EQ(plain::logarithm(1), 0);
  EXPECT_TRUE(std::isinf(plain::logarithm(0)));
  EXPECT_TRUE(std::isnan(plain::logarithm(-1)));
}

TEST(PlainMath, cubeRoots) {
  EXPECT_LT(worst(plain::cubeRoot, [](long double x) { return cbrtl(x); }, -10, 10), 1);
  EXPECT_LT(worst(plain::cubeRoot, [](long double x) { return cbrtl(x); }, 1e-12, 1e12), 1);
  for (const double whole : {1.0, 2.0, 3.0, 10.0, -7.0}) EXPECT_LT(ulps(plain::cubeRoot(whole * whole * whole), whole), 1);
  EXPECT_EQ(plain::cubeRoot(0), 0);
}

}  // namespace
}  // namespace glenoid
