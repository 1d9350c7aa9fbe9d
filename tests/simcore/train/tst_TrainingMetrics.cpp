// SPDX-License-Identifier: GPL-3.0-or-later
// Metrics made again from the raw table by arithmetic of its own; the same on replay; less sure hands score worse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <sstream>

#include "simcore/train/DisturbedHands.h"
#include "tests/simcore/train/TrainingScenes.h"

namespace glenoid {
namespace {

using namespace scenes;

/// A look, three touches, a press in a band and a path, by two hands.
Scenario exercise() {
  Scenario scenario = slabScenario();
  Task look = taskAt("look", TaskKind::Look, "left");
  look.angle = 0.8;
  Task press = taskAt("press", TaskKind::Press, "right");
  press.forceMin = 0.5;
  press.forceMax = 4;
  press.hold = 0.4;
  Task trace = taskAt("trace", TaskKind::Trace, "right");
  trace.places.push_back(taskAt("", TaskKind::Trace, "middle").places[0]);
  trace.forceMax = 4;
  Task left = taskAt("left", TaskKind::Touch, "left"), middle = taskAt("middle", TaskKind::Touch, "middle");
  left.forceMax = middle.forceMax = 4;
  left.hold = middle.hold = 0.3;
  scenario.training.tasks = {look, left, middle, press, trace};
  scenario.training.limits = {{"gentle", "Gently", "slab", "", 3.5}};
  scenario.training.form = {{"tasks", 30, 1, 0}, {"errors", 20, 0, 30}, {"finger.economy", 30, 0.75, 0}, {"finger.jerk", 20, 21, 26}};
  return scenario;
}

Recording sure(const Scenario& scenario) {
  const Vec3 left(-0.03, 0, 0), middle(0, 0, 0), right(0.03, 0, 0), up(0, 0.01, 0), in(0, -2.0 / 800, 0);
  Recording input;
  input.tracks = {handThrough(scenario, "finger",
                              {{left + up, 1}, {left + in, 0.6, 0.6}, {left + up, 0.6}, {middle + up, 1}, {middle + in, 0.6, 0.6}, {middle + up, 0.6},
                               {right + up, 1}, {right + in, 0.6, 0.8}, {middle + in, 2, 0.5}, {middle + up, 0.6}}),
                  handThrough(scenario, "scope", {{Vec3(-0.03, 0.03, 0), 3, 7}})};
  return input;
}

/// The table by column.
struct Table {
  std::map<std::string, std::vector<double>> column;
  explicit Table(const std::string& csv) {
    std::istringstream lines(csv);
    std::string line, cell;
    std::vector<std::string> names;
    for (bool head = true; std::getline(lines, line); head = false) {
      std::istringstream cells(line);
      for (std::size_t c = 0; std::getline(cells, cell, ','); ++c) {
        if (head) names.push_back(cell);
        else column[names.at(c)].push_back(std::strtod(cell.c_str(), nullptr));
      }
    }
  }
  const std::vector<double>& operator[](const std::string& name) const { return column.at(name); }
};

double lengthBetween(const Table& t, const std::string& id, std::size_t a, std::size_t b) {
  return std::hypot(t[id + ".x"][b] - t[id + ".x"][a], t[id + ".y"][b] - t[id + ".y"][a], t[id + ".z"][b] - t[id + ".z"][a]);
}

/// Written from README.md's definitions, apart from Trail.cpp: sums over axes one by one.
double jerkAgain(const Table& t, const std::string& id, double dt) {
  const double sigma = 0.8325546111576977 / (20 * 3.141592653589793);
  const std::size_t all = t["time"].size();
  std::size_t reach = 0;
  while (static_cast<double>(reach + 1) * dt <= 4 * sigma) ++reach;
  const std::size_t n = all - 2 * reach;
  double squared = 0;
  std::vector<double> square(n, 0);
  for (const char* axis : {".x", ".y", ".z"}) {
    const std::vector<double>& raw = t[id + axis];
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0, weight = 0;
      for (std::size_t k = 0; k < all; ++k) {
        const double away = std::abs(static_cast<double>(k) - static_cast<double>(i + reach)) * dt;
        if (away > 4 * sigma) continue;
        const double w = std::exp(-away * away / (2 * sigma * sigma));
        sum += w * raw[k], weight += w;
      }
      x[i] = sum / weight;
    }
    for (std::size_t i = 2; i + 2 < n; ++i) squared += std::pow((x[i + 2] - 2 * x[i + 1] + 2 * x[i - 1] - x[i - 2]) / (2 * dt * dt * dt), 2) * dt;
    for (std::size_t i = 2; i + 3 < n; ++i) square[i] += std::pow(x[i + 1] - x[i], 2);
  }
  double length = 0;
  for (const double value : square) length += std::sqrt(value);
  const double time = static_cast<double>(n - 5) * dt;
  return std::log(squared * std::pow(time, 5) / (length * length));
}

TEST(TrainingMetrics, comeOutAgainFromTheRawTable) {
  const Scenario scenario = exercise();
  const RunResult result = trainingRun(scenario, disturbedHands(sure(scenario), {1.2e-3, 2e-3, 3}), true);
  ASSERT_TRUE(result.report.training);
  const TrainingReport& report = *result.report.training;
  const Table t(result.trainingTrace);
  const double dt = scenario.dt;
  const std::size_t n = t["time"].size();
  ASSERT_GT(n, 1000u);
  EXPECT_NEAR(*report.value("time"), t["time"].back() - t["time"].front(), 1e-9);
  for (const std::string id : {"finger", "scope"}) {
    double path = 0, most = 0, sum = 0, touch = 0;
    for (std::size_t i = 1; i < n; ++i) {
      path += lengthBetween(t, id, i - 1, i);
      const double force = std::hypot(t[id + ".fx"][i], t[id + ".fy"][i], t[id + ".fz"][i]);
      most = std::max(most, force);
      if (force > 0.1) touch += dt, sum += force * dt;
    }
    EXPECT_NEAR(*report.value(id + ".path"), path, 1e-9 * path);
    EXPECT_NEAR(*report.value(id + ".speed"), path / *report.value("time"), 1e-9);
    EXPECT_NEAR(*report.value(id + ".forceMax"), most, 1e-9);
    EXPECT_NEAR(*report.value(id + ".touchSeconds"), touch, 1e-9);
    if (touch > 0) { EXPECT_NEAR(*report.value(id + ".forceMean"), sum / touch, 1e-9); }
    EXPECT_NEAR(*report.value(id + ".jerk"), jerkAgain(t, id, dt), 1e-6);
  }
  double turned = 0;
  for (std::size_t i = 1; i < n; ++i)
    for (const char* axis : {"scope.ax", "scope.ay", "scope.az"}) turned += std::pow((t[axis][i] - t[axis][i - 1]) / dt, 2);
  EXPECT_NEAR(*report.value("scope.steadiness"), std::sqrt(turned / static_cast<double>(n - 1)), 1e-9);

  // Tasks: how many were done, by whose end the straight way goes, and their errors.
  double straight = 0, errors = 0;
  std::size_t from = 0;
  std::vector<std::size_t> ends;
  for (const char* id : {"left", "middle", "press", "trace"}) {
    const auto& outcome = t[std::string(id) + ".outcome"];
    const auto done = std::find(outcome.begin(), outcome.end(), 2.0);
    if (done != outcome.end()) ends.push_back(static_cast<std::size_t>(done - outcome.begin()));
    errors += t[std::string(id) + ".errors"].back();
  }
  std::sort(ends.begin(), ends.end());
  for (const std::size_t end : ends) straight += lengthBetween(t, "finger", from, end), from = end;
  EXPECT_NEAR(*report.value("finger.economy"), straight / *report.value("finger.path"), 1e-9);
  double below = 1, hard = 0, hardTime = 0;
  for (const double force : t["gentle.force"]) {
    if (force <= 3.5) below += dt;
    else hard += below > 0.0975 ? 1 : 0, below = 0, hardTime += dt;
  }
  EXPECT_DOUBLE_EQ(*report.value("gentle.tooHard"), hard);
  EXPECT_NEAR(*report.value("gentle.tooHardSeconds"), hardTime, 1e-9);
  EXPECT_DOUBLE_EQ(*report.value("errors"), errors + hard + t["look.errors"].back());

  // The form, by hand.
  const auto share = [&](double value, double best, double worst) { return std::min(1.0, std::max(0.0, (worst - value) / (worst - best))); };
  const double score = 30 * share(*report.value("tasks"), 1, 0) + 20 * share(*report.value("errors"), 0, 30) +
                       30 * share(*report.value("finger.economy"), 0.75, 0) + 20 * share(*report.value("finger.jerk"), 21, 26);
  EXPECT_NEAR(report.score, score, 1e-9);
}

TEST(TrainingMetrics, areTheSameWhenARunIsReplayed) {
  const Scenario scenario = exercise();
  const Recording input = disturbedHands(sure(scenario), {1e-3, 1e-3, 5});
  const auto one = trainingRun(scenario, input).report, two = trainingRun(scenario, input).report;
  EXPECT_EQ(one.stateHash, two.stateHash);
  EXPECT_TRUE(trainingJson(*one.training) == trainingJson(*two.training));
  EXPECT_TRUE(tasksJson(*one.training) == tasksJson(*two.training));
}

/// Judging changes nothing of the run.
TEST(TrainingMetrics, leaveTheRunAsItIs) {
  Scenario with = exercise(), without = slabScenario();
  const Recording input = sure(with);
  EXPECT_EQ(trainingRun(with, input).report.stateHash, trainingRun(without, input).report.stateHash);
}

TEST(TrainingMetrics, sureHandsDoAllOfIt) {
  const Scenario scenario = exercise();
  const auto report = trainingRun(scenario, sure(scenario)).report;
  ASSERT_TRUE(report.training);
  for (const TaskResult& task : report.training->tasks) EXPECT_EQ(task.record.outcome, TaskOutcome::Done) << task.id;
  EXPECT_DOUBLE_EQ(*report.training->value("errors"), 0);
  EXPECT_GT(report.training->score, 90);
}

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<double> rank(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    for (const double other : values) rank[i] += other < values[i] ? 1 : other == values[i] ? 0.5 : 0;
  return rank;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double n = static_cast<double>(a.size()), ma = std::accumulate(a.begin(), a.end(), 0.0) / n, mb = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) ab += (a[i] - ma) * (b[i] - mb), aa += (a[i] - ma) * (a[i] - ma), bb += (b[i] - mb) * (b[i] - mb);
  return ab / std::sqrt(aa * bb);
}

/// Spearman's rank correlation of less disturbance and score over twenty seeds, each hand less sure than the one before, from
/// steady to a root mean square of 1.1 mm of tremor and as much of wandering in each direction.
TEST(TrainingMetrics, growingNoiseScoresWorse) {
  const Scenario scenario = exercise();
  const Recording input = sure(scenario);
  std::vector<double> calm, score;
  for (int i = 0; i < 20; ++i) {
    const double size = 6e-5 * i;
    calm.push_back(-size);
    score.push_back(trainingRun(scenario, disturbedHands(input, {size, size, static_cast<std::uint64_t>(100 + i)})).report.training.value_or(TrainingReport{}).score);
  }
  std::string all;
  for (const double value : score) all += std::to_string(value) + " ";
  EXPECT_GE(correlation(ranks(calm), ranks(score)), 0.95) << all;
}

TEST(TrainingMetrics, carefulAndClumsyLieTwoDeviationsApart) {
  const Scenario scenario = exercise();
  const Recording input = sure(scenario);
  const auto scores = [&](double size, std::uint64_t seed) {
    std::vector<double> list;
    for (std::uint64_t i = 0; i < 20; ++i)
      list.push_back(trainingRun(scenario, disturbedHands(input, {size, size, seed + i})).report.training.value_or(TrainingReport{}).score);
    return list;
  };
  const auto moments = [](const std::vector<double>& list) {
    const double n = static_cast<double>(list.size()), mean = std::accumulate(list.begin(), list.end(), 0.0) / n;
    double squares = 0;
    for (const double value : list) squares += (value - mean) * (value - mean);
    return std::pair(mean, std::sqrt(squares / (n - 1)));
  };
  const auto [careful, sdCareful] = moments(scores(2e-4, 1000));
  const auto [clumsy, sdClumsy] = moments(scores(1.2e-3, 2000));
  EXPECT_GE(careful - clumsy, 2 * std::max(sdCareful, sdClumsy)) << careful << " ± " << sdCareful << ", " << clumsy << " ± " << sdClumsy;
}

}  // namespace
}  // namespace glenoid
