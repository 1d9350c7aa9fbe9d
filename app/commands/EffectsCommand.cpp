// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands/Console.h"
#include "app/commands/EffectsText.h"
#include "app/commands/OpenScene.h"
#include "app/commands/Picture.h"
#include "app/commands/StudyCommand.h"
#include "app/commands/StudyFiles.h"
#include "app/commands/TableText.h"
#include "app/plot/PlotAxis.h"
#include "app/plot/PlotFile.h"
#include "editor/core/Sentences.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Json.h"
#include "simcore/scene/JointFile.h"
#include "simcore/study/effects/EffectsTables.h"

namespace glenoid {
namespace {

struct Wishes {
  std::string scenario, out, input;
  std::vector<std::string> effects;
  bool quick = false, smallest = false;
};

/// For tests of the command.
EffectsOptions smallestEffects() {
  EffectsOptions options = quickEffects();
  options.windows.count = 2;
  options.windows.seconds = 0.04;
  options.finer = 2;
  return options;
}

/// The part, no tool, that a moment shows furthest off; −1: none moved.
int furthestPart(const Model& model, const EffectMoment& moment, double& most) {
  int furthest = -1;
  most = 0;
  for (std::size_t i = 0; i < moment.apart.size(); ++i) {
    if (model.objects[i].tool || moment.apart[i].empty()) continue;
    const double here = *std::max_element(moment.apart[i].begin(), moment.apart[i].end());
    if (!(here > most) || !std::isfinite(here)) continue;
    most = here;
    furthest = static_cast<int>(i);
  }
  return furthest;
}

/// Displacement in mm as colours, with a scale up to a round number.
FieldLook apartLook(const EffectMoment& moment, double most, const std::string& effect) {
  const double tick = evenTick(1e3 * most);
  FieldLook look;
  look.values = std::make_shared<const std::vector<std::vector<float>>>(moment.apart);
  look.high = 1e-3 * tick * std::ceil(1e3 * most / tick);
  look.zeroIsNone = true;
  look.title = "Off without " + effect + " (mm)";
  for (int k = 0; 1e-3 * k * tick <= look.high * (1 + 1e-9); ++k)
    look.ticks.push_back({1e-3 * k * tick, k == 0 ? std::string("0") : axisNumber(k * tick)});
  return look;
}

/// EFFECT.png, the scene at the moment the effect is missed most, and EFFECT-part.png, the part furthest off
/// alone.
Result<Done> savePictures(const EffectsResult& result, const std::string& folder) {
  for (const EffectRow& row : result.rows) {
    if (!row.loss) continue;
    const EffectMoment& moment = row.loss->moment;
    double most = 0;
    const int part = furthestPart(*result.base, moment, most);
    if (part < 0 || most < 1e-9) continue;  // less than a nanometre has no place
    QString name = effectName(row.name);
    name[0] = name[0].toLower();
    PictureWishes picture;
    picture.width = 1100, picture.height = 825;
    picture.field = apartLook(moment, most, name.toStdString());
    for (const bool alone : {false, true}) {
      picture.part = alone ? result.base->objects[static_cast<std::size_t>(part)].id : std::string();
      picture.out = inFolder(folder, row.name + (alone ? "-part.png" : ".png"));
      const auto drawn = drawPicture(*result.base, moment.with, {}, picture, moment.dents);
      if (!drawn && drawn.error().fault == Fault::NoGraphics) return Done{};
      if (!drawn) return drawn;
    }
  }
  return Done{};
}

Result<Done> saveTables(const EffectsResult& result, const Wishes& wishes, const OpenScene& scene) {
  JsonValue json = machineJson();
  json.set("study", "effects");
  json.set("scenario", wishes.scenario);
  json.set("jointHash", jointHash(scene.joint));
  json.set("dt", scene.scenario.dt);
  json.set("quick", wishes.quick);
  JsonValue tables = JsonValue::array(), words = JsonValue::object();
  for (const StudyTable& table : effectsTables(result)) {
    tables.append(tableJson(table));
    if (const auto saved = writeWholeFile(inFolder(wishes.out, table.id + ".csv"), tableCsv(table)); !saved)
      return saved;
  }
  for (const EffectRow& row : result.rows) words.set(row.name, effectLine(result, row));
  json.set("tables", std::move(tables));
  json.set("words", std::move(words));
  return writeJson(inFolder(wishes.out, "effects.json"), json);
}

Result<Done> effects(const Wishes& wishes) {
  Result<OpenScene> scene = openScenario(wishes.scenario);
  if (!scene) return scene.error();
  const Result<std::optional<Recording>> input = openInput(wishes.input, wishes.scenario, scene->scenario);
  if (!input) return input.error();
  if (const auto good = prepareFolder(wishes.out); !good) return good;
  EffectsOptions options = wishes.smallest ? smallestEffects()
                           : wishes.quick  ? quickEffects()
                                           : EffectsOptions();
  options.only = wishes.effects;
  Result<EffectsResult> result = EffectsResult();
  {
    ProgressLine progress("Measuring");
    options.progress = [&](double fraction) {
      progress.show(fraction);
      return true;
    };
    result = studyEffects({scene->joint, scene->scenario, *input ? **input : Recording()}, options);
  }
  if (!result) return result.error();
  const std::string name = scene->scenario.name.empty() ? scene->scenario.id : scene->scenario.name;
  if (const auto saved = saveTables(*result, wishes, *scene); !saved) return saved;
  if (const auto saved = writePlot(effectsPlot(*result, name, machineWords()), inFolder(wishes.out, "price"));
      !saved)
    return saved;
  if (const auto saved = savePictures(*result, wishes.out); !saved) return saved;
  const std::string summary = effectsSummary(*result, name) + machineWords() + ".\n";
  if (const auto saved = writeWholeFile(inFolder(wishes.out, "summary.txt"), summary); !saved) return saved;
  std::fputs(summary.c_str(), stdout);
  return Done{};
}

}  // namespace

void addEffectsStudy(CLI::App& study, int& status) {
  auto wishes = std::make_shared<Wishes>();
  CLI::App* command = study.add_subcommand("effects",
                                           "What each effect costs, what a scene loses without it and where, "
                                           "and why auto has it on or off (up to 20 minutes)");
  command
      ->add_option("SCENARIO", wishes->scenario,
                   "A .scenario.json file, builtin:arthroscopy or builtin:palpation")
      ->required();
  command
      ->add_option("--out", wishes->out,
                   "Folder for tables (CSV, JSON), price.png, .svg and .pdf, a picture of each loss and "
                   "summary.txt; made where it is not there")
      ->required();
  command->add_option("--effects", wishes->effects, "Only these, such as friction,dent")->delimiter(',');
  command->add_option("--input", wishes->input,
                      "Hands over time: a .recording; without it the scenario's own");
  command->add_flag("--quick", wishes->quick, "Fewer and shorter windows: five minutes at most");
  command->add_flag("--smallest", wishes->smallest, "For tests")->group("");
  command->callback([wishes, &status] {
    const Result<Done> done = effects(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
