// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/Resources.h"
#include "app/commands/AccuracyText.h"
#include "app/commands/Console.h"
#include "app/commands/OpenScene.h"
#include "app/commands/StudyCommand.h"
#include "app/commands/StudyFiles.h"
#include "app/commands/StudyNews.h"
#include "app/commands/SweepFiles.h"
#include "app/commands/TableText.h"
#include "app/plot/PlotFile.h"
#include "editor/core/Sentences.h"
#include "simcore/base/Hash.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Json.h"
#include "simcore/file/JsonObject.h"
#include "simcore/live/BuildId.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ResourcePaths.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/scene/ScenarioJson.h"
#include "simcore/study/accuracy/AccuracyShards.h"
#include "simcore/study/accuracy/AccuracyTables.h"

namespace glenoid {
namespace {

struct Wishes {
  std::string scenario, out, budget, accuracy, against = "own-cells", by, input, shard;
  bool quick = false, smallest = false, merge = false, resume = false, status = false;
};

std::optional<AccuracyQuantity> quantityNamed(const std::string& word) {
  if (word == "displacement") return AccuracyQuantity::Displacement;
  if (word == "contact-force") return AccuracyQuantity::ContactForce;
  if (word == "penetration") return AccuracyQuantity::Penetration;
  if (word == "hand-force") return AccuracyQuantity::HandForce;
  return std::nullopt;
}

const char* quantityFile(AccuracyQuantity quantity) {
  switch (quantity) {
    case AccuracyQuantity::Displacement: return "displacement";
    case AccuracyQuantity::ContactForce: return "contact-force";
    case AccuracyQuantity::Penetration: return "penetration";
    case AccuracyQuantity::HandForce: return "hand-force";
  }
  return "";
}

/// "0.5mm" is of a length, "0.2N" of a force; --by says of which where there are two.
Result<AccuracyWish> wishOf(const Wishes& wishes, bool hands) {
  AccuracyWish wish;
  wish.view.against = wishes.against == "own-cells" ? AccuracyAgainst::OwnCells : AccuracyAgainst::FinerCells;
  const bool force = wishes.accuracy.size() > 1 && wishes.accuracy.back() == 'N';
  if (!wishes.by.empty()) wish.view.quantity = *quantityNamed(wishes.by);
  else if (force) wish.view.quantity = hands ? AccuracyQuantity::HandForce : AccuracyQuantity::ContactForce;
  if (wish.view.quantity == AccuracyQuantity::HandForce && !hands) return usageError("--by hand-force wants a scenario with a tool, which somebody holds");
  if (!wishes.budget.empty()) {
    const Result<double> seconds = durationNamed("--budget", wishes.budget);
    if (!seconds) return usageError("--budget wants a time above zero, such as 1ms or 0.005s, not “" + wishes.budget + "”");
    wish.budgetMs = 1e3 * *seconds;
  }
  if (wishes.accuracy.empty()) return wish;
  const bool wantsForce = wish.view.quantity == AccuracyQuantity::ContactForce || wish.view.quantity == AccuracyQuantity::HandForce;
  if (wantsForce != force) return usageError("--accuracy " + wishes.accuracy + " is no " + quantityWords(wish.view.quantity) + ": lengths are in mm, such as 0.5mm, forces in N, such as 0.2N");
  const Result<double> value = lengthNamed("--accuracy", force ? wishes.accuracy.substr(0, wishes.accuracy.size() - 1) : wishes.accuracy);
  if (!value || !std::isfinite(*value)) return usageError("--accuracy wants an error above zero, such as 0.5mm or 0.2N, not “" + wishes.accuracy + "”");
  wish.accuracy = *value;
  return wish;
}

/// For tests of the command: three settings, two windows, references that are cheap.
AccuracyOptions smallestAccuracy() {
  AccuracyOptions options = quickAccuracy();
  options.windows.count = 2;
  options.windows.seconds = 0.02;
  options.ownCuts = {2, 4};
  options.cells = {1.2, 1.5};
  options.cuts = {1, 1};
  options.secondsTimed = 0.05;
  options.slowWindows = 1;
  return options;
}

Result<Done> saveTables(const AccuracyResult& result, const Wishes& wishes, const OpenScene& scene) {
  JsonValue json = machineJson();
  json.set("study", "accuracy");
  json.set("scenario", wishes.scenario);
  json.set("jointHash", jointHash(scene.joint));
  json.set("dt", scene.scenario.dt);
  json.set("quick", wishes.quick);
  json.set("friction", result.friction);
  json.set("repeats", result.repeats);
  JsonValue tables = JsonValue::array();
  for (const StudyTable& table : accuracyTables(result)) {
    tables.append(tableJson(table));
    if (const auto saved = writeWholeFile(inFolder(wishes.out, table.id + ".csv"), tableCsv(table)); !saved) return saved;
  }
  json.set("tables", std::move(tables));
  return writeJson(inFolder(wishes.out, "accuracy.json"), json);
}

Result<Done> savePlots(const AccuracyResult& result, const Wishes& wishes, const std::string& scene, const AccuracyView& view, std::optional<std::size_t> chosen) {
  for (int r = 0; r < kAccuracyReferences; ++r)
    for (int q = 0; q < kAccuracyQuantities; ++q) {
      const AccuracyView each{static_cast<AccuracyAgainst>(r), static_cast<AccuracyQuantity>(q)};
      if (result.reference(each.against).missing || (each.quantity == AccuracyQuantity::HandForce && !result.hands)) continue;
      const bool chosenHere = each.against == view.against && each.quantity == view.quantity;
      const LogLogPlot plot = accuracyPlot(result, scene, each, chosenHere ? chosen : std::nullopt, machineWords());
      const std::string stem = std::string(quantityFile(each.quantity)) + "-" + againstKey(each.against);
      if (const auto saved = writePlot(plot, inFolder(wishes.out, stem)); !saved) return saved;
    }
  return Done{};
}

/// chosen.scenario.json, with a joint of its own where cells or surfaces are not the scene's.
Result<Done> saveChosen(const AccuracySetting& setting, const OpenScene& scene, const Wishes& wishes) {
  const Result<std::string> path = resolveScenario(wishes.scenario, "", resourceRoot());
  if (!path) return path.error();
  Scenario scenario = scenarioWith(setting, scene.scenario);
  scenario.description += (scenario.description.empty() ? "" : " ") + std::string("Chosen by “glenoid study accuracy”: ") + setting.id + ".";
  scenario.input = movedReference(scenario.input, folderOf(*path), wishes.out);
  scenario.joint = movedReference(scenario.joint, folderOf(*path), wishes.out);
  if (setting.cells != 1 || setting.visualContact) {
    const Result<Joint> joint = jointWith(setting, scene.joint);
    if (!joint) return joint.error();
    if (const auto saved = saveJoint(*joint, inFolder(wishes.out, "chosen.joint")); !saved) return saved;
    scenario.joint = "chosen.joint";
  }
  return saveScenario(scenario, inFolder(wishes.out, "chosen.scenario.json"));
}

/// "3/16": the third of sixteen.
Result<Done> setShard(const std::string& word, AccuracyOptions& options) {
  if (word.empty()) return Done{};
  int end = 0;
  if (std::sscanf(word.c_str(), "%d/%d%n", &options.shard, &options.shards, &end) != 2 || end != static_cast<int>(word.size()) || options.shards < 1 ||
      options.shards > 1000 || options.shard < 1 || options.shard > options.shards)
    return usageError("--shard wants a part and how many there are, such as 3/16, not “" + word + "”");
  return Done{};
}

std::string hashed(const std::string& words) {
  return toHex(hashBytes(words.data(), words.size()));
}

/// Where hands are over time, as far as a run is moved by it.
std::string handsHash(const Recording& input) {
  std::string tools;
  std::vector<double> keys;
  for (const HandTrack& track : input.tracks) {
    tools += track.tool + "/";
    for (const auto& key : track.keys) {
      keys.push_back(key.time);
      const Vec3& p = key.hand.p_WB;
      const Quat& q = key.hand.q_WB;
      keys.insert(keys.end(), {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
    }
  }
  return hashed(tools + toHex(hashDoubles(keys)));
}

/// Of what a part of a sweep is: only what agrees in all of it belongs together.
JsonValue sweepOf(const StudyScene& study, const Wishes& wishes) {
  return jsonObject({{"study", "accuracy"},
                     {"joint", jointHash(study.joint)},
                     {"scenario", hashed(toText(scene_json::fromScenario(study.scenario)))},
                     {"hands", handsHash(study.input)},
                     {"extent", wishes.smallest ? "smallest"
                                : wishes.quick  ? "quick"
                                                : "full"},
                     {"build", buildId()},
                     {"isa", kernelIsa(false)}});
}

/// Measures a part or all, keeping what is there as it goes on. Nothing where this part was done before.
Result<std::optional<AccuracyResult>> measure(const Wishes& wishes, const StudyScene& study,
                                              AccuracyOptions& options) {
  SweepFiles files(wishes.out, options.shard, wishes.shard.empty() ? 0 : options.shards,
                   sweepOf(study, wishes));
  const Result<bool> done = files.isDone();
  if (!done) return done.error();
  if (*done) {  // written whole or not at all
    std::printf("%s is there already.\n", files.shardPath().c_str());
    return std::optional<AccuracyResult>();
  }
  std::optional<AccuracyResult> before;
  if (wishes.resume) {
    const Result<std::optional<JsonValue>> left = files.left();
    if (!left) return left.error();
    if (*left) {
      const auto base = compileModel(study.joint, study.scenario);
      if (!base) return base.error();
      Result<AccuracyResult> read =
          accuracyResult(**left, settingOf(**base), accuracySettings(**base, options.quick));
      if (!read) return read.error();
      before = std::move(*read);
      options.resume = &*before;
      std::printf("Going on after %zu settings.\n", before->rows.size());
    }
  }
  if (const auto begun = files.begin(0); !begun) return begun.error();
  options.keep = [&](const AccuracyResult& soFar) -> Result<Done> {
    if (before && soFar.rows.size() < before->rows.size()) return Done{};  // those are kept
    return files.keep(toJson(soFar), static_cast<long>(soFar.rows.size()), soFar.settings);
  };
  Result<AccuracyResult> result = studyAccuracy(study, options);
  if (!result) {
    files.fail(sentenceOf(result.error()).toStdString());
    return result.error();
  }
  // Of a sweep in one part the copy to go on from stays until its tables and plots are there.
  if (!wishes.shard.empty())
    if (const auto finished = files.finish(toJson(*result)); !finished) return finished.error();
  return std::optional<AccuracyResult>(std::move(*result));
}

/// All shards of a folder as one study.
Result<AccuracyResult> mergedIn(const std::string& folder, const StudyScene& study, const Wishes& wishes) {
  const bool quick = wishes.quick || wishes.smallest;
  const JsonValue of = sweepOf(study, wishes);
  const auto base = compileModel(study.joint, study.scenario);
  if (!base) return base.error();
  const std::vector<AccuracySetting> settings = accuracySettings(**base, quick);
  std::vector<std::string> paths;
  std::error_code failed;
  for (std::filesystem::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    const std::string leaf = it->path().filename().string();
    if (leaf.rfind("shard-", 0) == 0 && leaf.ends_with(".json") && leaf.find('.') + 5 == leaf.size())
      paths.push_back(it->path().string());
  }
  std::sort(paths.begin(), paths.end());
  if (paths.empty()) return Error{Fault::FileMissing, {inFolder(folder, "shard-1-of-….json"), "", "", {}}, {}, "study"};
  std::vector<AccuracyResult> shards;
  for (const std::string& path : paths) {
    const Result<JsonValue> json = readJson(path);
    if (!json) return json.error();
    // A merge measures nothing, so another build may do it.
    for (const char* same : {"study", "joint", "scenario", "hands", "extent"})
      if ((*json)["of"][same] != of[same])
        return Error{Fault::BadUsage,
                     {path, "", "", {}},
                     {std::string("this shard is of something else (its “") + same + "” is another)"},
                     "merge"};
    Result<AccuracyResult> shard = accuracyResult(*json, settingOf(**base), settings);
    if (!shard) {
      Error error = shard.error();
      error.place.file = path;
      return error;
    }
    shards.push_back(std::move(*shard));
  }
  Result<AccuracyResult> merged = mergedShards(shards, settings.size());
  if (merged) return merged;
  Error error = merged.error();
  error.place.file = folder;
  return error;
}

/// How far the parts of a sweep are; fails with CheckFailed while one is missing.
Result<Done> showStatus(const std::string& folder) {
  const Result<SweepStatus> status = sweepStatus(folder);
  if (!status) return status.error();
  std::fputs(status->words.c_str(), stdout);
  return status->done ? Result<Done>(Done{})
                      : Error{Fault::CheckFailed, {folder, "", "", {}}, {"the sweep is not whole"}, "sweep"};
}

JsonValue newsOf(const Wishes& wishes, const OpenScene& scene, const std::optional<Recording>& input) {
  JsonValue json = machineJson();
  json.set("study", "accuracy");
  json.set("scenario", wishes.scenario);
  json.set("dtMs", 1e3 * scene.scenario.dt);
  json.set("quick", wishes.quick || wishes.smallest);
  json.set("hands", !scene.scenario.tools.empty());
  json.set("recording", input.has_value());
  return json;
}

/// The study itself and its files. `news`: null where nobody could follow.
Result<Done> studied(const Wishes& wishes, const AccuracyWish& wish, const OpenScene& scene, const std::optional<Recording>& input, AccuracyOptions options,
                     StudyNews* news) {
  ProgressLine progress("Measuring");
  options.progress = [&](const std::string& what, double fraction) {
    progress.show(fraction);
    if (news) news->progress(what, fraction);
    return true;
  };
  if (news)
    options.told = [&](const AccuracyResult& result, std::optional<std::size_t> row) {
      const std::vector<StudyTable> tables = accuracyTables(result);
      if (row) news->row(tables[0], *row, jsonObject({{"roughWorkMs", result.rows[*row].roughWorkMs}, {"ownCells", result.rows[*row].ownCells}}));
      else news->table(tables[1]);
    };
  const StudyScene study{scene.joint, scene.scenario, input ? *input : Recording()};
  std::optional<AccuracyResult> result;
  if (wishes.merge) {
    Result<AccuracyResult> merged = mergedIn(wishes.out, study, wishes);
    if (!merged) return merged.error();
    result = std::move(*merged);
  } else {
    Result<std::optional<AccuracyResult>> measured = measure(wishes, study, options);
    if (!measured) return measured.error();
    result = std::move(*measured);
  }
  if (!wishes.shard.empty()) return Done{};
  const Result<std::optional<std::size_t>> chosen = chosenSetting(*result, wish);
  const std::optional<std::size_t> row = chosen ? *chosen : std::nullopt;
  const std::string name = scene.scenario.name.empty() ? scene.scenario.id : scene.scenario.name;
  if (const auto saved = saveTables(*result, wishes, scene); !saved) return saved;
  if (news) news->documentIsThere();
  else std::remove(inFolder(wishes.out, kStudyNews).c_str());  // put together from shards: what an older study said here is not of it
  if (const auto saved = savePlots(*result, wishes, name, wish.view, row); !saved) return saved;
  if (row)
    if (const auto saved = saveChosen(result->rows[*row].setting, scene, wishes); !saved) return saved;
  std::string summary = accuracySummary(*result, name, wish.view, row) + machineWords() + ".\n";
  if (row) summary += "Written to " + inFolder(wishes.out, "chosen.scenario.json") + ".\n";
  if (const auto saved = writeWholeFile(inFolder(wishes.out, "summary.txt"), summary); !saved) return saved;
  if (!wishes.merge)
    if (const auto finished = SweepFiles(wishes.out, options.shard, 0, sweepOf(study, wishes)).finish(toJson(*result)); !finished) return finished;
  std::fputs(summary.c_str(), stdout);
  return chosen ? Result<Done>(Done{}) : Result<Done>(chosen.error());
}

Result<Done> accuracy(const Wishes& wishes) {
  if (wishes.status) return showStatus(wishes.out);
  if (wishes.resume && wishes.merge)
    return usageError("--merge measures nothing, so there is nothing to go on with");
  if (!wishes.shard.empty() && (wishes.merge || !wishes.budget.empty() || !wishes.accuracy.empty()))
    return usageError("--shard measures a part only; --merge, --budget and --accuracy come when all parts are there");
  if (!wishes.budget.empty() && !wishes.accuracy.empty()) return usageError("--budget and --accuracy choose in two ways; give one of them");
  Result<OpenScene> scene = openScenario(wishes.scenario);
  if (!scene) return scene.error();
  const Result<AccuracyWish> wish = wishOf(wishes, !scene->scenario.tools.empty());
  if (!wish) return wish.error();
  const Result<std::optional<Recording>> input = openInput(wishes.input, wishes.scenario, scene->scenario);
  if (!input) return input.error();
  if (const auto good = prepareFolder(wishes.out); !good) return good;

  AccuracyOptions options = wishes.smallest ? smallestAccuracy() : wishes.quick ? quickAccuracy() : AccuracyOptions();
  options.machine = machineWords();
  if (const auto set = setShard(wishes.shard, options); !set) return set.error();
  std::optional<StudyNews> news;  // of the whole study: shards beside each other would write over each other
  if (wishes.shard.empty() && !wishes.merge) news.emplace(wishes.out, newsOf(wishes, *scene, *input));
  const Result<Done> done = studied(wishes, *wish, *scene, *input, std::move(options), news ? &*news : nullptr);
  if (news) news->end(done);
  return done;
}

}  // namespace

void addAccuracyStudy(CLI::App& study, int& status) {
  auto wishes = std::make_shared<Wishes>();
  CLI::App* command = study.add_subcommand("accuracy", "Error beside milliseconds for many settings of a scene: tables and plots (up to 20 minutes)");
  command->add_option("SCENARIO", wishes->scenario, "A .scenario.json file, builtin:arthroscopy or builtin:palpation")->required();
  command->add_option("--out", wishes->out, "Folder for tables (CSV, JSON), plots (PNG, SVG, PDF) and summary.txt; made where it is not there")->required();
  command->add_option("--budget", wishes->budget,
                      "Choose the most accurate setting that computes one of the scene's time steps' worth within this, such as 1ms, in 95 of 100 "
                      "steps, and write chosen.scenario.json");
  command->add_option("--accuracy", wishes->accuracy, "Choose the fastest whose error is no more than this, such as 0.5mm or 0.2N, and write chosen.scenario.json");
  command->add_option("--by", wishes->by, "Error that counts for a choice: displacement (without this), contact-force, penetration or hand-force")
      ->check(CLI::IsMember({"displacement", "contact-force", "penetration", "hand-force"}));
  command->add_option("--against", wishes->against,
                      "Reference that counts for a choice: own-cells, where the solving alone counts, or finer-cells, where what cells and surfaces leave out "
                      "counts too")
      ->check(CLI::IsMember({"own-cells", "finer-cells"}));
  command->add_option("--input", wishes->input, "Hands over time: a .recording; without it the scenario's own");
  command->add_option("--shard", wishes->shard,
                      "Measure a part of the settings, such as 3/16, into shard-3-of-16.json; one that is "
                      "there is not measured again");
  command->add_flag("--resume", wishes->resume,
                    "Go on where a run of this folder and shard was stopped: settings that it finished are "
                    "not played again; without any left it begins");
  command->add_flag(
      "--status", wishes->status,
      "Measure nothing: say of each shard in the folder whether it is done; exit status 1 while one is not");
  command->add_flag("--merge", wishes->merge, "Measure nothing: put the shards in the folder together");
  command->add_flag("--quick", wishes->quick, "Fewer settings, shorter windows, coarser references: five minutes at most");
  command->add_flag("--smallest", wishes->smallest, "For tests")->group("");
  command->callback([wishes, &status] {
    const Result<Done> done = accuracy(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
