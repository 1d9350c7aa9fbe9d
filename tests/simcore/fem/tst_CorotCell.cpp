// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/fem/CorotCell.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cstdio>
#include <random>

#include "simcore/fem/Rotation.h"
#include "tests/simcore/fem/Bands.h"

namespace glenoid {
namespace {

constexpr double kEdge = 0.008, kYoung = 5e4;

CellBox turnedBox() {
  CellBox box;
  box.origin = Vec3(0.1, -0.2, 0.05);
  box.axes = Eigen::AngleAxisd(0.6, Vec3(1, -2, 2).normalized()).toRotationMatrix();
  box.edges = Vec3(1, 1.1, 0.9) * kEdge;
  return box;
}

/// Cells with all kinds of tissue: full, a band, a rod in a corner, two materials.
std::vector<CorotCell> cells(double nu) {
  const CellBox box = turnedBox();
  const double volume = box.edges.prod();
  const auto part = [&](const Vec3& low, const Vec3& high, double young) {
    return CellTissue{test::momentsOfPart(low, high, volume), lameFrom(young, nu)};
  };
  const CellTissue full{fullBox(volume), lameFrom(kYoung, nu)};
  const CellTissue band = part(Vec3(-1, -1, 0.1), Vec3(1, 1, 0.35), kYoung), rod = part(Vec3(-1, 0.6, 0.5), Vec3(1, 1, 1), kYoung);
  const std::vector<CellTissue> both{part(Vec3(-1, -1, -1), Vec3(0.2, 1, 0), kYoung), part(Vec3(0.2, -1, -1), Vec3(1, 1, 0), 7 * kYoung)};
  return {makeCorotCell(box, {&full, 1}).value(), makeCorotCell(box, {&band, 1}).value(), makeCorotCell(box, {&rod, 1}).value(),
          makeCorotCell(box, both).value()};
}

Mat3 rotationOf(const CorotCell& cell, const Mat38& x) {
  Quat R = Quat::Identity();
  nearestRotation(deformationGradient(cell, x), R, 100);
  return R.toRotationMatrix();
}

Mat38 forceAt(const CorotCell& cell, const Mat38& x) { return elasticForce(cell, x, deformationGradient(cell, x), rotationOf(cell, x)); }

Mat38 scattered(const Mat38& x, double by, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Mat38 moved = x;
  for (double& value : moved.reshaped()) value += by * uniform(random);
  return moved;
}

TEST(CorotCell, pointsIntegrateThePolynomialsOfTheMoments) {
  const Vec3 low(-0.7, -1, 0.2), high(0.1, 0.5, 0.9);
  const BoxMoments moments = test::momentsOfPart(low, high, 3);
  BoxMoments again;
  for (const BoxPoint& point : boxPoints(moments))
    for (int k = 0; k < 27; ++k)
      again.value[k] += point.weight * std::pow(point.xi[0], k % 3) * std::pow(point.xi[1], k / 3 % 3) * std::pow(point.xi[2], k / 9);
  for (int k = 0; k < 27; ++k) EXPECT_NEAR(again.value[k], moments.value[k], 1e-15) << k;
  EXPECT_NEAR(fullBox(3).value[26], 3.0 / 27, 1e-15);
}

TEST(CorotCell, rigidMotionGivesNoForce) {
  for (const CorotCell& cell : cells(0.4))
    for (const double angle : {0.1, 1.0, 3.0}) {
      const Mat3 R = Eigen::AngleAxisd(angle, Vec3(1, 2, -2).normalized()).toRotationMatrix();
      const Mat38 x = (R * cell.x0_E).colwise() + Vec3(0.1, -2, 0.4);
      // Two metres from the origin a corner keeps 4e-16 m.
      EXPECT_LT(forceAt(cell, x).norm() / cell.K_E.norm(), 1e-15);
    }
}

TEST(CorotCell, stiffnessHoldsEveryMotionThatIsNotRigid) {
  for (const CorotCell& cell : cells(0.45)) {
    const Eigen::SelfAdjointEigenSolver<Mat24> modes(cell.K_E);
    for (int k = 0; k < 6; ++k) EXPECT_LT(std::abs(modes.eigenvalues()[k]), 1e-12 * modes.eigenvalues()[23]) << k;
    EXPECT_GT(modes.eigenvalues()[6], 1e-7 * modes.eigenvalues()[23]);
  }
}

TEST(CorotCell, cellsTwistedByTheirBandPushBackWhateverTissueTheyHold) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  double least = 1;
  for (int trial = 0; trial < 300; ++trial) {
    Mat38 corners = cornersOf(turnedBox());
    const Vec3 off = turnedBox().axes.col(2);
    const double twist = (uniform(random) - 0.5) * kEdge, tiltX = uniform(random) * kEdge, tiltY = uniform(random) * kEdge;
    for (int i = 0; i < 8; ++i) corners.col(i) += ((i & 1) * tiltX + (i >> 1 & 1) * tiltY + (i & i >> 1 & 1) * twist) * off;
    Vec3 low, high;
    for (int a = 0; a < 3; ++a) {
      low[a] = -1 + 1.9 * uniform(random);
      high[a] = low[a] + (a == 2 ? 0.05 + 0.3 * uniform(random) : 2 * uniform(random));
      high[a] = std::min(high[a], 1.0);
    }
    const CellTissue tissue{test::momentsOfPart(low, high, turnedBox().edges.prod()), lameFrom(kYoung, 0.49 * uniform(random))};
    const CorotCell cell = makeCorotCell(corners, {&tissue, 1}).value();
    const Eigen::SelfAdjointEigenSolver<Mat24> modes(cell.K_E);
    least = std::min(least, modes.eigenvalues()[0] / modes.eigenvalues()[23]);
    // Rigid turns and affine strains are told exactly.
    Mat3 strain;
    strain << 0.03, 0.02, -0.01, 0.02, -0.02, 0.03, -0.01, 0.03, 0.01;
    const Mat38 x = cell.x0_E + strain * cell.x0_E;
    const Mat3 stress = 2 * tissue.lame.mu * strain + tissue.lame.lambda * strain.trace() * Mat3::Identity();
    const Mat38 wanted = -cell.volume * stress * cell.gradients_E;
    EXPECT_LT((forceAt(cell, x) - wanted).norm(), 1e-8 * wanted.norm());
    const Mat3 R = Eigen::AngleAxisd(2, Vec3(1, 2, -2).normalized()).toRotationMatrix();
    EXPECT_LT(forceAt(cell, R * cell.x0_E).norm() / (cell.K_E.norm() * kEdge), 1e-12);
  }
  std::printf("twisted cells: least eigenvalue %.1e of the largest\n", least);
  EXPECT_GT(least, -1e-12);
}

TEST(CorotCell, constantStrainHasTheForcesAndTheEnergyOfTheTissue) {
  // The patch test: whatever tissue a cell holds, nothing but the constant stress acts on its corners, so that what is
  // affine is in equilibrium wherever its boundary is.
  Mat3 stretch;
  stretch << 0.03, 0.02, -0.01, 0.02, -0.02, 0.03, -0.01, 0.03, 0.01;
  const Mat3 turn = Eigen::AngleAxisd(1.9, Vec3(2, -1, 1).normalized()).toRotationMatrix();
  for (const double nu : {0.0, 0.3, 0.49}) {
    const std::vector<CorotCell> all = cells(nu);
    for (std::size_t k = 0; k < 3; ++k) {  // of one material
      const CorotCell& cell = all[k];
      const Lame lame = lameFrom(kYoung, nu);
      const Mat38 x = (turn * (Mat3::Identity() + stretch) * cell.x0_E).colwise() + Vec3(0.3, 0, -0.1);
      const Mat3 stress = 2 * lame.mu * stretch + lame.lambda * stretch.trace() * Mat3::Identity();
      const Mat38 wanted = -cell.volume * turn * stress * cell.gradients_E;
      EXPECT_LT((forceAt(cell, x) - wanted).norm(), 1e-10 * wanted.norm()) << nu;
      const double energy = 0.5 * cell.volume * stress.cwiseProduct(stretch).sum();
      EXPECT_NEAR(elasticEnergy(cell, x, rotationOf(cell, x)), energy, 1e-10 * energy);
    }
  }
  // The mean gradient of x is the identity.
  for (const CorotCell& cell : cells(0.3)) EXPECT_LT((cell.x0_E * cell.gradients_E.transpose() - Mat3::Identity()).norm(), 1e-12);
}

TEST(CorotCell, forceIsTheDerivativeOfTheEnergyAndKeepsAngularMomentum) {
  const Mat3 turn = Eigen::AngleAxisd(2.2, Vec3(2, 1, 1).normalized()).toRotationMatrix();
  for (const CorotCell& cell : cells(0.3))
    for (const double by : {0.05, 0.25}) {
      const Mat38 x = turn * scattered(cell.x0_E, by * kEdge, 3);
      const Mat38 force = forceAt(cell, x);
      Vec3 torque = Vec3::Zero();
      for (int i = 0; i < 8; ++i) torque += x.col(i).cross(force.col(i));
      EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());
      EXPECT_LT(torque.norm(), 1e-10 * force.norm() * kEdge);
      const double h = 1e-5 * kEdge;
      for (int i = 0; i < 24; ++i) {
        Mat38 plus = x, minus = x;
        plus.reshaped()[i] += h;
        minus.reshaped()[i] -= h;
        const double slope = (elasticEnergy(cell, plus, rotationOf(cell, plus)) - elasticEnergy(cell, minus, rotationOf(cell, minus))) / (2 * h);
        // Differences of the second order: (h / edge)² of the stiffness times an edge.
        EXPECT_NEAR(force.reshaped()[i], -slope, 1e-6 * force.norm());
      }
    }
}

TEST(CorotCell, flatAndInvertedCellsAreDrivenBack) {
  for (const CorotCell& cell : cells(0.4))
    for (const double squeeze : {0.0, -0.3, -1.0}) {
      const Mat38 x = scattered(Vec3(1, squeeze, 1).asDiagonal() * cell.x0_E, 1e-3 * kEdge, 9);
      const Mat38 force = forceAt(cell, x);
      ASSERT_TRUE(force.allFinite());
      EXPECT_LT(force.norm(), 100 * cell.K_E.norm() * kEdge);
      // Where R is limited the force is still nearly downhill: a small way along it lowers the energy.
      const double before = elasticEnergy(cell, x, rotationOf(cell, x));
      const Mat38 after = x + 1e-3 * kEdge / force.norm() * force;
      EXPECT_LT(elasticEnergy(cell, after, rotationOf(cell, after)), before) << squeeze;
    }
}

TEST(CorotCell, massShapeIsTheTissuesOwn) {
  const CellBox box = turnedBox();
  const Vec3 low(-1, -0.2, 0.1), high(0.4, 1, 0.35);
  const Mat8 M = cellMassShape(test::momentsOfPart(low, high, box.edges.prod()));
  const Vec3 size = 0.5 * (high - low).cwiseProduct(box.edges);
  EXPECT_NEAR(M.sum(), size.prod(), 1e-12 * size.prod());
  // Second moments of the small box about its middle, by corner positions in the box's axes.
  const Mat38 x = box.axes.transpose() * (cornersOf(box).colwise() - box.origin);
  const Vec3 middle = 0.5 * (0.5 * (low + high) + Vec3::Ones()).cwiseProduct(box.edges);
  EXPECT_LT((x * M.rowwise().sum() / M.sum() - middle).norm(), 1e-12 * kEdge);
  const Mat38 about = x.colwise() - middle;
  const Mat3 spread = about * M * about.transpose(), wanted = size.prod() / 12 * Mat3(size.cwiseAbs2().asDiagonal());
  EXPECT_LT((spread - wanted).norm(), 1e-11 * wanted.norm());
}

TEST(CorotCell, aFlatBandInThickCellsBendsLikeABeam) {
  for (const double nu : {0.0, 0.3, 0.45})
    for (const double thickness : {0.0012, 0.002, 0.004})
      for (const double middle : {0.004, 0.0017, 0.008, 0.0075}) {  // in the midst of a cell, low in it, across two
        test::BandBeam beam;
        beam.nu = nu;
        beam.bottom = middle - thickness / 2;
        beam.top = middle + thickness / 2;
        beam.nz = 2;
        if (beam.bottom < 0) continue;
        for (const int width : {1, 3}) {
          beam.ny = width;
          beam.glued = false;
          EXPECT_GT(beam.ratio(), 0.97) << nu << " " << thickness << " " << middle;
          EXPECT_LT(beam.ratio(), 1.005);
        }
        // Glued at its end, which holds back what it would widen there: wide bands feel that more.
        beam.ny = 1;
        beam.glued = true;
        EXPECT_GT(beam.ratio(), 0.85) << nu << " " << thickness << " " << middle;
        EXPECT_LT(beam.ratio(), 1.005);
      }
}

TEST(CorotCell, aBarOneCellThickBendsLikeABeamAndConverges) {
  for (const double nu : {0.0, 0.3, 0.45}) {
    test::BandBeam beam;
    beam.nu = nu;
    const double coarse = beam.ratio();
    beam.cell /= 2, beam.nx *= 2, beam.ny = beam.nz = 2;
    const double fine = beam.ratio();
    EXPECT_NEAR(coarse, 1, 0.05) << nu;
    EXPECT_NEAR(fine, 1, 0.01) << nu;
  }
}

/// The worst error of inner nodes of a unit cube of n³ cells, its boundary held at u = ∇φ with φ = e^{2x} sin √2 y sin √2 z:
/// harmonic, so that u is a field of equilibrium without load for any ν.
double innerError(int n, double nu) {
  const double a = std::sqrt(2.0);
  const auto exact = [&](const Vec3& x) {
    const double e = std::exp(2 * x.x());
    return Vec3(2 * e * std::sin(a * x.y()) * std::sin(a * x.z()), a * e * std::cos(a * x.y()) * std::sin(a * x.z()),
                a * e * std::sin(a * x.y()) * std::cos(a * x.z()));
  };
  CellBox box;
  box.edges.setConstant(1.0 / n);
  const CellTissue full{fullBox(box.edges.prod()), lameFrom(1, nu)};
  const Mat24 K = makeCorotCell(box, {&full, 1}).value().K_E;
  const auto inner = [&](int i, int j, int k) {
    if (i == 0 || j == 0 || k == 0 || i == n || j == n || k == n) return -1;
    return (i - 1) + (n - 1) * ((j - 1) + (n - 1) * (k - 1));
  };
  const int unknowns = 3 * (n - 1) * (n - 1) * (n - 1);
  MatX A = MatX::Zero(unknowns, unknowns);
  VecX b = VecX::Zero(unknowns), wanted = b;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        for (int p = 0; p < 8; ++p) {
          const int row = inner(i + (p & 1), j + (p >> 1 & 1), k + (p >> 2));
          if (row < 0) continue;
          for (int q = 0; q < 8; ++q) {
            const Vec3 x = Vec3(i + (q & 1), j + (q >> 1 & 1), k + (q >> 2)) / n;
            const int col = inner(i + (q & 1), j + (q >> 1 & 1), k + (q >> 2));
            const Mat3 block = K.block<3, 3>(3 * p, 3 * q);
            if (col < 0)
              b.segment<3>(3 * row) -= block * exact(x);
            else
              A.block<3, 3>(3 * row, 3 * col) += block, wanted.segment<3>(3 * col) = exact(x);
          }
        }
  return (A.llt().solve(b) - wanted).lpNorm<Eigen::Infinity>();
}

TEST(CorotCell, smoothFieldsConvergeWithSecondOrder) {
  for (const double nu : {0.0, 0.3, 0.45}) {
    const double coarse = innerError(3, nu), fine = innerError(6, nu);
    std::printf("nu %.2f: worst error of inner nodes %.2e and %.2e with 3 and 6 cells across, order %.2f\n", nu, coarse, fine,
                std::log2(coarse / fine));
    EXPECT_GT(std::log2(coarse / fine), 1.8) << nu;
  }
}

TEST(CorotCell, whatHoldsNothingIsRefused) {
  const CellTissue nothing{{}, lameFrom(1, 0.3)};
  EXPECT_EQ(makeCorotCell(turnedBox(), {&nothing, 1}).error().fault, Fault::BadElement);
  CellBox flat = turnedBox();
  flat.edges.y() = 0;
  const CellTissue full{fullBox(1), lameFrom(1, 0.3)};
  EXPECT_EQ(makeCorotCell(flat, {&full, 1}).error().fault, Fault::BadElement);
}

}  // namespace
}  // namespace glenoid
