// SPDX-License-Identifier: GPL-3.0-or-later
// The trainings that ship: a sure pair of hands does all of it and passes, with nothing to be said against the run; hands that
// tremble and wander score less. GLENOID_LONG=1 takes twenty of each kind.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "simcore/live/Run.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ResourcePaths.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/train/DisturbedHands.h"

namespace glenoid {
namespace {

const std::string kResources = GLENOID_SOURCE_DIR "/resources";

struct ShippedTraining {
  explicit ShippedTraining(const std::string& name) {
    const std::string path = kResources + "/scenarios/" + name + ".scenario.json";
    scenario = loadScenario(path).value();
    joint = loadJoint(resolveJoint(scenario.joint, folderOf(path), kResources).value()).value();
    model = compileModel(joint, scenario).value();
    input = loadRecording(resolveRecording(scenario.input, folderOf(path), kResources).value()).value();
  }
  RunReport with(const Recording& hands, bool checks) const {
    RunOptions options;
    options.seconds = inputSeconds(hands);
    options.input = &hands;
    options.checks = checks;
    options.visualEvery = 0;
    return runScenario(model, options).value().report;
  }
  Scenario scenario;
  Joint joint;
  std::shared_ptr<const Model> model;
  Recording input;
};

/// What the recorded hands come to, checked; run once for all tests.
const RunReport& bySureHands(const std::string& name) {
  static std::map<std::string, RunReport> reports;
  auto found = reports.find(name);
  if (found == reports.end()) {
    const ShippedTraining training(name);
    found = reports.emplace(name, training.with(training.input, true)).first;
  }
  return found->second;
}

class Shipped : public testing::TestWithParam<const char*> {};

TEST_P(Shipped, sureHandsDoAllOfItAndNothingIsToBeSaidAgainstTheRun) {
  const ShippedTraining training(GetParam());
  EXPECT_TRUE(checkScenario(training.scenario, training.joint, Place{}));
  const RunReport& report = bySureHands(GetParam());
  ASSERT_TRUE(report.training);
  for (const TaskResult& task : report.training->tasks) EXPECT_EQ(task.record.outcome, TaskOutcome::Done) << task.id;
  EXPECT_TRUE(report.training->passed) << report.training->score;
  EXPECT_GE(report.training->score, 80);
  for (const Notice& notice : report.notices) ADD_FAILURE() << noticeName(notice.kind) << " " << notice.subject << " " << notice.other;
}

INSTANTIATE_TEST_SUITE_P(Trainings, Shipped, testing::Values("tour", "landmarks"));

TEST(Tour, hasTenStructuresEachBySomeOtherNameAndPlace) {
  const ShippedTraining tour("tour");
  std::set<std::string> names, places;
  for (const Task& task : tour.scenario.training.tasks) {
    names.insert(task.name);
    places.insert(task.places[0].part + "/" + task.places[0].region);
    EXPECT_FALSE(task.text.empty()) << task.id;
  }
  EXPECT_GE(names.size(), 10u);
  EXPECT_EQ(names.size(), places.size());
}

TEST(Tour, carefulHandsScoreMoreThanClumsyOnes) {
  const ShippedTraining tour("tour");
  const int count = std::getenv("GLENOID_LONG") ? 20 : 1;
  const auto scores = [&](double size, std::uint64_t seed) {
    double sum = 0, squares = 0;
    for (int i = 0; i < count; ++i) {
      const double score = tour.with(disturbedHands(tour.input, {size, size, seed + static_cast<std::uint64_t>(i)}), false).training.value().score;
      sum += score, squares += score * score;
    }
    const double mean = sum / count;
    return std::pair(mean, count > 1 ? std::sqrt(std::max(0.0, (squares - count * mean * mean) / (count - 1))) : 0.0);
  };
  // The recorded hands stand for careful ones where there is time for one of each only.
  const auto [careful, sdCareful] = count > 1 ? scores(2e-4, 10) : std::pair(bySureHands("tour").training.value().score, 0.0);
  const auto [clumsy, sdClumsy] = scores(2.5e-3, 500);
  std::printf("careful %.1f ± %.1f, clumsy %.1f ± %.1f\n", careful, sdCareful, clumsy, sdClumsy);
  EXPECT_GT(careful, clumsy + 10);
  EXPECT_GE(careful - clumsy, 2 * std::max(sdCareful, sdClumsy));
}

}  // namespace
}  // namespace glenoid
