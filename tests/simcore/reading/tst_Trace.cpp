// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/Trace.h"

#include <gtest/gtest.h>

#include <sstream>

#include "simcore/live/PenetrationProbe.h"
#include "simcore/live/Run.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

using Table = std::vector<std::vector<std::string>>;

Table tableOf(const std::string& csv) {
  Table table;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    table.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) table.back().push_back(cell);
    if (line.ends_with(',')) table.back().emplace_back();
  }
  return table;
}

double number(const Table& table, std::size_t row, const std::string& column) {
  const auto& head = table[0];
  const auto at = std::find(head.begin(), head.end(), column);
  EXPECT_NE(at, head.end()) << column;
  return at == head.end() ? 0 : std::stod(table[row][at - head.begin()]);
}

/// A rigid block 0.2 mm above a fixed plate, and one that falls beside it for ever.
std::shared_ptr<const Model> scene() {
  Joint joint;
  joint.id = joint.name = "trace";
  scenes::addMaterials(joint);
  joint.parts = {scenes::boxPart("plate", 1, PartKind::Rigid, Vec3(-0.05, -0.01, -0.05), Vec3(0.05, 0, 0.05)),
                 scenes::boxPart("block", 2, PartKind::Rigid, Vec3(-0.011, 0.0002, -0.013), Vec3(0.017, 0.03, 0.012)),
                 scenes::boxPart("loose", 3, PartKind::Rigid, Vec3(1, 0, 0), Vec3(1.02, 0.02, 0.02))};
  Scenario scenario;
  scenario.id = scenario.name = "trace";
  scenario.fixedParts = {"plate"};
  return compileModel(joint, scenario).value();
}

Table traced(const TraceWishes& wishes, int steps) {
  const auto model = scene();
  Result<Trace> trace = Trace::make(*model, wishes);
  EXPECT_TRUE(trace.ok());
  State state = model->start;
  Stepper stepper(model, {});
  trace->begin(state);
  for (int i = 0; i < steps; ++i) {
    const StepReport& report = stepper.step({}, state);
    trace->add(report, state);
  }
  return tableOf(trace->csv());
}

TEST(Trace, rowsStandAtTheStartAndAfterEveryNthStep) {
  TraceWishes wishes;
  wishes.every = 25;
  const Table table = traced(wishes, 110);
  ASSERT_EQ(table.size(), 1u + 1 + 4);
  for (const auto& row : table) EXPECT_EQ(row.size(), 2u + 2 * 13 + 6);  // two parts move, one pair touches
  for (int row = 0; row < 5; ++row) {
    const int n = 25 * row;
    EXPECT_DOUBLE_EQ(number(table, row + 1, "time"), n * 0.005);
    // Free fall by backward Euler, read back to the last digits that 9.81 n leave.
    EXPECT_NEAR(number(table, row + 1, "loose.vy"), -9.81 * n * 0.005, 1e-12);
    EXPECT_NEAR(number(table, row + 1, "loose.y"), 0.01 - 9.81 * 0.5 * n * (n + 1) * 0.005 * 0.005, 1e-11);
    EXPECT_EQ(number(table, row + 1, "loose.qw"), 1);
  }
  EXPECT_EQ(number(table, 1, table[0][28].substr(0, table[0][28].find('.')) + ".contacts"), 0);  // nothing before the first step
}

TEST(Trace, aPairsForceIsTheOneOnItsFirstPart) {
  const double weight = 2000 * 0.028 * 0.0298 * 0.025 * 9.81;
  TraceWishes wishes;
  wishes.parts = {"block"};
  wishes.pairs = {{"block", "plate"}};
  wishes.every = 200;
  const Table up = traced(wishes, 200);
  EXPECT_NEAR(number(up, 2, "block:plate.fy"), weight, 1e-5 * weight);
  EXPECT_NEAR(number(up, 2, "block:plate.normal"), weight, 1e-5 * weight);
  EXPECT_GE(number(up, 2, "block:plate.contacts"), 3);
  wishes.pairs = {{"plate", "block"}};
  EXPECT_NEAR(number(traced(wishes, 200), 2, "plate:block.fy"), -weight, 1e-5 * weight);
}

TEST(Trace, depthsAreThoseOfTheRowAndOfThePair) {
  const Joint joint = scenes::sunkenCubesJoint();
  const Scenario scenario = scenes::sunkenCubesScenario();
  const auto model = compileModel(joint, scenario).value();
  TraceWishes wishes;
  wishes.every = 10;
  wishes.pairs = {{"slab", "deep"}, {"shallow", "slab"}, {"deep", "middle"}};
  Trace trace = Trace::make(*model, wishes).value();
  PenetrationProbe probe(*model, SurfaceKind::Collision);
  probe.look(model->start.q);
  trace.begin(model->start, probe.lastLook());
  RunOptions options;
  options.steps = 30;
  options.observe = [&](const StepReport& step, const State& state, std::span<const Penetration> depths) { trace.add(step, state, depths); };
  const double most = runScenario(model, options)->report.penetrationMax;
  const Table table = tableOf(trace.csv());
  ASSERT_EQ(table.size(), 5u);
  for (int row = 0; row < 4; ++row) {
    // The cubes leave the slab at the recovery speed; a nanometre is round-off of the contact solve.
    const double left = 10 * row * scenario.dt * scenes::kRecovery;
    EXPECT_NEAR(number(table, row + 1, "penetration"), scenes::kCubeDepths[0] - left, 1e-9) << row;
    EXPECT_NEAR(number(table, row + 1, "slab:deep.penetration"), scenes::kCubeDepths[0] - left, 1e-9) << row;
    EXPECT_NEAR(number(table, row + 1, "shallow:slab.penetration"), std::max(0.0, scenes::kCubeDepths[2] - left), 1e-9) << row;
    EXPECT_EQ(number(table, row + 1, "deep:middle.penetration"), 0) << row;
    EXPECT_GE(most, row == 0 ? 0 : number(table, row + 1, "penetration"));
  }
  EXPECT_LT(most, number(table, 1, "penetration")) << "the report's begins after the first step";
}

TEST(Trace, aDepthThatNobodyMeasuredOrThatCannotBeIsAnEmptyCell) {
  TraceWishes wishes;
  wishes.parts = {"block"};
  wishes.pairs = {{"block", "plate"}};
  const Table table = traced(wishes, 2);
  for (std::size_t row = 1; row < table.size(); ++row) {
    EXPECT_EQ(table[row][1], "");
    EXPECT_EQ(table[row].back(), "");
    EXPECT_EQ(table[row].size(), table[0].size());
  }
  Joint joint = scenes::sunkenCubesJoint();
  joint.exclusions = {{"slab", "deep", ""}};
  const auto model = compileModel(joint, scenes::sunkenCubesScenario()).value();
  wishes.parts = {"deep"};
  wishes.pairs = {{"slab", "deep"}, {"slab", "middle"}};
  Trace trace = Trace::make(*model, wishes).value();
  PenetrationProbe probe(*model, SurfaceKind::Collision);
  probe.look(model->start.q);
  trace.begin(model->start, probe.lastLook());
  const Table excluded = tableOf(trace.csv());
  EXPECT_EQ(excluded[1][2 + 13 + 5], "");
  EXPECT_NEAR(number(excluded, 1, "slab:middle.penetration"), scenes::kCubeDepths[1], 1e-12);
  EXPECT_NEAR(number(excluded, 1, "penetration"), scenes::kCubeDepths[1], 1e-12);
}

TEST(Trace, whatIsNotThereIsRefused) {
  const auto model = scene();
  TraceWishes wishes;
  wishes.parts = {"block", "spleen"};
  const auto part = Trace::make(*model, wishes);
  ASSERT_FALSE(part.ok());
  EXPECT_EQ(part.error().fault, Fault::UnknownId);
  EXPECT_EQ(part.error().arguments[0], "spleen");
  wishes.parts = {};
  wishes.pairs = {{"block", "block"}};
  const auto pair = Trace::make(*model, wishes);
  ASSERT_FALSE(pair.ok());
  EXPECT_EQ(pair.error().fault, Fault::BadUsage);
  for (const char* list : {"", "a,,b", "a,"}) EXPECT_FALSE(tracePartsIn(list).ok()) << list;
  for (const char* list : {"", "a", "a:", ":b", "a:b:c", "a:b,"}) EXPECT_FALSE(tracePairsIn(list).ok()) << list;
  EXPECT_EQ(tracePairsIn("a:b,c:d").value(), (std::vector<std::array<std::string, 2>>{{"a", "b"}, {"c", "d"}}));
}

}  // namespace
}  // namespace glenoid
