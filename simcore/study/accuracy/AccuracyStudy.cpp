// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/accuracy/AccuracyStudy.h"

#include <algorithm>
#include <cmath>

#include "simcore/study/accuracy/AccuracyShards.h"
#include "simcore/study/accuracy/AccuracyTimes.h"

namespace glenoid {
namespace {

using Traces = std::vector<AccuracyTrace>;

Error cancelled() { return {Fault::Cancelled, {}, {}, "study of accuracy"}; }

long tetrahedraOf(const Model& model) {
  long count = 0;
  for (const SceneObject& object : model.objects) count += object.authoredTets;
  return count;
}

/// What is the same for every setting.
struct Ground {
  const StudyScene& scene;
  const AccuracyOptions& options;
  std::shared_ptr<const Model> base;
  WindowWishes wishes;
  std::vector<AccuracyWindow> windows;
  std::vector<std::size_t> few;              ///< the windows of slow settings
  std::map<std::string, Joint> joints = {};  ///< that were made for settings, by what made them
  double done = 0, whole = 1;                ///< share of the work, by a rough guess

  bool goOn(const std::string& what, double share = 0) const { return !options.progress || options.progress(what, std::min(1.0, (done + share) / whole)); }
};

std::string jointKey(const AccuracySetting& setting) {
  return std::to_string(setting.cells) + (setting.visualContact ? " visual" : "");
}

Result<std::unique_ptr<AccuracyPlayer>> playerOf(Ground& ground, const AccuracySetting& setting) {
  const std::string key = jointKey(setting);
  auto joint = ground.joints.find(key);
  if (joint == ground.joints.end()) {
    Result<Joint> made = jointWith(setting, ground.scene.joint);
    if (!made) return made.error();
    joint = ground.joints.emplace(key, std::move(*made)).first;
  }
  const auto model = compileModel(joint->second, scenarioWith(setting, ground.scene.scenario));
  if (!model) return model.error();
  return std::make_unique<AccuracyPlayer>(ground.base, *model, stepperWith(setting), ground.scene.input);
}

/// Steps of these take ten to a hundred times as long as those of the others: known beforehand, so that what is compared does not depend on
/// the machine.
bool isSlow(const AccuracySetting& setting) { return setting.profile != Profile::Direct || setting.visualContact; }

std::vector<std::size_t> windowsOf(const Ground& ground, const AccuracySetting& setting) {
  if (isSlow(setting)) return ground.few;
  std::vector<std::size_t> all(ground.windows.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
  return all;
}

Result<Traces> playAll(Ground& ground, AccuracyPlayer& player, const std::string& what, const std::vector<std::size_t>& which) {
  Traces traces;
  for (const std::size_t k : which) {
    if (!ground.goOn(what, static_cast<double>(traces.size()) / static_cast<double>(which.size()))) return cancelled();
    traces.push_back(player.play(ground.windows[k], ground.wishes));
  }
  return traces;
}

Traces those(const Traces& traces, const std::vector<std::size_t>& which) {
  Traces chosen;
  for (const std::size_t k : which) chosen.push_back(traces[k]);
  return chosen;
}

/// What another solver answers in the scene's own steps.
Result<Done> checkSolver(Ground& ground, const AccuracySetting& scene, AccuracyReference& reference) {
  std::array<Traces, 2> traces;
  for (const std::size_t k : {0, 1}) {
    AccuracySetting setting = scene;
    setting.profile = k ? Profile::Reference : Profile::Direct;
    auto player = playerOf(ground, setting);
    if (!player) return player.error();
    Result<Traces> played = playAll(ground, **player, "check of the reference", ground.few);
    if (!played) return played.error();
    traces[k] = std::move(*played);
  }
  reference.check = errorsOf(*ground.base, traces[0], traces[1]);
  for (std::size_t q = 0; q < reference.floor.by.size(); ++q)
    if (reference.check->by[q].value > reference.floor.by[q].value) reference.floor.by[q] = reference.check->by[q];
  return Done{};
}

/// Both refinements of one reference; the traces of the last are what settings are compared with.
Result<Done> makeReference(Ground& ground, AccuracyAgainst against, const AccuracySetting& scene, AccuracyReference& reference, Traces& traces) {
  const bool finer = against == AccuracyAgainst::FinerCells;
  const AccuracyOptions& options = ground.options;
  Traces coarse;
  for (const std::size_t k : {0, 1}) {
    AccuracySetting setting = scene;
    setting.family = "reference";
    setting.profile = Profile::Direct;
    setting.cells = finer ? options.cells[k] : 1;
    setting.dt = scene.dt / (finer ? options.cuts[k] : options.ownCuts[k]);
    nameSetting(setting, scene);
    (k ? reference.finest : reference.coarser) = setting;
    auto player = playerOf(ground, setting);
    if (!player && player.error().fault == Fault::Cancelled) return player.error();
    if (!player) {
      reference.missing = player.error();
      return Done{};
    }
    std::vector<std::size_t> all(ground.windows.size());
    for (std::size_t w = 0; w < all.size(); ++w) all[w] = w;
    Result<Traces> played = playAll(ground, **player, setting.id, all);
    if (!played) return played.error();
    ground.done += 1;
    for (const AccuracyTrace& trace : *played)
      if (trace.notTaken > 0) {
        reference.missing = Error{Fault::Unusable, {}, {"a reference whose steps are not finite"}, setting.id};
        return Done{};
      }
    reference.tetrahedra = tetrahedraOf((*player)->model());
    (k ? traces : coarse) = std::move(*played);
  }
  reference.floor = errorsOf(*ground.base, coarse, traces);
  return finer ? Done{} : checkSolver(ground, scene, reference);
}

void sumUp(AccuracyRow& row, const Traces& traces, double sceneDt) {
  long notTaken = 0, diverged = 0;
  double cpuMs = 0;
  for (const AccuracyTrace& trace : traces) {
    row.steps += trace.steps;
    row.cappedSteps += trace.capped;
    row.unsolvedIslands += trace.unsolved;
    row.contacts += trace.contacts / static_cast<double>(traces.size());
    cpuMs += trace.cpuMs;
    notTaken += trace.notTaken;
    diverged += trace.diverged;
    if (trace.deepest > row.deepest) {
      row.deepest = trace.deepest;
      row.deepestWhere = trace.deepestWhere;
    }
  }
  if (row.steps > 0) row.roughWorkMs = cpuMs / static_cast<double>(row.steps) * sceneDt / row.setting.dt;
  if (notTaken > 0) row.failure = {"not-finite", {}, notTaken, row.steps};
  else if (diverged > 0) row.failure = {"diverged", {}, diverged, row.steps};
}

Timing scaled(Timing timing, double factor) {
  for (double* value : {&timing.median, &timing.p95, &timing.p99, &timing.p999, &timing.max}) *value *= factor;
  return timing;
}

const AccuracyRow* rowOf(const AccuracyResult& result, std::size_t index) {
  const auto found = std::find_if(result.rows.begin(), result.rows.end(),
                                  [&](const AccuracyRow& row) { return row.index == index; });
  return found == result.rows.end() ? nullptr : &*found;
}

}  // namespace

const char* againstKey(AccuracyAgainst against) { return against == AccuracyAgainst::FinerCells ? "finer-cells" : "own-cells"; }

AccuracyOptions quickAccuracy() {
  AccuracyOptions options;
  options.quick = true;
  options.windows.seconds = 0.1;
  options.secondsTimed = 0.5;
  options.slowWindows = 2;
  options.cells = {2, 4};
  options.cuts = {1, 2};
  options.ownCuts = {8, 16};
  return options;
}

Result<AccuracyResult> studyAccuracy(const StudyScene& scene, const AccuracyOptions& options) {
  const auto base = compileModel(scene.joint, scene.scenario);
  if (!base) return base.error();
  AccuracyResult result;
  result.scene = settingOf(**base);
  result.friction = (*base)->effectOn("friction");
  result.hands = !scene.scenario.tools.empty();
  result.repeats = options.repeats;
  result.wishes = options.windows;
  result.wishes.grid = 4 * scene.scenario.dt;
  result.wishes.seconds = std::max(1.0, std::round(options.windows.seconds / result.wishes.grid)) * result.wishes.grid;
  const std::vector<AccuracySetting> all = options.settings.empty() ? accuracySettings(**base, options.quick) : options.settings;
  std::vector<AccuracySetting> settings;
  std::vector<std::size_t> indices;
  for (std::size_t k = static_cast<std::size_t>(options.shard) - 1; k < all.size(); k += static_cast<std::size_t>(options.shards)) {
    settings.push_back(all[k]);
    indices.push_back(k);
  }
  result.settings = static_cast<long>(settings.size());

  Ground ground{scene, options, *base, result.wishes, {}, {}};
  ground.whole = 1.0 + 4.0 + 2.0 * static_cast<double>(settings.size());
  auto windows = findWindows(scene, *base, result.wishes, [&](double share) { return ground.goOn("windows", share); });
  if (!windows) return windows.error();
  ground.done += 1;
  ground.windows = std::move(*windows);
  const std::size_t few = std::min(ground.windows.size(), static_cast<std::size_t>(std::max(1, options.slowWindows)));
  for (std::size_t k = 0; k < few; ++k) ground.few.push_back((2 * k + 1) * ground.windows.size() / (2 * few));

  std::array<Traces, kAccuracyReferences> references;
  for (std::size_t r = 0; r < references.size(); ++r) {
    const auto made = makeReference(ground, static_cast<AccuracyAgainst>(r), result.scene, result.references[r], references[r]);
    if (!made) return made.error();
    if (result.references[r].missing) references[r].clear();
    if (options.told) options.told(result, std::nullopt);
  }

  result.windows = ground.windows;
  if (options.resume && !sameGround(*options.resume, result))
    return Error{Fault::Unusable,
                 {},
                 {"a study that was stopped and whose windows or references were others: go on with the same "
                  "build on the same instruction set"},
                 "resume"};
  const auto keep = [&]() -> Result<Done> { return options.keep ? options.keep(result) : Done{}; };
  if (const auto kept = keep(); !kept) return kept.error();

  const auto told = [&](std::size_t row) {
    if (options.told) options.told(result, row);
  };
  std::vector<std::unique_ptr<AccuracyPlayer>> players;
  for (const AccuracySetting& setting : settings) {
    const std::size_t index = indices[result.rows.size()];
    if (const AccuracyRow* known = options.resume ? rowOf(*options.resume, index) : nullptr) {
      result.rows.push_back(*known);
      result.rows.back().machine = options.machine;
      players.push_back(nullptr);
      if (known->failure.reason != "not-built") {
        auto player = playerOf(ground, setting);
        if (!player) return player.error();
        players.back() = std::move(*player);
      }
      ground.done += 1;
      continue;
    }
    AccuracyRow& row = result.rows.emplace_back();
    row.setting = setting;
    row.index = index;
    row.machine = options.machine;
    row.ownCells = hasOwnCells(setting, result.scene);
    if (!ground.goOn(setting.id)) return cancelled();
    auto player = playerOf(ground, setting);
    if (!player) {
      if (player.error().fault == Fault::Cancelled) return player.error();
      row.failure = {"not-built", player.error(), 0, 0};
      players.push_back(nullptr);
      ground.done += 1;
      if (const auto kept = keep(); !kept) return kept.error();
      told(result.rows.size() - 1);
      continue;
    }
    const std::vector<std::size_t> which = windowsOf(ground, setting);
    Result<Traces> traces = playAll(ground, **player, setting.id, which);
    if (!traces) return traces.error();
    ground.done += 1;
    row.windows = static_cast<int>(which.size());
    row.tetrahedra = tetrahedraOf((*player)->model());
    sumUp(row, *traces, result.scene.dt);
    for (std::size_t r = 0; r < references.size(); ++r) {
      if (references[r].empty() || (static_cast<AccuracyAgainst>(r) == AccuracyAgainst::OwnCells && !row.ownCells)) continue;
      row.errors[r] = errorsOf(**base, *traces, those(references[r], which));
    }
    players.push_back(std::move(*player));
    if (const auto kept = keep(); !kept) return kept.error();
    told(result.rows.size() - 1);
  }

  // A setting that breaks down is timed too: what it cost until then is part of why it is no good.
  const auto take = [&](std::span<const StepTimes> times) {
    for (std::size_t k = 0; k < result.rows.size(); ++k) {
      AccuracyRow& row = result.rows[k];
      row.cpu = times[k].cpu;
      row.wall = times[k].wall;
      row.timed = times[k].count;
      row.work = scaled(row.cpu, result.scene.dt / row.setting.dt);
    }
  };
  std::function<void(std::span<const StepTimes>)> soFar;
  if (options.told)
    soFar = [&](std::span<const StepTimes> times) {
      take(times);
      for (std::size_t k = 0; k < result.rows.size(); ++k) told(k);
    };
  const std::vector<StepTimes> times = timeInterleaved(
      players, ground.windows, options, [&](double share) { return ground.goOn("times", share * static_cast<double>(settings.size())); }, soFar);
  if (times.empty()) return cancelled();
  take(times);
  return result;
}

}  // namespace glenoid
