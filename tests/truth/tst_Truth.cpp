// SPDX-License-Identifier: GPL-3.0-or-later
// Problems with known answers (simcore/study/truth), the same that `glenoid study truth` runs: the short
// form, the full one with GLENOID_LONG=1.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

#include "simcore/reading/StressRecovery.h"
#include "simcore/step/StepModel.h"
#include "simcore/study/truth/Membranes.h"
#include "simcore/study/truth/TruthRun.h"
#include "simcore/study/truth/TruthStudy.h"
#include "tests/truth/Calculix.h"

namespace glenoid::truth {
namespace {

class Known : public testing::TestWithParam<const char*> {};

TEST_P(Known, isWithinItsBarAndItsErrorsFall) {
  TruthOptions options;
  // Those with published values always at their full sizes, within their full bars; what else there is where there is time.
  const std::set<std::string> published = {"cook", "le1", "le10", "fv32"};
  options.quick = !std::getenv("GLENOID_LONG") && !published.contains(GetParam());
  options.only = {GetParam()};
  const auto verdicts = runTruth(options).value();
  ASSERT_FALSE(verdicts.empty());
  for (const TruthVerdict& verdict : verdicts) {
    std::printf("%s, %s:", verdict.problem->id, elementsWord(verdict.elements));
    for (const TruthPoint& point : verdict.points)
      std::printf(" %g: %.6g, off by %.3g (%.1f s)", point.size, point.found.value, point.found.error,
                  point.seconds);
    std::printf("; order %.2f\n", verdict.order);
    EXPECT_TRUE(verdict.withinBar) << verdict.points.back().failure << " bar " << verdict.bar;
    EXPECT_TRUE(verdict.orderHeld) << verdict.order << " of " << verdict.orderBar;
  }
}

std::vector<const char*> ids() {
  std::vector<const char*> list;
  for (const TruthProblem& problem : truthProblems()) list.push_back(problem.id);
  return list;
}
INSTANTIATE_TEST_SUITE_P(Truth, Known, testing::ValuesIn(ids()));

TEST(TruthStudy, hasAtLeastTwelveProblemsAndSaysWhyOneHasNoScene) {
  EXPECT_GE(truthProblems().size(), 12u);
  for (const TruthProblem& problem : truthProblems()) {
    EXPECT_EQ(findTruthProblem(problem.id), &problem) << problem.id;
    EXPECT_EQ(problem.scene == nullptr, *problem.noScene != 0) << problem.id;
    EXPECT_LE(problem.quick, problem.sizes.size()) << problem.id;
    for (std::size_t k = 1; k < problem.sizes.size(); ++k)
      EXPECT_LT(problem.sizes[k], problem.sizes[k - 1]) << problem.id;
  }
}

TEST(TruthStudy, whatIsWrongIsMissed) {
  // Tissue nine tenths as stiff as it should be, in a static problem of one body and in one of whole steps.
  TruthOptions options;
  options.quick = true;
  options.elements = Elements::Cells;
  options.only = {"cook", "hanging-bar"};
  options.stiffness = 0.9;
  for (const TruthVerdict& verdict : runTruth(options).value()) {
    EXPECT_FALSE(verdict.met()) << verdict.problem->id;
    EXPECT_NEAR(verdict.points.back().found.error, 1 / 0.9 - 1, 0.03) << verdict.problem->id;
  }
}

TEST(TruthStudy, anUnknownProblemIsRefused) {
  TruthOptions options;
  options.only = {"cook", "cooks"};
  const auto verdicts = runTruth(options);
  ASSERT_FALSE(verdicts);
  EXPECT_EQ(verdicts.error().fault, Fault::UnknownId);
}

TEST(TruthStudy, anyNumberOfThreadsGivesTheSameBits) {
  TruthOptions options;
  options.quick = true;
  options.only = {"cook", "spring-pair"};
  const auto one = runTruth(options).value();
  options.threads = 3;
  const auto three = runTruth(options).value();
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t v = 0; v < one.size(); ++v)
    for (std::size_t k = 0; k < one[v].points.size(); ++k)
      EXPECT_EQ(one[v].points[k].found.value, three[v].points[k].found.value);
}

/// σ_yy at a place of the scene's only part, after its run has come to rest, Pa.
double stressInRun(const TruthScene& scene, const TruthSetup& setup, const Vec3& place) {
  const auto made = TruthRun::make(scene, setup);
  EXPECT_TRUE(made);
  TruthRun& run = **made;
  EXPECT_TRUE(run.run(3));
  const auto& soft = dynamic_cast<const SoftObject&>(*run.model().inside->objects[0]);
  std::vector<ElementReading> readings;
  soft.readSamples(run.state, readings);
  return recovered(recoveryWeights(soft.samples(), place, recoveryReach(*run.model().objects[0].volume)),
                   readings)
      .stress_W(1, 1);
}

TEST(TruthStudy, theScenesOfNafemsRestWhereTheStaticSolvesSay) {
  for (const Elements kind : {Elements::Tetrahedra, Elements::Cells}) {
    const TruthSetup setup{kind};
    EXPECT_NEAR(stressInRun(ellipticMembraneScene(setup, 0.25), setup, {2, 0, 0.05}) /
                    ellipticMembrane(setup, 0.25).value().value,
                1, 0.01);
    // Its outer surface is held inside cells, by other points of it than the static solve has: up to 3.6 % in
    // cells so coarse.
    EXPECT_NEAR(
        stressInRun(thickPlateScene(setup, 0.25), setup, {2, 0, 0.6}) / thickPlate(setup, 0.25).value().value,
        1, 0.05);
  }
}

TEST(Truth, anotherProgramHasTheSameStressOfBothRings) {
  NEEDS_CALCULIX()
  const auto le1 = stressByCalculix(ellipticMembraneBricks(), 1, 0, 0),
             le10 = stressByCalculix(thickPlateBricks(), 1, 0, 1);
  ASSERT_TRUE(le1 && le10);
  std::printf("CalculiX: LE1 %.3f of 92.7 MPa, LE10 %.3f of −5.38 MPa\n", (*le1)(1, 1) / kLe1Stress,
              (*le10)(1, 1) / kLe10Stress);
  EXPECT_NEAR((*le1)(1, 1) / kLe1Stress, 1, 0.01);
  EXPECT_NEAR((*le10)(1, 1) / kLe10Stress, 1, 0.03);
  const TruthSetup setup{Elements::Cells};
  EXPECT_NEAR(ellipticMembrane(setup, 0.0625).value().value / (*le1)(1, 1), 1, 0.02);
  EXPECT_NEAR(thickPlate(setup, 0.25 / 3).value().value / (*le10)(1, 1), 1, 0.05);
}

TEST(Truth, taperedMembraneOfNafemsFv32HasItsFirstSixFrequencies) {
  for (const Elements kind : {Elements::Tetrahedra, Elements::Cells}) {
    const std::vector<double> found = taperedMembrane({kind}, 0.25, 6);
    ASSERT_EQ(found.size(), 6u);
    // None is missed and none is extra.
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(found[i] / kFv32Frequencies[i], 1, kind == Elements::Cells ? 0.006 : 0.045) << i;
  }
}

}  // namespace
}  // namespace glenoid::truth
