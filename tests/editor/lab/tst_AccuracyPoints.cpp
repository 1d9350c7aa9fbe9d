// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/AccuracyPoints.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/editor/lab/LabFiles.h"

namespace glenoid::labtest {
namespace {

constexpr AccuracyView kView{AccuracyAgainst::OwnCells, AccuracyQuantity::Displacement};

AccuracyPoints pointsOf(const std::string& lines) {
  LabFolder files;
  files.append(R"({"study":"accuracy","dtMs":5})" "\n" R"({"table":"references","row":{"against":"own-cells","missing":"","displacementFloorMm":0.01}})" "\n" + lines);
  StudyFolder study(files.path());
  study.look();
  return accuracyPoints(study, kView);
}

std::string named(const AccuracyPoints& points, const std::optional<std::size_t>& found) { return found ? points.points[*found].id : "none"; }

TEST(AccuracyPoints, theFrontIsWhatNoOtherBeatsInBoth) {
  const AccuracyPoints points = pointsOf(settingRow("scene", "2", "2.5", "0.4") + settingRow("a", "1", "1.2", "0.9") + settingRow("b", "3", "3.2", "0.5") + settingRow("c", "8", "9", "0.1"));
  ASSERT_EQ(points.points.size(), 4u);
  EXPECT_DOUBLE_EQ(points.floor, 0.01);
  std::string front;
  for (const std::size_t k : points.front) front += points.points[k].id + " ";
  EXPECT_EQ(front, "a scene c ");
}

TEST(AccuracyPoints, picksGoByTheRulesOfTheCommandLine) {
  const AccuracyPoints points = pointsOf(settingRow("scene", "2", "2.5", "0.4") + settingRow("fast", "1", "1.2", "0.9") + settingRow("near", "4", "6", "0.1") +
                                         settingRow("below", "3", "3.1", "0.001") + settingRow("below2", "2.9", "3", "0.009") + settingRow("studied-only", "0.5", "0.6", "0.02", "\"inScenario\":false") +
                                         settingRow("visual", "0.4", "0.5", "0.02", "\"inScenario\":true,\"contactSurfaces\":\"visual\""));
  EXPECT_EQ(named(points, points.pickForBudget(2)), "fast");
  EXPECT_EQ(named(points, points.pickForBudget(2.5)), "scene");
  EXPECT_EQ(named(points, points.pickForBudget(5)), "below2") << "below the reference's own error the faster wins";
  EXPECT_EQ(named(points, points.pickForBudget(0.1)), "none");
  EXPECT_EQ(named(points, points.pickForAccuracy(0.5)), "scene");
  EXPECT_EQ(named(points, points.pickForAccuracy(0.05)), "below2");
}

TEST(AccuracyPoints, whatFailedOrHasNoFigureIsNoPoint) {
  const AccuracyPoints points = pointsOf(settingRow("scene", "2", "2.5", "null") + settingRow("rough", "null", "null", "0.4", "\"inScenario\":true,\"roughWorkMs\":3.5") +
                                         R"({"table":"settings","row":{"setting":"dt=20ms","family":"time-step","failure":"not-finite","failureDetail":"3 of 40 steps","windows":4,"workMedianMs":1}})" "\n");
  ASSERT_EQ(points.points.size(), 3u);
  EXPECT_TRUE(std::isnan(points.points[0].error));
  EXPECT_TRUE(points.points[1].rough);
  EXPECT_DOUBLE_EQ(points.points[1].ms, 3.5);
  EXPECT_EQ(points.points[2].failure, "not-finite");
  EXPECT_TRUE(std::isnan(points.points[2].error));
  EXPECT_TRUE(points.front.empty()) << "guesses do not count";
  EXPECT_FALSE(points.pickForBudget(1000));
}

}  // namespace
}  // namespace glenoid::labtest
