// SPDX-License-Identifier: GPL-3.0-or-later
// The gauntlet of `glenoid study stability` as a whole: what its table says, what its judge sees, and that scenes of ours come through.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/study/StabilityEnergy.h"
#include "simcore/study/StabilityStudy.h"
#include "tests/hard/HardScenes.h"

namespace glenoid::hard {
namespace {

bool isLong() {
  const char* wish = std::getenv("GLENOID_LONG");
  return wish && wish[0] == '1';
}

/// Glued to its plate: what nothing holds slides off and falls, and no bound speaks of that.
StabilityScene blockScene() {
  HardCase block = fingerOverBlock("block");
  couple(block.joint, "block", 1, 0, "plate", 1e5);
  Scenario scenario = block.scenario;
  scenario.elements = scenes::wishedElements();
  return stabilityScene(block.joint, scenario);
}

/// Runs it and expects every trial to hold but those named in `open`, which must be finite and take every step.
std::vector<StabilityVerdict> expectThrough(const StabilityScene& scene, const StabilityOptions& options, const std::set<std::string>& open = {}) {
  const auto verdicts = runStability(scene, options);
  EXPECT_TRUE(verdicts.ok());
  if (!verdicts) return {};
  for (const StabilityVerdict& verdict : *verdicts) {
    EXPECT_TRUE(verdict.figures.finite) << verdict.trial.id();
    EXPECT_EQ(verdict.figures.rejected, 0) << verdict.trial.id();
    if (open.count(verdict.trial.what->id)) continue;
    std::string broken;
    for (const std::string& word : verdict.broken) broken += " " + word;
    EXPECT_TRUE(verdict.held()) << verdict.trial.id() << ":" << broken << ", energy " << verdict.figures.energyExcess << ", depth "
                                << verdict.figures.depthShare << " of its bound, recovery " << verdict.figures.secondsToRest << " s";
  }
  return *verdicts;
}

TEST(HardGauntlet, everyCaseHasANameOfItsOwnAndIsTried) {
  std::set<std::string> ids;
  for (const StabilityCase& one : stabilityCases()) {
    EXPECT_TRUE(ids.insert(one.id).second) << one.id;
    EXPECT_EQ(findStabilityCase(one.id), &one);
  }
  const auto stage = StabilityStage::make(blockScene(), Profile::Direct);
  ASSERT_TRUE(stage.ok());
  std::set<std::string> tried, names;
  for (const StabilityTrial& trial : (*stage)->trials(false)) {
    tried.insert(trial.what->id);
    EXPECT_TRUE(names.insert(trial.id()).second) << trial.id();
  }
  // The block scene has no bone that moves.
  for (const char* bones : {"blow", "end-of-range"}) EXPECT_EQ(ids.erase(bones), 1u);
  EXPECT_EQ(tried, ids);
  EXPECT_EQ(findStabilityCase("nonsense"), nullptr);
}

TEST(HardGauntlet, aBlockUnderAFingerComesThrough) {
  StabilityOptions options;
  options.quick = !isLong();
  // Tissue of 50 Pa under its own 390 Pa: named, not judged by its rest.
  // Open (simcore/study/README): a finger of 100 N crushes elements of 2 cm through to the plate, and at 50 Pa it lies deep in the block.
  const auto verdicts = expectThrough(blockScene(), options, {"squeezed", "thousand-times-softer"});
  bool named = false;
  for (const StabilityVerdict& verdict : verdicts)
    if (std::string(verdict.trial.what->id) == "thousand-times-softer") named = named || verdict.carried.share > 1;
  EXPECT_TRUE(named);
}

TEST(HardGauntlet, threadsChangeNoFigure) {
  StabilityOptions options;
  options.quick = true;
  options.only = {"press", "mirrored", "random-loads", "wild-device"};
  options.threads = 1;
  const auto one = runStability(blockScene(), options);
  options.threads = 3;
  const auto three = runStability(blockScene(), options);
  ASSERT_TRUE(one.ok() && three.ok());
  const StudyTable a = stabilityTable(*one, options), b = stabilityTable(*three, options);
  EXPECT_GE(a.rows.size(), 5u);
  EXPECT_EQ(a.rows, b.rows);
}

TEST(HardGauntlet, theJudgeSeesWhatIsBroken) {
  StabilityRun run;
  run.bounds = kGauntletBounds;
  StabilityFigures good;
  good.steps = 100;
  EXPECT_TRUE(brokenBounds(run, good).empty());
  const auto broken = [&](auto change, bool carries = true) {
    StabilityFigures figures = good;
    change(figures);
    return brokenBounds(run, figures, carries);
  };
  using Words = std::vector<std::string>;
  EXPECT_EQ(broken([](auto& f) { f.finite = false; }), Words{"not-finite"});
  EXPECT_EQ(broken([](auto& f) { f.rejected = 1; }), Words{"rejected-steps"});
  EXPECT_EQ(broken([](auto& f) { f.energyExcess = 0.051; }), Words{"energy"});
  EXPECT_EQ(broken([](auto& f) { f.depthShare = 1.01; }), Words{"depth"});
  EXPECT_EQ(broken([](auto& f) { f.timeUp = true; }), Words{"time-up"});
  const auto restless = [](auto& f) { f.secondsToRest = 2.1, f.restSpeed = 0.1; };
  EXPECT_EQ(broken(restless), Words{"not-at-rest"});
  EXPECT_TRUE(broken(restless, false).empty()) << "matter that cannot carry itself need not come to rest";
  EXPECT_EQ(broken([](auto& f) { f.secondsToRest = 2.1, f.insideOutEnd = 3; }), Words{"inside-out"});
  EXPECT_EQ(broken([](auto& f) { f.secondsToRest = 2.1, f.depthShareEnd = 2; }), Words{"too-deep-at-end"});
}

TEST(HardGauntlet, theBooksSeeEnergyFromNowhere) {
  const HardCase block = fingerOverBlock("block");
  const auto model = compileModel(block.joint, block.scenario);
  ASSERT_TRUE(model.ok());
  State before = (*model)->start, after = before;
  const ObjectLayout& layout = (*model)->objects[1].layout;
  for (int node = 0; node < layout.nodeCount; ++node) after.v[layout.vOffset + 3 * node + 1] = 2;
  const double kinetic = 0.5 * (*model)->objects[1].mass * 4;
  EnergyBooks pushed(*model, before);
  pushed.push(before, after);  // somebody did that
  EXPECT_NEAR(pushed.work(), kinetic, 1e-9 * kinetic);
  EXPECT_NEAR(pushed.gained(), 0, 1e-9 * kinetic);
  EnergyBooks nobody(*model, before);
  nobody.push(after, after);  // nobody did
  EXPECT_NEAR(nobody.gained(), kinetic, 1e-9 * kinetic);
}

/// With loads, supports and pressures, whose work the books must know: what a step loses must be what backward Euler takes.
TEST(HardGauntlet, theBooksKnowLoadsSupportsAndPressures) {
  Joint joint = scenes::figure4Joint();
  Scenario scenario = scenes::figure4Scenario();
  scenario.loads = {{"right", Vec3(5, 3, -2), Vec3(0.01, 0, 0.02), Vec3(0.03, 0.01, 0.005)}};
  Part& soft = joint.parts[1];
  const Box3 bounds = boundsOf(*soft.visual);
  Vec3 low = bounds.min(), high = bounds.max();
  low.y() = high.y() - 1e-6;
  high.y() += 1e-6;
  low -= Vec3(1, 0, 1), high += Vec3(1, 0, 1);
  soft.regions.push_back(scenes::regionIn(soft, "top", Box3(low, high)));
  scenario.supports = {{soft.id, "top", {false, true, false}, 1e5, 1e-2}};
  scenario.pressures = {{soft.id, "top", 500}};
  for (const double dt : {1e-3, 5e-3}) {
    scenario.dt = dt;
    const auto model = compileModel(joint, scenario);
    ASSERT_TRUE(model.ok());
    StabilityRun run;
    run.model = *model;
    run.start = (*model)->start;
    run.seconds = 1;
    run.quiet = 0;
    const StabilityFigures figures = measureStability(run);
    EXPECT_LE(figures.energyExcess, 1e-3) << dt;  // the pressure follows the surface, which the step takes as it was
    EnergyBooks books(*model, (*model)->start);
    // All that was put in is there or was lost: an undamped long wave loses ½ Δvᵀ M Δv a step, so not everything.
    State state = (*model)->start, before = state;
    StepperOptions options;
    options.afterPart = [&](const State& now, double length) {
      books.add(before, now, length);
      before = now;
    };
    Stepper stepper(*model, options);
    stepper.step({}, state);
    EXPECT_GT(books.work(), 0) << dt;
    EXPECT_LT(books.gained(), 1e-12 * books.work()) << dt;
  }
}

/// What ships: two cases of a hand that goes wrong; all of the quick form with GLENOID_LONG=1, which takes many minutes.
TEST(HardGauntlet, shippedScenesComeThrough) {
  const std::string resources = GLENOID_SOURCE_DIR "/resources";
  StabilityOptions options;
  options.quick = true;
  if (!isLong()) options.only = {"silent-device", "hand-inside"};
  for (const auto& [scene, joint] : {std::pair{"arthroscopy", "shoulder"}, {"palpation", "shoulder-superficial"}})
    expectThrough(stabilityScene(loadJoint(resources + "/joints/" + joint + ".joint").value(),
                                 loadScenario(resources + "/scenarios/" + scene + ".scenario.json").value()),
                  options, {"fast-drag", "thousand-times-softer"});  // open: simcore/study/README
}

}  // namespace
}  // namespace glenoid::hard
