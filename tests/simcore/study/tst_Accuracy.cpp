// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/file/Json.h"
#include "simcore/study/accuracy/AccuracyShards.h"
#include "simcore/study/accuracy/AccuracyTables.h"
#include "simcore/study/accuracy/AccuracyTimes.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid::test {
namespace {

/// A soft bar between a fixed and a free block, let go under gravity: it swings, and nothing touches.
StudyScene swinging() { return {scenes::figure4Joint(), scenes::figure4Scenario(), {}}; }

/// A soft block that falls half a millimetre onto a plate, and a finger that comes down on it.
StudyScene pressed() {
  StudyScene scene{scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), {}};
  HandTrack track{"finger", {{0, scene.scenario.tools[0].home}, {0.4, scene.scenario.tools[0].home}, {0.8, scene.scenario.tools[0].home}}};
  track.keys[1].hand.p_WB = Vec3(0, 0.036, 0);
  scene.input.tracks = {track};
  scene.input.marks = {{"press", 0.3, 0.5, "finger", "block"}};
  return scene;
}

AccuracyOptions few(const StudyScene& scene, const std::vector<double>& times) {
  AccuracyOptions options;
  options.windows.count = 3;
  options.windows.seconds = 0.1;
  options.secondsTimed = 0.01;
  options.cells = {3.375, 8};  // from 8 bricks to 27 and 64
  options.cuts = {1, 1};
  const auto base = compileModel(scene.joint, scene.scenario).value();
  for (const double factor : times) {
    AccuracySetting setting = settingOf(*base);
    setting.dt *= factor;
    nameSetting(setting, settingOf(*base));
    options.settings.push_back(setting);
  }
  return options;
}

double displacement(const AccuracyRow& row, AccuracyAgainst against = AccuracyAgainst::OwnCells) {
  return (*row.errors[static_cast<std::size_t>(against)])[AccuracyQuantity::Displacement].value;
}

TEST(AccuracyStudy, theTimeStepConvergesWithTheFirstOrder) {
  const StudyScene scene = swinging();
  const AccuracyResult result = studyAccuracy(scene, few(scene, {1, 0.5, 0.25, 0.125})).value();
  ASSERT_EQ(result.rows.size(), 4u);
  // Against steps of 1/32: backward Euler's error is C (Δt − Δt/32) to the first order, so halves have 31/15, 15/7 and 7/3. The second order
  // shows at the largest steps.
  const double finest = 1.0 / 32;
  double step = 1;
  for (std::size_t k = 0; k + 1 < result.rows.size(); ++k, step /= 2) {
    const double expected = (step - finest) / (step / 2 - finest);
    EXPECT_NEAR(displacement(result.rows[k]) / displacement(result.rows[k + 1]), expected, 0.12 * expected) << result.rows[k].setting.id;
  }
  // The reference's own error, 1/16 against 1/32, is what the same line says.
  const double floor = result.reference(AccuracyAgainst::OwnCells).floor[AccuracyQuantity::Displacement].value;
  EXPECT_NEAR(displacement(result.rows[3]) / floor, (0.125 - finest) / finest, 0.15 * 3);
  EXPECT_GT(floor, 1e-9);
  // What is measured is the bar or what hangs on it, by a share of what it swings.
  EXPECT_GT(displacement(result.rows[0]), 1e-5);
  EXPECT_FALSE(result.friction);
}

/// What the study made of no reference of its own: a block that falls freely is, after a time T in steps of Δt, g T Δt/2 lower than
/// the parabola, whatever its elements; so the reference of Δt/32 is g T Δt/64 lower, and the rest is the error.
TEST(AccuracyStudy, theErrorOfAFreeFallIsTheClosedForm) {
  StudyScene scene{scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), {}};
  for (Material& material : scene.joint.materials) material.massDamping = material.stiffnessDamping = 0;
  scene.joint.exclusions.push_back({"block", "plate", "falls past it"});
  scene.scenario.tools.clear();
  const AccuracyOptions options = few(scene, {1, 0.5});
  const AccuracyResult result = studyAccuracy(scene, options).value();
  const double reference = scene.scenario.dt / 32, pull = scene.scenario.gravity_W.norm();
  for (const AccuracyRow& row : result.rows) {
    const double expected = 0.5 * pull * options.windows.seconds * (row.setting.dt - reference);
    const AccuracyError& error = (*row.errors[static_cast<std::size_t>(AccuracyAgainst::OwnCells)])[AccuracyQuantity::Displacement];
    EXPECT_NEAR(error.most, expected, 1e-6 * expected) << row.setting.id;
    EXPECT_EQ(error.where, "block");
    EXPECT_LT(error.value, error.most);
  }
}

TEST(AccuracyStudy, errorsRepeatBitForBit) {
  const StudyScene scene = pressed();
  AccuracyOptions options = few(scene, {1, 4});
  const AccuracyResult one = studyAccuracy(scene, options).value();
  options.repeats = 2;  // times are not part of it
  const AccuracyResult other = studyAccuracy(scene, options).value();
  ASSERT_EQ(one.rows.size(), other.rows.size());
  for (const AccuracyReference& reference : one.references) ASSERT_FALSE(reference.missing) << toLogLine(*reference.missing);
  for (std::size_t k = 0; k < one.rows.size(); ++k)
    for (std::size_t r = 0; r < kAccuracyReferences; ++r) {
      ASSERT_TRUE(one.rows[k].errors[r] && other.rows[k].errors[r]);
      for (std::size_t q = 0; q < kAccuracyQuantities; ++q) {
        EXPECT_EQ(one.rows[k].errors[r]->by[q].value, other.rows[k].errors[r]->by[q].value);
        EXPECT_EQ(one.rows[k].errors[r]->by[q].most, other.rows[k].errors[r]->by[q].most);
        EXPECT_EQ(one.rows[k].errors[r]->by[q].where, other.rows[k].errors[r]->by[q].where);
      }
    }
  for (std::size_t r = 0; r < kAccuracyReferences; ++r)
    for (std::size_t q = 0; q < kAccuracyQuantities; ++q)
      EXPECT_EQ(one.references[r].floor.by[q].value, other.references[r].floor.by[q].value);
  // There is something to repeat: both press, and the hand feels it.
  EXPECT_GT((*one.rows[1].errors[1])[AccuracyQuantity::HandForce].value, 0);
  EXPECT_GT((*one.rows[1].errors[1])[AccuracyQuantity::ContactForce].value, 0);
  EXPECT_GT((*one.rows[0].errors[0])[AccuracyQuantity::Displacement].value, displacement(one.rows[0]));  // coarse cells leave out more than the step
}

TEST(AccuracyStudy, aSettingThatCannotBeBuiltKeepsItsRowWithTheReason) {
  const StudyScene scene = pressed();
  // A block of eight bricks cannot be cut into sixteen.
  AccuracyOptions options = few(scene, {1, 1});
  options.cells = {2, 3.375};
  options.settings[1].cells = 2;
  nameSetting(options.settings[1], options.settings[0]);
  const AccuracyResult result = studyAccuracy(scene, options).value();
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_EQ(result.rows[1].setting.id, "cells=2");
  EXPECT_EQ(result.rows[1].failure.reason, "not-built");
  EXPECT_EQ(result.rows[1].failure.error.fault, Fault::Unusable);
  EXPECT_FALSE(errorIn(result.rows[1], {}));
  EXPECT_TRUE(result.reference(AccuracyAgainst::FinerCells).missing);
  EXPECT_FALSE(result.rows[0].errors[0]);
  EXPECT_GT(displacement(result.rows[0]), 0);
  const StudyTable table = accuracyTables(result).front();
  ASSERT_EQ(table.rows.size(), 2u);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(std::get<std::string>(table.rows[1][2]), "not-built");
  EXPECT_NE(std::get<std::string>(table.rows[1][3]).find("no cell size"), std::string::npos);
}

TEST(AccuracyShards, mergedTheyAreTheWholeStudyBitForBit) {
  const StudyScene scene = pressed();
  AccuracyOptions options = few(scene, {1, 4, 2});
  options.settings.push_back(options.settings[0]);
  options.settings[3].cells = 2;  // cannot be built
  nameSetting(options.settings[3], options.settings[0]);
  const AccuracyResult whole = studyAccuracy(scene, options).value();
  const AccuracySetting base = options.settings[0];
  std::vector<AccuracyResult> shards;
  for (const int shard : {2, 1}) {
    options.shards = 2;
    options.shard = shard;
    options.machine = shard == 1 ? "one" : "other";
    // As it comes back from a file.
    const std::string text = toText(toJson(studyAccuracy(scene, options).value()));
    shards.push_back(accuracyResult(parseJson(text, "shard").value(), base, options.settings).value());
  }
  const AccuracyResult merged = mergedShards(shards, 4).value();
  ASSERT_EQ(merged.rows.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(merged.rows[k].setting.id, whole.rows[k].setting.id);
    EXPECT_EQ(merged.rows[k].machine, k % 2 ? "other" : "one");
    EXPECT_EQ(merged.rows[k].failure.reason, whole.rows[k].failure.reason);
    EXPECT_EQ(merged.rows[k].timed, whole.rows[k].timed);
  }
  EXPECT_EQ(merged.rows[3].failure.reason, "not-built");
  EXPECT_EQ(toLogLine(merged.rows[3].failure.error), toLogLine(whole.rows[3].failure.error));
  // Everything that is no time: a table of both, without the columns of milliseconds and machines.
  StudyTable a = accuracyTables(whole)[0], b = accuracyTables(merged)[0];
  for (std::size_t c = 0; c < a.columns.size(); ++c) {
    const std::string& column = a.columns[c];
    if (column.rfind("step", 0) == 0 || column.rfind("wall", 0) == 0 || column.rfind("work", 0) == 0 || column.rfind("front", 0) == 0 || column == "machine") continue;
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(a.rows[k][c], b.rows[k][c]) << column << " of " << whole.rows[k].setting.id;
  }
  EXPECT_EQ(accuracyTables(whole)[1].rows, accuracyTables(merged)[1].rows);
  EXPECT_EQ(accuracyTables(whole)[2].rows, accuracyTables(merged)[2].rows);

  // One alone, one twice, one of another scene or build, and one of other settings are refused.
  EXPECT_EQ(mergedShards(std::span(shards).first(1), 4).error().fault, Fault::Unusable);
  const std::vector<AccuracyResult> twice{shards[0], shards[1], shards[0]};
  EXPECT_EQ(mergedShards(twice, 4).error().fault, Fault::Unusable);
  std::vector<AccuracyResult> other = shards;
  other[1].references[1].floor.by[0].value = std::nextafter(other[1].references[1].floor.by[0].value, 1);
  EXPECT_EQ(mergedShards(other, 4).error().fault, Fault::Unusable);
  options.settings.resize(2);
  EXPECT_EQ(accuracyResult(toJson(whole), base, options.settings).error().fault, Fault::Unusable);
  EXPECT_EQ(accuracyResult(JsonValue::object(), base, options.settings).error().fault, Fault::Unusable);
}

TEST(AccuracyStudy, theSweepNamesEachSettingOnceAndBeginsWithTheScene) {
  const StudyScene scene = pressed();
  const auto base = compileModel(scene.joint, scene.scenario).value();
  const std::vector<AccuracySetting> settings = accuracySettings(*base, false), quick = accuracySettings(*base, true);
  EXPECT_LT(quick.size(), settings.size());
  EXPECT_EQ(settings.front().id, "scene");
  std::map<std::string, int> ids, families;
  for (const AccuracySetting& setting : settings) {
    EXPECT_EQ(++ids[setting.id], 1) << setting.id;
    ++families[setting.family];
    EXPECT_TRUE(compileModel(scene.joint, scenarioWith(setting, scene.scenario))) << setting.id;
  }
  for (const char* family : {"time-step", "profile", "elements", "cells", "surfaces", "contact", "paper"}) EXPECT_GE(families[family], 1) << family;
  // A state's time must be a whole number of every step.
  for (const AccuracySetting& setting : settings) {
    const double steps = 4 * scene.scenario.dt / setting.dt;
    EXPECT_NEAR(steps, std::round(steps), 1e-9) << setting.id;
  }
  EXPECT_EQ(ids.count("dt=2.5ms"), 1u);
  EXPECT_EQ(ids.count("cells=2,dt=10ms"), 1u);
  EXPECT_EQ(ids.count("profile=paper,cg-tolerance=1e-04"), 1u);
}

TEST(AccuracyWindows, lieApartOnTheGridAndHoldTheStatesOfTheRun) {
  const StudyScene scene = pressed();
  const auto model = compileModel(scene.joint, scene.scenario).value();
  WindowWishes wishes;
  wishes.count = 4;
  wishes.seconds = 0.1;
  const std::vector<AccuracyWindow> windows = findWindows(scene, model, wishes).value();
  ASSERT_EQ(windows.size(), 4u);
  double loaded = 0, moving = 0;
  for (std::size_t k = 0; k < windows.size(); ++k) {
    EXPECT_NEAR(windows[k].time / wishes.grid, std::round(windows[k].time / wishes.grid), 1e-9);
    if (k > 0) EXPECT_GE(windows[k].time - windows[k - 1].time, wishes.seconds - 1e-9);
    (windows[k].loaded ? loaded : moving) += 1;
    // The state is where the run from the start comes by.
    Stepper stepper(model, {});
    State state = model->start;
    Inputs inputs;
    while (state.time < windows[k].time - 1e-9) {
      handsAt(scene.scenario, &scene.input, static_cast<double>(state.step + 1) * scene.scenario.dt, inputs.hands);
      stepper.step(inputs, state);
    }
    EXPECT_EQ(toHex(stateHash(state)), toHex(stateHash(windows[k].state)));
  }
  EXPECT_GE(loaded, 1);
  EXPECT_GE(moving, 1);
  // A run of 0.8 s has no window of a second in it.
  wishes.seconds = 1;
  wishes.idleSeconds = 0.5;
  EXPECT_EQ(findWindows(scene, model, wishes).error().fault, Fault::Unusable);
  EXPECT_EQ(findWindows(scene, model, {}, [](double) { return false; }).error().fault, Fault::Cancelled);
}

TEST(AccuracyTrace, aHandFeelsWhatItsToolPressesAndThePlateTheBlocksWeightWithIt) {
  StudyScene scene = pressed();
  scene.input.tracks[0].keys.pop_back();  // the finger stays down
  const auto model = compileModel(scene.joint, scene.scenario).value();
  WindowWishes wishes;
  wishes.count = 1;
  wishes.seconds = 0.1;
  AccuracyWindow window;  // the run, played until all is at rest
  window.state = model->start;
  Stepper stepper(model, {});
  Inputs inputs;
  for (int s = 0; s < 800; ++s) {
    handsAt(scene.scenario, &scene.input, static_cast<double>(window.state.step + 1) * scene.scenario.dt, inputs.hands);
    stepper.step(inputs, window.state);
  }
  window.time = window.state.time;
  AccuracyPlayer player(model, model, {}, scene.input);
  const AccuracyTrace trace = player.play(window, wishes);
  ASSERT_EQ(trace.samples.size(), 5u);
  const double block = 1000 * 0.04 * 0.04 * 0.04 * 9.81;
  for (const AccuracySample& sample : trace.samples) {
    // Objects: plate, block, finger; tools weigh nothing. At rest to what four seconds leave of the swing.
    const Vec3 onBlock = sample.pairForces[1 * 3 + 2];
    EXPECT_LT(onBlock.y(), -0.1);
    EXPECT_LT((sample.handForces[0] + onBlock).norm(), 1e-4 * onBlock.norm());
    EXPECT_NEAR(sample.pairForces[0 * 3 + 1].y(), onBlock.y() - block, 1e-4 * block);
  }
}

TEST(AccuracyErrors, areRootMeanSquaresOfTheWorstObject) {
  const StudyScene scene = pressed();
  const auto model = compileModel(scene.joint, scene.scenario).value();
  AccuracyTrace zero;
  for (int k = 0; k < 2; ++k) {
    AccuracySample& sample = zero.samples.emplace_back();
    sample.places = {{}, {Vec3::Zero(), Vec3::Zero()}, {Vec3::Zero()}};
    sample.pairForces.assign(9, Vec3::Zero());
    sample.handForces.assign(1, Vec3::Zero());
  }
  zero.depths.assign(9, 0.0);
  AccuracyTrace off = zero;
  off.samples[0].places[1][0] = Vec3(0, 3e-3, 4e-3);       // 5 mm of four places of the block: 2.5 mm
  off.samples[1].places[2][0] = Vec3(2e-3, 0, 0);          // 2 mm of two of the finger: 1.41 mm
  off.samples[1].pairForces[1 * 3 + 2] = Vec3(0, -4, 0);   // 4 N of two moments: 2.83 N
  off.samples[0].handForces[0] = off.samples[1].handForces[0] = Vec3(1, 0, 0);
  off.depths[1] = 1e-3;
  const std::vector<AccuracyTrace> traces{off}, reference{zero};
  const AccuracyErrors errors = errorsOf(*model, traces, reference);
  EXPECT_DOUBLE_EQ(errors[AccuracyQuantity::Displacement].value, 2.5e-3);
  EXPECT_DOUBLE_EQ(errors[AccuracyQuantity::Displacement].most, 5e-3);
  EXPECT_EQ(errors[AccuracyQuantity::Displacement].where, "block");
  EXPECT_DOUBLE_EQ(errors[AccuracyQuantity::ContactForce].value, 4 / std::sqrt(2.0));
  EXPECT_EQ(errors[AccuracyQuantity::ContactForce].where, "block / finger");
  EXPECT_DOUBLE_EQ(errors[AccuracyQuantity::HandForce].value, 1);
  EXPECT_EQ(errors[AccuracyQuantity::HandForce].where, "finger");
  EXPECT_DOUBLE_EQ(errors[AccuracyQuantity::Penetration].value, 1e-3);
  EXPECT_EQ(errors[AccuracyQuantity::Penetration].where, "plate / block");
  // A second window in which nothing is off halves the squares.
  const std::vector<AccuracyTrace> two{off, zero}, still{zero, zero};
  EXPECT_DOUBLE_EQ(errorsOf(*model, two, still)[AccuracyQuantity::Displacement].value, 2.5e-3 / std::sqrt(2.0));
}

TEST(AccuracyTimes, everyRepeatCountsAndPercentilesAscend) {
  const StudyScene scene = pressed();
  AccuracyOptions options = few(scene, {1, 0.5});
  options.secondsTimed = 10;  // all windows
  const AccuracyResult result = studyAccuracy(scene, options).value();
  for (const AccuracyRow& row : result.rows) {
    EXPECT_EQ(row.timed, 7L * 3 * options.stepsTimed);
    EXPECT_GT(row.cpu.median, 0);
    EXPECT_LE(row.cpu.median, row.cpu.p95);
    EXPECT_LE(row.cpu.p95, row.cpu.p99);
    // As much simulated time as a step of the scene takes two of half the length.
    EXPECT_DOUBLE_EQ(row.work.median, row.cpu.median * scene.scenario.dt / row.setting.dt);
  }
}

/// Rows with given work and displacement, compared in all of four windows.
AccuracyResult made(const std::vector<std::array<double, 2>>& workAndError, double floor) {
  AccuracyResult result;
  result.windows.resize(4);
  for (const auto& [work, error] : workAndError) {
    AccuracyRow& row = result.rows.emplace_back();
    row.windows = 4;
    row.timed = 100;
    row.work.median = work;
    row.work.p95 = 1.5 * work;
    row.errors[1].emplace();
    row.errors[1]->by[0].value = error;
    row.setting.id = std::to_string(result.rows.size());
  }
  result.references[1].floor.by[0].value = floor;
  return result;
}

TEST(AccuracyPick, takesTheMostAccurateThatFitsAndTheFastestThatIsAccurate) {
  const AccuracyResult result = made({{4, 1e-4}, {2, 2e-4}, {1, 8e-4}, {3, 9e-4}, {0.5, 5e-3}}, 1e-5);
  EXPECT_EQ(pickForBudget(result, {}, 3), 1u);     // p95 is half as much again as the median
  EXPECT_EQ(pickForBudget(result, {}, 2.9), 2u);
  EXPECT_EQ(pickForBudget(result, {}, 100), 0u);
  EXPECT_EQ(pickForBudget(result, {}, 0.7), std::nullopt);
  EXPECT_EQ(pickForAccuracy(result, {}, 1e-3), 2u);
  EXPECT_EQ(pickForAccuracy(result, {}, 8e-4), 2u);
  EXPECT_EQ(pickForAccuracy(result, {}, 7.9e-4), 1u);
  EXPECT_EQ(pickForAccuracy(result, {}, 5e-5), std::nullopt);
  EXPECT_DOUBLE_EQ(leastAccuracy(result, {}), 2e-5);
  EXPECT_EQ(paretoFront(result, {}), (std::vector<std::size_t>{4, 2, 1, 0}));
}

TEST(AccuracyPick, belowTheReferencesOwnErrorTheFasterIsTaken) {
  const AccuracyResult result = made({{4, 1e-6}, {2, 9e-6}, {1, 8e-4}}, 1e-5);
  EXPECT_EQ(pickForBudget(result, {}, 100), 1u);
}

TEST(AccuracyPick, leavesOutWhatFailedWhatNoFileSaysAndWhatWasComparedInFewWindows) {
  AccuracyResult result = made({{4, 1e-4}, {2, 2e-4}, {1, 3e-4}, {0.5, 4e-4}}, 1e-6);
  result.rows[1].failure = {"diverged", {}, 1, 100};
  result.rows[2].windows = 3;
  result.rows[3].setting.profile = Profile::Paper;
  EXPECT_EQ(pickForAccuracy(result, {}, 1e-3), 3u);  // `paper` as published stands in a scenario
  result.rows[3].setting.paperLimits.innerSweeps = 5;
  EXPECT_EQ(pickForAccuracy(result, {}, 1e-3), 0u);
  EXPECT_EQ(paretoFront(result, {}), (std::vector<std::size_t>{3, 0}));
  result.rows[0].setting.visualContact = true;
  EXPECT_EQ(paretoFront(result, {}), (std::vector<std::size_t>{3}));
  result.rows[0].setting.visualContact = false;
  result.rows[3].errors[1]->by[0].value = std::nan("");
  EXPECT_EQ(paretoFront(result, {}), (std::vector<std::size_t>{0}));
  EXPECT_EQ(pickForBudget(result, {}, 100), 0u);
}

}  // namespace
}  // namespace glenoid::test
