// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/AccuracyText.h"

#include <gtest/gtest.h>

#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include "app/commands/StudyFiles.h"
#include "app/plot/PlotAxis.h"

namespace glenoid::test {
namespace {

AccuracyResult made() {
  AccuracyResult result;
  result.windows.resize(20);
  result.wishes.seconds = 0.2;
  result.repeats = 7;
  const struct {
    const char *id, *family;
    double dt, work, error;
  } rows[] = {{"scene", "scene", 0.005, 1, 1e-4}, {"dt=2.5ms", "time-step", 0.0025, 2, 5e-5}, {"dt=10ms", "time-step", 0.01, 0.6, 3e-4}};
  for (const auto& [id, family, dt, work, error] : rows) {
    AccuracyRow& row = result.rows.emplace_back();
    row.setting.id = id;
    row.setting.family = family;
    row.setting.dt = dt;
    row.windows = 20;
    row.timed = 420;
    row.work = {work, 1.2 * work, 1.3 * work, 0, 0};
    row.errors[1].emplace();
    row.errors[1]->by[0] = {error, 2 * error, "humerus"};
  }
  AccuracyRow& failed = result.rows.emplace_back();
  failed.setting.id = "profile=paper";
  failed.setting.family = "profile";
  failed.windows = 4;
  failed.timed = 20;
  failed.work = {12, 13, 14, 0, 0};
  failed.failure = {"diverged", {}, 3, 160};
  failed.errors[1] = result.rows[0].errors[1];
  result.references[1].finest.dt = 0.005 / 32;
  result.references[1].floor.by[0].value = 4e-6;
  result.references[0].missing = Error{Fault::Unusable, {}, {"a region on the collision surface"}, ""};
  return result;
}

AccuracyWish wish(std::optional<double> budgetMs, std::optional<double> accuracy) { return {{}, budgetMs, accuracy}; }

TEST(AccuracyText, choosesOrSaysWhatIsMissing) {
  const AccuracyResult result = made();
  EXPECT_EQ(chosenSetting(result, wish({}, {})).value(), std::nullopt);
  EXPECT_EQ(chosenSetting(result, wish(1.3, {})).value(), 0u);
  EXPECT_EQ(chosenSetting(result, wish({}, 3.1e-4)).value(), 2u);
  const Error tooFine = chosenSetting(result, wish({}, 7.9e-6)).error();  // twice 4 µm is 8 µm
  EXPECT_EQ(tooFine.fault, Fault::OutOfRange);
  ASSERT_EQ(tooFine.arguments.size(), 3u);
  EXPECT_NE(tooFine.arguments[0].find("0.0079 mm"), std::string::npos);
  EXPECT_NE(tooFine.arguments[1].find("0.008 mm"), std::string::npos);
  const Error none = chosenSetting(result, wish({}, 1e-5)).error();
  EXPECT_EQ(none.fault, Fault::CheckFailed);
  EXPECT_NE(none.arguments[0].find("dt=2.5ms, has 0.05 mm"), std::string::npos) << none.arguments[0];
  const Error slow = chosenSetting(result, wish(0.5, {})).error();
  EXPECT_EQ(slow.fault, Fault::CheckFailed);
  EXPECT_NE(slow.arguments[0].find("dt=10ms, takes 0.72 ms"), std::string::npos) << slow.arguments[0];
  AccuracyWish finer = wish(5, {});
  finer.view.against = AccuracyAgainst::FinerCells;
  EXPECT_EQ(chosenSetting(result, finer).error().fault, Fault::Unusable);
}

TEST(AccuracyText, whatFailedStandsAtTheMarginAndInTheSummary) {
  const AccuracyResult result = made();
  const LogLogPlot plot = accuracyPlot(result, "knee", {}, 1, "a machine");
  ASSERT_EQ(plot.margin.size(), 1u);
  EXPECT_EQ(plot.margin[0].label, "profile=paper");
  EXPECT_EQ(plot.margin[0].reason, "diverged in 3 of 160 steps");
  EXPECT_EQ(plot.margin[0].y, 12);
  std::size_t points = 0;
  for (const PlotSeries& series : plot.series)
    if (series.markers) points += series.points.size();
  EXPECT_EQ(points, 3u);  // with the one that failed all settings
  EXPECT_DOUBLE_EQ(plot.band, 4e-3);
  EXPECT_DOUBLE_EQ(plot.limit, 8e-3);
  EXPECT_EQ(plot.levels.size(), 3u);
  const std::string summary = accuracySummary(result, "knee", {}, 1);
  for (const char* words : {"profile=paper", "diverged in 3 of 160 steps", "own error: displacement 0.004 mm", "Chosen:\n  dt=2.5ms", "No comparison with finer-cells"})
    EXPECT_NE(summary.find(words), std::string::npos) << words << "\n" << summary;
}

TEST(StudyFiles, aTableIsReadByAnyProgram) {
  StudyTable table;
  table.columns = {"setting", "ms", "failed", "count"};
  table.rows = {{std::string("cells=2,dt=10ms"), 0.1, false, 3L}, {std::string("a \"b\""), std::nan(""), true, StudyCell()}};
  EXPECT_EQ(tableCsv(table), "setting,ms,failed,count\r\n\"cells=2,dt=10ms\",0.1,no,3\r\n\"a \"\"b\"\"\",,yes,\r\n");
}

TEST(StudyFiles, aReferenceIsTheSameSeenFromAnotherFolder) {
  EXPECT_EQ(movedReference("builtin:shoulder", "/a", "/b"), "builtin:shoulder");
  EXPECT_EQ(movedReference("knee.joint", "/a/b", "/a/c"), "../b/knee.joint");
  EXPECT_EQ(movedReference("../knee.joint", "/a/b", "/a"), "knee.joint");
  EXPECT_EQ(movedReference("/x/knee.joint", "/a", "/b"), "/x/knee.joint");
  EXPECT_EQ(movedReference("", "/a", "/b"), "");
}

TEST(PlotAxis, isLogarithmicAndNamesItsDecades) {
  const PlotAxis axis({1e-3, 10, std::nan(""), -1, 0}, 0, 100);
  EXPECT_LT(axis.from(), 1e-3);
  EXPECT_GT(axis.to(), 10);
  EXPECT_NEAR(axis.at(1) - axis.at(0.1), axis.at(0.1) - axis.at(0.01), 1e-9);
  int decades = 0;
  for (const PlotAxis::Tick& tick : axis.ticks()) decades += tick.major;
  EXPECT_EQ(decades, 5);
  EXPECT_EQ(axisNumber(0.001), "0.001");
  EXPECT_EQ(axisNumber(20), "20");
  EXPECT_EQ(axisNumber(1e-5), "10⁻⁵");
  EXPECT_FALSE(PlotAxis::hasPlace(std::nan("")) || PlotAxis::hasPlace(0) || PlotAxis::hasPlace(-1) || PlotAxis::hasPlace(HUGE_VAL));
}

TEST(LogLogPlot, whatIsNotANumberIsAGapInItsLine) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  int count = 1;
  char name[] = "test", *names[] = {name, nullptr};
  QGuiApplication application(count, names);
  const auto inkBetween = [](double middle) {
    LogLogPlot plot;
    plot.series = {{"", {{1, 1}, {10, middle}, {100, 1}}, true, false}};
    QImage image(kPlotWidth, kPlotHeight, QImage::Format_RGB32);
    QPainter painter(&image);
    draw(painter, plot);
    painter.end();
    long dark = 0;  // inside the frame, darker than any line of the grid
    for (int y = 150; y < kPlotHeight - 80; ++y)
      for (int x = 110; x < kPlotWidth - 60; ++x) dark += qGray(image.pixel(x, y)) < 100;
    return dark;
  };
  EXPECT_GT(inkBetween(1), 500);
  EXPECT_EQ(inkBetween(std::nan("")), 0);
}

}  // namespace
}  // namespace glenoid::test
