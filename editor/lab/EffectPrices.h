// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <vector>

#include "editor/core/Document.h"
#include "editor/lab/StepSeries.h"

namespace glenoid {

/// One effect of a running scene.
struct EffectPrice {
  std::string name;
  Wish wish = Wish::Auto;
  bool on = false;
  QString reason;               ///< why it is on or off, for people
  StepSeries::Figures ms{};     ///< of its own stages; NaN: it has none, or nothing ran
  QString sharedWith;           ///< the stage in which its time goes up with others'; empty: it has stages of its own
};

/// All effects in the order of the plan: what runs (`model`) and what the document wishes.
std::vector<EffectPrice> effectPrices(const Model& model, const Effects& wishes, const StepSeries& series);

/// What it costs, in a few words.
QString priceText(const EffectPrice& price);

/// Whether an effect shall be on; one undo step. False: unknown, or as it was.
bool setEffect(Document& document, const std::string& effect, Wish wish);

/// A stage of the step, for people.
QString stageWords(Stage stage);

}  // namespace glenoid
