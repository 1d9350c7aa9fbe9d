// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <random>

#include "simcore/fem/Rotation.h"
#include "simcore/fem/StretchLaw.h"

namespace glenoid {
namespace {

using Mat9 = Eigen::Matrix<double, 9, 9>;

constexpr double kE = 1e5;  // Pa
const double kPoisson[] = {0.0, 0.3, 0.45, 0.49};

/// The stretch s at which f vanishes, f falling or rising through it once between a and b.
template <class F>
double rootOf(const F& f, double a, double b) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (a + b);
    ((f(middle) > 0) == (f(a) > 0) ? a : b) = middle;
  }
  return 0.5 * (a + b);
}

/// What the sides shrink to where nothing holds them, the one axis (or two) at s; `held`: one side keeps its length.
enum class Sides { Free, OneHeld, TwoPull };
Vec3 atRest(const Lame& lame, double s, Sides sides) {
  const auto stretches = [&](double t) {
    return sides == Sides::Free ? Vec3(s, t, t) : sides == Sides::OneHeld ? Vec3(s, 1, t) : Vec3(s, s, t);
  };
  return stretches(rootOf([&](double t) { return principalStress(lame, stretches(t))[2]; }, -1.0, 5.0));
}

Mat3 randomTurn(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Quat(normal(random), normal(random), normal(random), normal(random)).normalized().toRotationMatrix();
}

Vec3 randomStretches(std::mt19937& random, double from, double to) {
  std::uniform_real_distribution<double> uniform(from, to);
  return {uniform(random), uniform(random), uniform(random)};
}

/// ∂ψ/∂F of the whole law.
Mat3 stressAt(const Lame& lame, const Mat3& F) {
  const Mat3 R = rotationBySvd(F).toRotationMatrix(), M = R.transpose() * F, strain = 0.5 * (M + M.transpose()) - Mat3::Identity();
  Mat3 stress = 2 * lame.mu * strain + lame.lambda * strain.trace() * Mat3::Identity();
  if (const auto more = stretchCorrection(lame, lame, F, R)) stress += more->stress_E;
  return R * stress;
}

double energyAt(const Lame& lame, const Mat3& F) {
  const Mat3 R = rotationBySvd(F).toRotationMatrix(), M = R.transpose() * F, strain = 0.5 * (M + M.transpose()) - Mat3::Identity();
  const auto more = stretchCorrection(lame, lame, F, R);
  return lame.mu * strain.squaredNorm() + 0.5 * lame.lambda * strain.trace() * strain.trace() + (more ? more->energy : 0);
}

/// ∂²ψ/∂F² by differences, columns of F one after the other.
Mat9 hessianAt(const Lame& lame, const Mat3& F) {
  Mat9 H;
  const double step = 1e-6;
  for (int k = 0; k < 9; ++k) {
    Mat3 plus = F, minus = F;
    plus.data()[k] += step;
    minus.data()[k] -= step;
    H.col(k) = ((stressAt(lame, plus) - stressAt(lame, minus)) / (2 * step)).reshaped();
  }
  return 0.5 * (H + H.transpose());
}

/// What A holds of it: the linear stiffness at frozen rotation, tension's and the correction's.
Mat9 stiffnessOfA(const Lame& lame, const Mat3& F) {
  const Mat3 R = rotationBySvd(F).toRotationMatrix();
  CorotTet tet;
  tet.volume = 1;
  tet.lame = lame;
  const auto more = stretchCorrection(lame, lame, F, R);
  const double turning = tensionStiffness(tet, F, R) + (more ? more->turning : 0);
  Mat9 A;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vec3 bi = R.col(i), bj = R.col(j);
      Mat3 block = stiffnessBlock(tet, bi, bj) + tensionBlock(turning, bi, bj);
      for (int m = 0; more && m < more->count; ++m) {
        const Mat3 y = R * more->terms[m].direction_E;
        block += more->terms[m].stiffness * y.col(i) * y.col(j).transpose();
      }
      A.block<3, 3>(3 * i, 3 * j) = block;
    }
  return A;
}

double lowest(const Mat9& m) { return Eigen::SelfAdjointEigenSolver<Mat9>(m).eigenvalues()[0]; }

TEST(StretchLaw, underADeadLoadTheForceIsLinearAtAnyStretch) {
  for (const double nu : kPoisson)
    for (const double s : {0.6, 0.8, 1.0, 1.1, 1.2, 1.5, 2.0, 3.0, 4.0, 6.0}) {
      const Lame lame = lameFrom(kE, nu);
      // Exact: with h of the sides −ν h(s) the sides carry nothing and the axis E (s − 1), where they do not swell past 1.2.
      EXPECT_NEAR(principalStress(lame, atRest(lame, s, Sides::Free))[0], kE * (s - 1), 1e-9 * kE) << nu << " " << s;
    }
}

TEST(StretchLaw, underTensionNothingTurnsInsideOut) {
  for (const double nu : kPoisson) {
    const Lame lame = lameFrom(kE, nu);
    double last = 0;
    for (double s = 1; s <= 4.0001; s += 0.05) {
      const Vec3 bar = atRest(lame, s, Sides::Free), held = atRest(lame, s, Sides::OneHeld);
      EXPECT_GE(bar.prod(), 0.8) << nu << " " << s;
      EXPECT_GE(held.prod(), 0.5) << nu << " " << s;
      if (s <= 2) {
        EXPECT_GE(atRest(lame, s, Sides::TwoPull).prod(), 0.25) << nu << " " << s;
      }
      // With one side held it pulls the harder, the longer.
      const double pull = principalStress(lame, held)[0];
      EXPECT_TRUE(s == 1 || pull > last) << nu << " " << s;
      last = pull;
    }
    // Held at all sides (a thin layer pulled apart) it does not soften either.
    for (double s = 1; s < 6; s += 0.02)
      EXPECT_GT(principalStress(lame, {s + 0.02, 1, 1})[0], principalStress(lame, {s, 1, 1})[0]) << nu << " " << s;
  }
}

TEST(StretchLaw, whereTheLinearLawTurnsInsideOut) {
  // The cause of it all: at s = 1 + 1/ν the sides of the linear law have shrunk to nothing.
  const Lame lame = lameFrom(kE, 0.45);
  for (const double s : {3.1, 3.4}) {
    const double side = 1 - 0.45 * (s - 1);
    EXPECT_EQ(side > 0, s < 1 + 1 / 0.45);
    EXPECT_GT(atRest(lame, s, Sides::Free)[1], 0.5);
  }
}

TEST(StretchLaw, pressedAlongOneAxisItHoldsThreeModuli) {
  double last = 0;
  for (const double nu : kPoisson) {
    const Lame lame = lameFrom(kE, nu);
    const double s = rootOf([&](double t) { return principalStress(lame, atRest(lame, t, Sides::Free))[0] + 3 * kE; }, 0.1, 0.9);
    // With ν 0 the sides stay, and s follows from h alone (0.137); they hold the more, the more they swell.
    if (nu == 0) {
      EXPECT_NEAR(0.4 / s * (0.6 + 0.4 * std::log(0.4 / s)), 3, 1e-9);
    }
    EXPECT_GT(s, last) << nu;
    EXPECT_LT(s, 0.18) << nu;
    last = s;
    for (const auto& [share, state] : {std::pair(1.02, TissueState::Sound), {0.98, TissueState::Pressed}})
      EXPECT_EQ(tissueState(lame, atRest(lame, share * s, Sides::Free).asDiagonal(), true), state) << nu;
  }
}

TEST(StretchLaw, inItsRangeItIsTheLinearLawToTheLastBit) {
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    const Mat3 R = randomTurn(random), V = randomTurn(random);
    const Vec3 s = randomStretches(random, 0.35, 1.25);
    const bool inside = s.minCoeff() > stretch_law::kLinearFrom && s.maxCoeff() < stretch_law::kLinearTo;
    EXPECT_EQ(stretchCorrection(lameFrom(kE, 0.45), lameFrom(kE, 0.45), R * V * s.asDiagonal() * V.transpose(), R).has_value(), !inside);
  }
  // Nothing either where the packed kernels do not ask.
  for (int i = 0; i < 2000; ++i) {
    const Vec3 strain = randomStretches(random, -1, 1).normalized() * std::sqrt(stretch_law::kSurely);
    const Mat3 V = randomTurn(random), S = V * (Vec3::Ones() + 0.999999 * strain).asDiagonal() * V.transpose();
    EXPECT_TRUE(isLinearRange(S));
  }
  const double huge = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {huge, nan}) EXPECT_FALSE(stretchCorrection(lameFrom(kE, 0.3), lameFrom(kE, 0.3), Mat3::Constant(bad), Mat3::Identity()));
}

TEST(StretchLaw, stressIsTheSlopeOfTheEnergyAndTangentThatOfStress) {
  std::mt19937 random(6);
  for (const double nu : kPoisson)
    for (int i = 0; i < 100; ++i) {
      const Lame lame = lameFrom(kE, nu);
      const Vec3 s = randomStretches(random, -0.5, 3);
      const double step = 1e-6, scale = lame.mu + lame.lambda;
      for (int k = 0; k < 3; ++k) {
        const Vec3 d = step * Vec3::Unit(k);
        // Round-off of differences 1e-10/1e-6 of what the steep side holds: slope 4, twice.
        EXPECT_NEAR((energyDensity(lame, s + d) - energyDensity(lame, s - d)) / (2 * step), principalStress(lame, s)[k], 1e-7 * 16 * scale);
        bool atKink = false;
        for (const double kink : {stretch_law::kLinearTo, stretch_law::kLinearFrom, stretch_law::kLogarithmTo})
          atKink |= std::abs(s[k] - kink) < 2 * step;
        if (atKink) continue;
        const Vec3 slope = (principalStress(lame, s + d) - principalStress(lame, s - d)) / (2 * step);
        EXPECT_LT((slope - principalTangent(lame, s).col(k)).norm(), 1e-6 * 40 * scale) << s.transpose();
      }
      const Mat3 R = randomTurn(random), V = randomTurn(random), F = R * V * s.cwiseAbs().asDiagonal() * V.transpose();
      const Mat3 dF = randomTurn(random);
      const double slope = (energyAt(lame, F + step * dF) - energyAt(lame, F - step * dF)) / (2 * step);
      EXPECT_NEAR(slope, stressAt(lame, F).cwiseProduct(dF).sum(), 1e-5 * scale) << s.transpose();
    }
}

TEST(StretchLaw, turnsWithTheElement) {
  std::mt19937 random(7);
  const Lame lame = lameFrom(kE, 0.45);
  for (int i = 0; i < 200; ++i) {
    const Vec3 s = randomStretches(random, 0.05, 3);
    const Mat3 R = randomTurn(random), V = randomTurn(random), Q = randomTurn(random);
    const Mat3 F = R * V * s.asDiagonal() * V.transpose();
    const auto here = stretchCorrection(lame, lame, F, R), there = stretchCorrection(lame, lame, Q * F, Q * R);
    ASSERT_EQ(here.has_value(), there.has_value());
    if (!here) continue;
    EXPECT_LT((here->stress_E - there->stress_E).norm(), 1e-9 * (kE + here->stress_E.norm()));
    EXPECT_NEAR(here->turning, there->turning, 1e-9 * (kE + here->stress_E.norm()));
    // No torque: the stress in W times Fᵀ is symmetric.
    const Mat3 tau = stressAt(lame, F) * F.transpose();
    EXPECT_LT((tau - tau.transpose()).norm(), 1e-9 * (kE + tau.norm()));
  }
}

TEST(StretchLaw, whatAHoldsIsDefiniteAndAboveTheLaw) {
  std::mt19937 random(8);
  for (const double nu : kPoisson) {
    const Lame lame = lameFrom(kE, nu);
    for (int i = 0; i < 300; ++i) {
      // Two stretches together above 0.5, as the bound against turning wants, and not at a kink of the tangent.
      const Vec3 s = randomStretches(random, 0.26, 4);
      bool atKink = false;
      for (int k = 0; k < 3; ++k) atKink |= std::abs(s[k] - stretch_law::kLinearTo) < 1e-5 || std::abs(s[k] - stretch_law::kLinearFrom) < 1e-5;
      if (atKink) continue;
      const Mat3 R = randomTurn(random), V = randomTurn(random), F = R * V * s.asDiagonal() * V.transpose();
      const Mat9 A = stiffnessOfA(lame, F), H = hessianAt(lame, F);
      const double scale = A.norm() + H.norm();
      EXPECT_GT(lowest(A), -1e-12 * scale) << s.transpose();
      EXPECT_GT(lowest(A - H), -1e-6 * scale) << nu << ": " << s.transpose();  // of the differences
    }
    // Flat and inside out it is still definite.
    for (int i = 0; i < 300; ++i) {
      Vec3 s = randomStretches(random, 0, 3);
      s[2] = -0.5 * s.head<2>().minCoeff();
      const Mat3 R = randomTurn(random), V = randomTurn(random);
      const Mat9 A = stiffnessOfA(lame, R * V * s.asDiagonal() * V.transpose());
      EXPECT_GT(lowest(A), -1e-12 * A.norm()) << s.transpose();
    }
  }
}

TEST(StretchLaw, entangledBodiesAreLinearAgain) {
  EXPECT_EQ(lawRange(0, 5), LawRange::Whole);
  EXPECT_EQ(lawRange(1, 100), LawRange::Whole);
  EXPECT_EQ(lawRange(2, 100), LawRange::TensionOnly);
  EXPECT_EQ(lawRange(5, 100), LawRange::TensionOnly);
  EXPECT_EQ(lawRange(6, 100), LawRange::Linear);
  // Without what holds pressed elements open nothing is added below the linear range, and the same above it.
  const Lame lame = lameFrom(kE, 0.3);
  const auto crushed = stretchCorrection(lame, lame, Vec3(0.1, 0.9, -0.5).asDiagonal(), Mat3::Identity(), false);
  ASSERT_TRUE(crushed.has_value());
  EXPECT_LT(crushed->stress_E.norm(), 1e-10 * kE);
  EXPECT_EQ(principalStress(lame, {3, 0.8, 0.6}, false), principalStress(lame, {3, 0.8, 0.6}, true));
}

TEST(StretchLaw, whatIsCountedIsWhatItsPrincipalStressesSay) {
  std::mt19937 random(9);
  int pressed = 0, insideOut = 0;
  for (const double nu : kPoisson)
    for (int i = 0; i < 3000; ++i) {
      const Lame lame = lameFrom(kE, nu);
      const Vec3 s = i % 2 ? randomStretches(random, -0.1, 1.3) : randomStretches(random, 0.8, 1.05);
      const Mat3 F = randomTurn(random) * s.asDiagonal() * randomTurn(random);
      const bool out = F.determinant() <= 0;
      insideOut += out;
      for (const bool law : {true, false}) {
        const Vec3 linear = 2 * lame.mu * (s - Vec3::Ones()) + Vec3::Constant(lame.lambda * (s.sum() - 3));
        const bool press = (law ? principalStress(lame, s.cwiseAbs()) : linear).minCoeff() <= -3 * kE;
        if (out && s.minCoeff() < 0) {
          EXPECT_EQ(tissueState(lame, F, law), TissueState::InsideOut);
        } else if (!out && s.minCoeff() > 0) {
          EXPECT_EQ(tissueState(lame, F, law), press ? TissueState::Pressed : TissueState::Sound) << nu << ": " << s.transpose();
          pressed += press;
        }
      }
    }
  EXPECT_GT(pressed, 500);
  EXPECT_GT(insideOut, 500);
}

}  // namespace
}  // namespace glenoid
