// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/effects/EffectsTables.h"

#include "simcore/scene/SceneWords.h"

namespace glenoid {
namespace {

using Row = std::vector<StudyCell>;

StudyTable effectsTable(const EffectsResult& result) {
  StudyTable table;
  table.id = "effects";
  table.facts = {{"stepMedianMs", result.step.median},
                 {"windows", static_cast<long>(result.windows.size())},
                 {"windowS", result.wishes.seconds},
                 {"repeats", static_cast<long>(result.repeats)},
                 {"displacementFloorMm", 1e3 * result.floor[AccuracyQuantity::Displacement].value},
                 {"contactForceFloorN", result.floor[AccuracyQuantity::ContactForce].value},
                 {"penetrationFloorMm", 1e3 * result.floor[AccuracyQuantity::Penetration].value}};
  if (result.hands)
    table.facts.emplace_back("handForceFloorN", result.floor[AccuracyQuantity::HandForce].value);
  table.columns = {"effect",
                   "wish",
                   "auto",
                   "autoReason",
                   "acts",
                   "goesOffWithIt",
                   "offMedianMs",
                   "offP95Ms",
                   "onMedianMs",
                   "onP95Ms",
                   "autoMedianMs",
                   "autoP95Ms",
                   "priceMedianMs",
                   "priceP95Ms",
                   "noiseMedianMs",
                   "noiseP95Ms",
                   "pairsTimed",
                   "displacementRmsMm",
                   "displacementMostMm",
                   "displacementWhere",
                   "contactForceRmsN",
                   "contactForceMostN",
                   "contactForceWhere",
                   "penetrationRmsMm",
                   "penetrationMostMm",
                   "penetrationWhere",
                   "handForceRmsN",
                   "handForceMostN",
                   "handForceWhere",
                   "deepestWithMm",
                   "deepestWithWhere",
                   "deepestWithoutMm",
                   "deepestWithoutWhere",
                   "handForceWithN",
                   "handForceWithoutN",
                   "steps",
                   "stepsNotTaken",
                   "worstWindowS",
                   "failure"};
  for (const EffectRow& row : result.rows) {
    std::string with;
    for (const std::string& name : row.with) with += (with.empty() ? "" : " ") + name;
    Row cells{row.name,
              std::string(scene_words::wordOf(scene_words::kWishes, row.wish)),
              std::string(stateWord(row.automatic.on)),
              row.automatic.reason,
              row.acts,
              with};
    if (row.times) {
      const EffectTimes& t = *row.times;
      for (const Timing& timing : {t.step[0], t.step[1], t.step[2], t.price, t.noise})
        cells.insert(cells.end(), {timing.median, timing.p95});
      cells.emplace_back(t.pairs);
    } else {
      cells.insert(cells.end(), 11, StudyCell());
    }
    if (row.loss) {
      const EffectLoss& loss = *row.loss;
      for (const AccuracyQuantity quantity : {AccuracyQuantity::Displacement, AccuracyQuantity::ContactForce,
                                              AccuracyQuantity::Penetration, AccuracyQuantity::HandForce}) {
        const bool length =
            quantity == AccuracyQuantity::Displacement || quantity == AccuracyQuantity::Penetration;
        const AccuracyError& apart = loss.apart[quantity];
        if (quantity == AccuracyQuantity::HandForce && !result.hands)
          cells.insert(cells.end(), 3, StudyCell());
        else
          cells.insert(cells.end(),
                       {(length ? 1e3 : 1) * apart.value, (length ? 1e3 : 1) * apart.most, apart.where});
      }
      cells.insert(cells.end(),
                   {1e3 * loss.deepestWith, loss.whereWith, 1e3 * loss.deepestWithout, loss.whereWithout});
      if (result.hands)
        cells.insert(cells.end(), {loss.handWith, loss.handWithout});
      else
        cells.insert(cells.end(), 2, StudyCell());
      cells.insert(cells.end(), {loss.steps, loss.notTaken, result.windows[loss.moment.window].time});
    } else {
      cells.insert(cells.end(), 21, StudyCell());
    }
    cells.emplace_back(row.failed ? toLogLine(*row.failed) : std::string());
    table.rows.push_back(std::move(cells));
  }
  return table;
}

StudyTable windowsTable(const EffectsResult& result) {
  StudyTable table;
  table.id = "windows";
  table.facts = {{"lengthS", result.wishes.seconds}, {"samplesEveryS", result.wishes.grid}};
  table.columns = {"timeS", "loaded", "mark", "stateHash"};
  for (const AccuracyWindow& window : result.windows)
    table.rows.push_back({window.time, window.loaded, window.mark, window.stateHash});
  return table;
}

}  // namespace

const char* stateWord(bool on) {
  return on ? "on" : "off";
}

std::vector<StudyTable> effectsTables(const EffectsResult& result) {
  return {effectsTable(result), windowsTable(result)};
}

}  // namespace glenoid
