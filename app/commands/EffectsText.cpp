// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/EffectsText.h"

#include <algorithm>
#include <cmath>

#include "app/commands/AccuracyText.h"
#include "app/commands/Console.h"
#include "editor/core/AnatomyNames.h"
#include "editor/core/EffectSentences.h"
#include "editor/core/Sentences.h"

namespace glenoid {
namespace {

std::string nameOf(const EffectRow& row) {
  return effectName(row.name).toStdString();
}

/// "a / b" with each by its name.
std::string placeName(const Model& model, const std::string& where) {
  const std::size_t bar = where.find(" / ");
  if (bar == std::string::npos) return objectName(model, where);
  return objectName(model, where.substr(0, bar)) + " on " + objectName(model, where.substr(bar + 3));
}

/// Whether a price stands out of what the same code differs from itself by.
bool stands(const EffectTimes& times) {
  return std::abs(times.price.median) > 2 * std::abs(times.noise.median);
}

std::string priceWords(const EffectRow& row) {
  if (!row.times) return "no time";
  const EffectTimes& t = *row.times;
  if (!stands(t))
    return text("no time that can be told (%.3g ms, and the same code differs from itself by %.3g)",
                t.price.median, t.noise.median);
  if (t.price.median < 0) return text("a step is %.2g ms faster with it", -t.price.median);
  return text("%.2g ms a step (p95 %.2g)", t.price.median, t.price.p95);
}

/// What differs, or nothing where it is less than what a step leaves out.
std::string lossWords(const EffectsResult& result, const EffectRow& row, AccuracyQuantity quantity,
                      const char* what) {
  const AccuracyError& apart = row.loss->apart[quantity];
  if (apart.value == 0 || apart.value <= result.floor[quantity].value) return {};
  std::string words = quantityText(quantity, apart.value) + " " + what;
  if (!apart.where.empty())
    words +=
        (quantity == AccuracyQuantity::HandForce ? " by the " : ", ") + placeName(*result.base, apart.where);
  return words;
}

std::string lost(const EffectsResult& result, const EffectRow& row) {
  const EffectLoss& loss = *row.loss;
  if (loss.notTaken > 0)
    return text("without it %ld of %ld steps could not be taken", loss.notTaken, loss.steps);
  std::string words;
  const auto add = [&](const std::string& one) {
    if (!one.empty()) words += (words.empty() ? "" : "; ") + one;
  };
  const AccuracyError& moved = loss.apart[AccuracyQuantity::Displacement];
  if (moved.value > result.floor[AccuracyQuantity::Displacement].value)
    add(text("%.3g mm of place (%.3g at most), ", 1e3 * moved.value, 1e3 * moved.most) +
        placeName(*result.base, moved.where));
  add(lossWords(result, row, AccuracyQuantity::ContactForce, "of contact force"));
  add(lossWords(result, row, AccuracyQuantity::Penetration, "of depth"));
  if (result.hands) add(lossWords(result, row, AccuracyQuantity::HandForce, "of the force on the hand"));
  if (words.empty()) return "without it nothing is lost that the time step does not lose anyway";
  return text("lost without it within %.3g s: ", result.wishes.seconds) + words;
}

}  // namespace

std::string objectName(const Model& model, const std::string& id) {
  for (const SceneObject& object : model.objects)
    if (object.id == id) return object.name.empty() ? id : anatomyName(object.name).toStdString();
  return id;
}

std::string effectLine(const EffectsResult& result, const EffectRow& row) {
  std::string line = nameOf(row) + ": ";
  if (row.failed) return line + sentenceOf(*row.failed).toStdString();
  if (!row.acts)
    line += "costs nothing, not even when it is switched on";
  else if (row.name == "haptics")
    line += priceWords(row) +
            "; nothing that moves depends on it: what is lost is the force in the hand, a thousand times a "
            "second";
  else
    line += priceWords(row) + "; " + lost(result, row);
  if (!row.with.empty()) {
    line += "; with it go";
    for (std::size_t k = 0; k < row.with.size(); ++k)
      line += (k ? ", " : " ") + effectName(row.with[k]).toStdString();
  }
  line += "; auto: " + effectSentence(row.automatic).toStdString();
  if (row.wish != Wish::Auto)
    line += std::string("; the scene asks for ") + (row.wish == Wish::On ? "on" : "off");
  return line + ".";
}

std::string effectsSummary(const EffectsResult& result, const std::string& scene) {
  std::string out = text("%s: what each effect costs and what would be lost without it.\n", scene.c_str());
  out += text(
      "A step takes %.3g ms (p95 %.3g). Runs with and without an effect start from the same %zu saved "
      "states; steps are timed one after the other,\n"
      "%d times; places and forces are compared over %.3g s. The time step itself leaves out %.3g mm, %.3g "
      "N; what is less than that is not told.\n\n",
      result.step.median, result.step.p95, result.windows.size(), result.repeats, result.wishes.seconds,
      1e3 * result.floor[AccuracyQuantity::Displacement].value,
      result.floor[AccuracyQuantity::ContactForce].value);
  for (const EffectRow& row : result.rows) out += effectLine(result, row) + "\n";
  return out + "\n";
}

BarPlot effectsPlot(const EffectsResult& result, const std::string& scene, const std::string& machine) {
  BarPlot plot;
  plot.title = "What each effect costs: " + scene;
  plot.subtitle = {text("Runs with and without it from the same %zu saved states, interleaved, %d repeats: "
                        "median of a step, whiskers up to p95.",
                        result.windows.size(), result.repeats),
                   text("Beside them what is lost without it within %.3g s: root mean square, of the part, "
                        "pair or tool for which it is largest.",
                        result.wishes.seconds),
                   machine + "."};
  plot.xTitle = "Thread CPU time of a step, ms";
  plot.notesTitle = "Price, and what is lost without it";
  plot.series = {"off", "on", "auto"};
  plot.levels = {{1e3 * result.base->scenario.dt, "real time"}};
  for (const EffectRow& row : result.rows) {
    PlotBarGroup& group = plot.groups.emplace_back();
    group.label = nameOf(row);
    if (row.times)
      for (std::size_t k = 0; k < kEffectChoices; ++k)
        group.bars.push_back({k, row.times->step[k].median, row.times->step[k].p95});
    if (row.failed)
      group.notes = {"could not be compiled: " + sentenceOf(*row.failed).toStdString()};
    else if (!row.acts)
      group.notes = {"nothing to act on: costs nothing"};
    if (row.acts) group.notes.push_back(priceWords(row));
    if (row.loss && row.name != "haptics") {
      const AccuracyError &moved = row.loss->apart[AccuracyQuantity::Displacement],
                          &pressed = row.loss->apart[AccuracyQuantity::ContactForce];
      group.notes.push_back(text("%.3g mm", 1e3 * moved.value) +
                            (moved.where.empty() ? std::string() : " (" + placeName(*result.base, moved.where) + ")"));
      group.notes.push_back(
          text("%.3g N between parts", pressed.value) +
          (result.hands ? text(", %.3g N on the hand", row.loss->apart[AccuracyQuantity::HandForce].value)
                        : std::string()));
    }
    group.notes.push_back("auto: " + effectSentence(row.automatic).toStdString());
    // A scene that falls apart without something takes many times as long: what it costs with it decides on the scale.
    if (row.times) plot.most = std::max({plot.most, 1.3 * row.times->step[1].p95, 1.3 * row.times->step[2].p95});
  }
  return plot;
}

}  // namespace glenoid
