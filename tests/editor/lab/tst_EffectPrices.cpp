// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/EffectPrices.h"

#include <gtest/gtest.h>

#include <cmath>

#include "editor/lab/IslandRows.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

const EffectPrice& priceOf(const std::vector<EffectPrice>& prices, const std::string& name) {
  for (const EffectPrice& price : prices)
    if (price.name == name) return price;
  throw std::runtime_error(name);
}

TEST(EffectPrices, comeFromTheStagesOfRealSteps) {
  Scenario scenario = scenes::figure5Scenario();
  scenario.effects.friction = Wish::Off;
  const auto model = compileModel(scenes::figure4Joint(), scenario).value();
  StepMeter meter;
  meter.setWanted(true);
  State state = model->start;
  const StepFunction step = meter.maker()(model, {});
  for (int k = 0; k < 30; ++k) step({}, state);
  StepSeries series;
  const StepMeter::Reading reading = meter.take();
  series.add(1.0, reading);
  const std::vector<EffectPrice> prices = effectPrices(*model, scenario.effects, series);
  const EffectPrice& contact = priceOf(prices, "contact");
  EXPECT_TRUE(contact.on);
  EXPECT_GT(contact.ms.p50, 0);
  EXPECT_LT(contact.ms.p50, series.step().p95);
  const EffectPrice& friction = priceOf(prices, "friction");
  EXPECT_FALSE(friction.on);
  EXPECT_EQ(friction.wish, Wish::Off);
  EXPECT_TRUE(std::isnan(friction.ms.p50));
  EXPECT_TRUE(priceText(friction).contains(QStringLiteral("nothing")));
  EXPECT_EQ(priceOf(prices, "couplings").sharedWith, stageWords(Stage::Assemble));

  const std::vector<IslandRow> rows = islandRows(*model, reading.islands);
  ASSERT_EQ(rows.size(), 1u) << "all of Figure 5 is one island";
  EXPECT_EQ(rows[0].unknowns, static_cast<int>(model->start.v.size()));
  EXPECT_TRUE(rows[0].why.contains(QStringLiteral("coupled to"))) << rows[0].why.toStdString();
  EXPECT_TRUE(rows[0].why.contains(QStringLiteral("touches"))) << rows[0].why.toStdString();
  EXPECT_GT(rows[0].ms, 0);
}

TEST(EffectPrices, aSwitchIsOneUndoStep) {
  Document document;
  document.open({scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr}, {});
  EXPECT_TRUE(setEffect(document, "friction", Wish::Off));
  EXPECT_EQ(document.scenario().effects.friction, Wish::Off);
  EXPECT_FALSE(setEffect(document, "friction", Wish::Off));
  EXPECT_FALSE(setEffect(document, "weather", Wish::Off));
  document.undoStack().undo();
  EXPECT_EQ(document.scenario().effects.friction, Wish::Auto);
  EXPECT_EQ(document.undoStack().count(), 1);
}

}  // namespace
}  // namespace glenoid
