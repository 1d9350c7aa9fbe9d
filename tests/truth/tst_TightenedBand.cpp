// SPDX-License-Identifier: GPL-3.0-or-later
// A thin band between two clamps, pushed in its middle by two to seven times its thickness: it bends and it tightens. Judged by the
// beam under tension whose tension is that of its own lengthening, in closed form (Timoshenko and Woinowsky-Krieger, "Theory of
// Plates and Shells", 1959, art. 4, for a force in the middle), not by finer runs of the same elements.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "simcore/embed/Cells.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/step/Measures.h"

namespace glenoid::truth {
namespace {

constexpr double kLength = 0.048, kWidth = 0.008, kThickness = 0.0015, kE = 4e6;  // m, m, m, Pa

/// Deflection under a force in the middle, m.
double closedForm(double force) {
  const double EI = kE * kWidth * std::pow(kThickness, 3) / 12, EA = kE * kWidth * kThickness;
  const auto slopeAt = [&](double x, double S) {
    const double k = std::sqrt(S / EI);
    return force / (2 * S) * (1 - std::cosh(k * x) + std::sinh(k * x) * std::tanh(k * kLength / 4));
  };
  const auto tensionOf = [&](double S) {  // by the lengthening that tension S leaves
    constexpr int kSteps = 400;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double slope = slopeAt((i + 0.5) * kLength / 2 / kSteps, S);
      sum += 0.5 * slope * slope * kLength / 2 / kSteps;
    }
    return EA * 2 * sum / kLength;
  };
  double low = 1e-9 * EA, high = EA;
  for (int n = 0; n < 200; ++n) (tensionOf(std::sqrt(low * high)) > std::sqrt(low * high) ? low : high) = std::sqrt(low * high);
  const double S = low, k = std::sqrt(S / EI), x = kLength / 2;
  return force / (2 * S) * (x - std::sinh(k * x) / k + (std::cosh(k * x) - 1) * std::tanh(k * kLength / 4) / k);
}

double deflection(double force, double cell, Elements elements) {
  Joint joint;
  joint.id = joint.name = "band";
  scenes::addMaterials(joint);
  joint.materials[1].youngsModulus = kE;
  joint.materials[1].poissonRatio = 0;
  joint.materials[1].massDamping = 20;
  Part band = scenes::boxPart("band", 1, PartKind::Soft, {0, -kThickness / 2, -kWidth / 2}, {kLength, kThickness / 2, kWidth / 2});
  band.volume = std::make_shared<const TetMesh>(embedInCells(*band.visual, *band.collision, cell).value());
  band.cellSize = cell;
  for (const auto& [id, x] : {std::pair{"left", 0.0}, {"right", kLength}})
    band.regions.push_back(scenes::regionIn(band, id, Box3(Vec3(x - 1e-5, -1, -1), Vec3(x + 1e-5, 1, 1))));
  joint.parts = {band};
  Scenario scenario;
  scenario.id = scenario.name = "band";
  scenario.elements = elements;
  scenario.gravity_W.setZero();
  scenario.loadRise = 0.5;
  for (const char* end : {"left", "right"}) {
    Support clamp;
    clamp.part = "band";
    clamp.region = end;
    clamp.stiffnessPerArea = 1e3 * kE / cell;
    scenario.supports.push_back(clamp);
  }
  Load load;
  load.part = "band";
  load.force_W = Vec3(0, -force, 0);
  load.point_W = Vec3(kLength / 2, 0, 0);
  scenario.loads = {load};
  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  for (int i = 0; i < 1200; ++i) stepper.step({}, state);
  EXPECT_LT(state.v.cwiseAbs().maxCoeff(), 1e-5) << "not at rest";
  double sum = 0;
  int count = 0;
  const std::vector<Vec3>& nodes = model->objects[0].volume->nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (std::abs(nodes[i].x() - kLength / 2) < 1e-6) sum += state.q[3 * static_cast<int>(i) + 1] - nodes[i].y(), ++count;
  EXPECT_GT(count, 0);
  return -sum / count;
}

TEST(TightenedBand, theClosedFormIsTheBeamForSmallForces) {
  const double EI = kE * kWidth * std::pow(kThickness, 3) / 12;
  EXPECT_NEAR(closedForm(1e-4) / (1e-4 * std::pow(kLength, 3) / (192 * EI)), 1, 1e-3);
  EXPECT_LT(closedForm(4) / (4 * std::pow(kLength, 3) / (192 * EI)), 0.6) << "it tightens";
}

TEST(TightenedBand, cellsThickerThanItBendAndTightenAsItDoes) {
  for (const double force : {0.2, 1.0, 4.0}) {
    const double wanted = closedForm(force), coarse = deflection(force, 0.008, Elements::Cells), fine = deflection(force, 0.004, Elements::Cells),
                 tetrahedra = deflection(force, 0.008, Elements::Tetrahedra);
    std::printf("%.1f N: %.2f thicknesses; cells of 8 mm %.3f, of 4 mm %.3f, tetrahedra %.3f of it\n", force, wanted / kThickness, coarse / wanted,
                fine / wanted, tetrahedra / wanted);
    EXPECT_NEAR(coarse / wanted, 1, 0.1);
    EXPECT_NEAR(fine / wanted, 1, 0.06);
    EXPECT_LT(tetrahedra / wanted, 0.6);
  }
}

}  // namespace
}  // namespace glenoid::truth
