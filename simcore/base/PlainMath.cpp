// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/base/PlainMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glenoid::plain {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

// Constants in parts: the first ones have so few digits that their products with small whole numbers are exact.
constexpr double kHalfPi = 0x1.921fb54442d18p+0, kHalfPiRest = 0x1.1a62633145c07p-54;
constexpr double kHalfPi1 = 0x1.921fb544p+0, kHalfPi2 = 0x1.0b4611a6p-34, kHalfPi3 = 0x1.3198a2e037073p-69;
constexpr double kLog2High = 0x1.62e42feep-1, kLog2Low = 0x1.a39ef35793c76p-33;
constexpr double kAtanHalf = 0x1.dac670561bb4fp-2, kAtanHalfRest = 0x1.a2b7f222f65e2p-56;

/// Σ c[k] zᵏ.
template <std::size_t n>
constexpr double horner(const std::array<double, n>& c, double z) {
  double sum = c[n - 1];
  for (std::size_t k = n - 1; k-- > 0;) sum = sum * z + c[k];
  return sum;
}

/// sign^k / (first + 2k)! for k = 0, 1, …
template <std::size_t n>
constexpr std::array<double, n> alternatingFactorials(int first) {
  std::array<double, n> c{};
  double factorial = 1;  // exact up to 22!
  for (int i = 2; i <= first; ++i) factorial *= i;
  for (std::size_t k = 0; k < n; ++k) {
    c[k] = (k % 2 ? -1 : 1) / factorial;
    const int last = first + 2 * static_cast<int>(k);
    factorial *= (last + 1) * (last + 2);
  }
  return c;
}

/// x = quadrant · π/2 + angle + rest with |angle| ≤ π/4.
struct Reduced {
  double angle, rest;
  int quadrant;
};
Reduced reduce(double x) {
  const double k = std::floor(x * (1 / kHalfPi) + 0.5);
  const double t = x - k * kHalfPi1, w = k * kHalfPi2;
  const double high = t - w, low = ((t - high) - w) - k * kHalfPi3;
  const double angle = high + low;
  return {angle, (high - angle) + low, static_cast<int>(k - 4 * std::floor(k / 4))};
}

double sineNear(double y, double rest) {
  static constexpr auto c = alternatingFactorials<8>(3);  // −(y³/3! − y⁵/5! + … − y¹⁷/17!)
  const double z = y * y;
  return y + (rest * (1 - 0.5 * z) - y * z * horner(c, z));
}

double cosineNear(double y, double rest) {
  static constexpr auto c = alternatingFactorials<8>(4);  // y⁴/4! − … − y¹⁸/18!
  const double z = y * y, half = 0.5 * z, w = 1 - half;
  return w + (((1 - w) - half) + (z * z * horner(c, z) - y * rest));
}

/// arctan u for |u| ≤ ¼ less u itself.
double arcTangentRest(double u) {
  static constexpr auto c = [] {
    std::array<double, 13> a{};
    for (int k = 0; k < 13; ++k) a[k] = (k % 2 ? 1.0 : -1.0) / (2 * k + 3);
    return a;
  }();
  const double z = u * u;
  return u * z * horner(c, z);
}

}  // namespace

double sine(double x) {
  if (!std::isfinite(x)) return kNaN;
  const Reduced r = reduce(x);
  switch (r.quadrant) {
    case 0: return sineNear(r.angle, r.rest);
    case 1: return cosineNear(r.angle, r.rest);
    case 2: return -sineNear(r.angle, r.rest);
    default: return -cosineNear(r.angle, r.rest);
  }
}

double cosine(double x) {
  if (!std::isfinite(x)) return kNaN;
  const Reduced r = reduce(x);
  switch (r.quadrant) {
    case 0: return cosineNear(r.angle, r.rest);
    case 1: return -sineNear(r.angle, r.rest);
    case 2: return -cosineNear(r.angle, r.rest);
    default: return sineNear(r.angle, r.rest);
  }
}

double arcTangent(double y, double x) {
  if (!std::isfinite(x) || !std::isfinite(y)) return kNaN;
  const double a = std::abs(y), b = std::abs(x), low = std::min(a, b), high = std::max(a, b);
  double angle = 0, rest = 0;  // of (high, low), 0 … π/4
  if (high > 0) {
    if (low <= 0.25 * high) {
      angle = low / high;
      rest = arcTangentRest(angle);
    } else if (low <= 0.75 * high) {  // arctan t = arctan ½ + arctan (t − ½)/(1 + t/2)
      const double u = (low - 0.5 * high) / (high + 0.5 * low);
      angle = kAtanHalf;
      rest = u + (arcTangentRest(u) + kAtanHalfRest);
    } else {
      const double u = (low - high) / (high + low);
      angle = 0.5 * kHalfPi;
      rest = u + (arcTangentRest(u) + 0.5 * kHalfPiRest);
    }
  }
  if (a > b) {
    const double turned = kHalfPi - angle;
    rest = ((kHalfPi - turned) - angle) - rest + kHalfPiRest;
    angle = turned;
  }
  if (std::signbit(x)) {
    const double turned = 2 * kHalfPi - angle;
    rest = ((2 * kHalfPi - turned) - angle) - rest + 2 * kHalfPiRest;
    angle = turned;
  }
  return std::copysign(angle + rest, y);
}

double arcSine(double x) {
  if (std::isnan(x)) return kNaN;
  const double s = std::clamp(x, -1.0, 1.0);
  return arcTangent(s, std::sqrt((1 - s) * (1 + s)));
}

double exponential(double x) {
  if (std::isnan(x)) return kNaN;
  if (x > 709.79) return kInfinity;
  if (x < -745.2) return 0;
  static constexpr auto c = [] {
    std::array<double, 12> a{};  // 1/2!, 1/3!, … 1/13!
    double factorial = 1;
    for (int k = 0; k < 12; ++k) a[k] = 1 / (factorial *= k + 2);
    return a;
  }();
  const double k = std::floor(x * (1 / (kLog2High + kLog2Low)) + 0.5);
  const double high = x - k * kLog2High, low = k * kLog2Low, r = high - low, lost = (high - r) - low;
  const double value = 1 + (r + (r * r * horner(c, r) + lost));
  // In two goes, so that neither factor leaves the range before the product does.
  const int half = static_cast<int>(k) / 2;
  return std::ldexp(std::ldexp(value, half), static_cast<int>(k) - half);
}

double logarithm(double x) {
  if (std::isnan(x) || x < 0) return kNaN;
  if (x == 0) return -kInfinity;
  if (std::isinf(x)) return kInfinity;
  static constexpr auto c = [] {
    std::array<double, 11> a{};
    for (int k = 0; k < 11; ++k) a[k] = 2.0 / (2 * k + 3);
    return a;
  }();
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0x1.6a09e667f3bcdp-1) {  // √½
    m *= 2;
    --exponent;
  }
  // log (1 + f) = 2 artanh s = f − f²/2 + s (f²/2 + 2 s²/3 + 2 s⁴/5 + …) with s = f/(2 + f).
  const double f = m - 1, s = f / (2 + f), z = s * s, half = 0.5 * f * f, k = exponent;
  return k * kLog2High - ((half - (s * (half + z * horner(c, z)) + k * kLog2Low)) - f);
}

double cubeRoot(double x) {
  if (!std::isfinite(x) || x == 0) return x;
  int exponent = 0;
  double m = std::frexp(std::abs(x), &exponent);
  int third = exponent / 3;
  int over = exponent - 3 * third;  // −2 … 2
  if (over > 0) {
    over -= 3;
    ++third;
  }
  m = std::ldexp(m, over);  // 1/8 … 1
  double root = 0.4 + 0.6 * m;
  for (int i = 0; i < 6; ++i) root -= (root - m / (root * root)) / 3;
  return std::copysign(std::ldexp(root, third), x);
}

}  // namespace glenoid::plain
