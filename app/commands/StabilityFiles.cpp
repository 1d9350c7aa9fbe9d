// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/StabilityFiles.h"

#include <algorithm>
#include <cmath>

#include "app/Resources.h"
#include "app/commands/Console.h"
#include "app/commands/OpenScene.h"
#include "app/commands/Picture.h"
#include "app/commands/StudyFiles.h"
#include "app/commands/TableText.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/file/JsonObject.h"
#include "simcore/live/BuildId.h"
#include "simcore/live/RunReport.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ResourcePaths.h"
#include "simcore/scene/SceneWords.h"
#include "simcore/study/Machine.h"

namespace glenoid {
namespace {

const std::string kMark = "gauntlet: ";

std::string profileWord(Profile profile) { return scene_words::wordOf(scene_words::kProfiles, profile); }

std::string fileStem(const StabilityVerdict& verdict) {
  return verdict.trial.id() + (verdict.counts ? "" : "." + profileWord(verdict.profile));
}

Recording recordingOf(const StabilityVerdict& verdict, const std::string& scene) {
  Recording recording;
  recording.scenario = scene;
  recording.dt = verdict.trial.dt;
  recording.profile = profileWord(verdict.profile);
  recording.seed = verdict.model->scenario.seed;
  recording.steps = verdict.figures.steps;
  recording.marks = {{kMark + verdict.trial.id(), 0, static_cast<double>(verdict.figures.steps) * verdict.trial.dt, "", ""}};
  recording.jointHash = verdict.model->jointHash;
  recording.build = buildId();
  recording.isa = kernelIsa(false);
  recording.stateHash = toHex(stateHash(verdict.figures.end));
  return recording;
}

std::string oneLine(const StabilityVerdict& verdict) {
  const StabilityFigures& f = verdict.figures;
  std::string words;
  for (const std::string& word : verdict.broken) words += (words.empty() ? "" : ", ") + word;
  if (verdict.held()) words = verdict.carried.share > 1 ? "held, cannot carry itself" : "held";
  return text("%-56s %-7s %-28s energy %+7.4f  depth %7.3f mm (%5.2f of its bound)  recovery %5.2f s  end %8.1e m/s  inside out %3d, %d at the end\n",
              verdict.trial.id().c_str(), profileWord(verdict.profile).c_str(), words.c_str(), f.energyExcess, 1e3 * f.depth, f.depthShare, f.secondsToRest,
              f.restSpeed, f.insideOut, f.insideOutEnd);
}

}  // namespace

StudyTable stabilitySummary(std::span<const StabilityVerdict> verdicts) {
  StudyTable table;
  table.id = "cases";
  const bool paper = std::any_of(verdicts.begin(), verdicts.end(), [](const auto& verdict) { return !verdict.counts; });
  table.columns = {"case", "trials", "held", "energyExcess", "depthMm", "depthOfBound", "recoveryS", "insideOutMost", "insideOutEnd"};
  if (paper) table.columns.insert(table.columns.end(), {"paperTrials", "paperHeld"});
  for (const StabilityCase& one : stabilityCases()) {
    long trials = 0, held = 0, paperTrials = 0, paperHeld = 0, insideOut = 0, insideOutEnd = 0;
    double excess = 0, depth = 0, share = 0, recovery = 0;
    for (const StabilityVerdict& verdict : verdicts) {
      if (verdict.trial.what != &one) continue;
      (verdict.counts ? trials : paperTrials) += 1;
      (verdict.counts ? held : paperHeld) += verdict.held();
      if (!verdict.counts) continue;
      const StabilityFigures& f = verdict.figures;
      excess = std::max(excess, f.energyExcess);
      depth = std::max(depth, 1e3 * f.depth);
      share = std::max(share, f.depthShare);
      recovery = std::max(recovery, f.secondsToRest);
      insideOut = std::max<long>(insideOut, f.insideOut);
      insideOutEnd = std::max<long>(insideOutEnd, f.insideOutEnd);
    }
    if (trials + paperTrials == 0) continue;
    table.rows.push_back({std::string(one.id), trials, held, excess, depth, share, recovery, insideOut, insideOutEnd});
    if (paper) table.rows.back().insert(table.rows.back().end(), {StudyCell(paperTrials), StudyCell(paperHeld)});
  }
  return table;
}

std::string stabilitySentences(const StabilityVerdict& verdict) {
  const StabilityFigures& f = verdict.figures;
  std::string out;
  for (const std::string& word : verdict.broken) {
    if (!out.empty()) out += " ";
    if (word == "not-finite") out += text("After %ld steps the state is not finite.", f.steps);
    else if (word == "rejected-steps") out += text("%ld of %ld steps were not finite and not taken.", f.rejected, f.steps);
    else if (word == "energy")
      out += text("It holds %.3g J, %.1f %%, more than what it had and what was done to it.", f.energyGained, 100 * f.energyExcess);
    else if (word == "depth") out += text("%s lie deeper in each other than they may, %.2f times as deep.", f.depthPair.c_str(), f.depthShare);
    else if (word == "inside-out") out += text("%d elements are still inside out.", f.insideOutEnd);
    else if (word == "too-deep-at-end") out += text("At the end surfaces still lie %.2f mm in each other.", 1e3 * f.depthEnd);
    else if (word == "not-at-rest") out += text("It was beyond its bounds of rest until %.2f s after the load; at the end its fastest point moves at %.1f mm/s.", f.secondsToRest, 1e3 * f.restSpeed);
    else if (word == "time-up") out += text("It took too long and was stopped after %.2f s of simulated time.", static_cast<double>(f.steps) * verdict.trial.dt);
  }
  if (verdict.carried.share > 1 && f.timeUp) out += text("%sIt took too long and was stopped after %.2f s of simulated time.", out.empty() ? "" : " ", static_cast<double>(f.steps) * verdict.trial.dt);
  if (verdict.carried.share > 1)
    out += text("%sThe matter of %s cannot carry its weight and its loads, which are %.3g times Young's modulus times its section: it need not come to rest.",
                out.empty() ? "" : " ", verdict.carried.part.c_str(), verdict.carried.share);
  return out;
}

std::string stabilityText(std::span<const StabilityVerdict> verdicts, const StabilityOptions& options, const std::string& scene) {
  std::string out = text("The gauntlet of %s\nBuild %s on %s, kernels %s, %d threads.\n", scene.c_str(), buildId(), processorName().c_str(), kernelIsa(false),
                         options.threads);
  StudyTable summary = stabilitySummary(verdicts);
  summary.facts = stabilityTable(verdicts, options).facts;
  out += tableText(summary, "Cases: worst figures of the trials that count");
  out += "Energy: beyond what there was and what was put in, of the most that this was. Recovery: from the end of the load until nothing moves faster than\n"
         "1 mm/s, is inside out or too deep. A trial holds with energy, depth and recovery within their bounds, every step taken, nothing inside out at the end.\n";
  for (const bool held : {false, true})
    for (const StabilityVerdict& verdict : verdicts)
      if (const std::string why = stabilitySentences(verdict); verdict.held() == held && !why.empty())
        out += text("\n%s (%s): %s", verdict.trial.id().c_str(), profileWord(verdict.profile).c_str(), why.c_str());
  out += "\n\nTrials\n";
  for (const StabilityVerdict& verdict : verdicts) out += oneLine(verdict);
  return out;
}

Result<Done> writeStability(const std::string& folder, std::span<const StabilityVerdict> verdicts, const StabilityOptions& options,
                            const std::string& scene) {
  const StudyTable table = stabilityTable(verdicts, options);
  if (const auto done = writeWholeFile(folder + "/stability.csv", tableCsv(table)); !done) return done;
  JsonValue json = jsonObject({{"build", buildId()}, {"isa", kernelIsa(false)}, {"processor", processorName()}, {"threads", options.threads},
                               {"scene", scene}, {"extent", options.quick ? "quick" : "full"}});
  JsonValue tables = JsonValue::array();
  tables.append(tableJson(table));
  tables.append(tableJson(stabilitySummary(verdicts)));
  json.set("tables", std::move(tables));
  if (const auto done = writeWholeFile(folder + "/stability.json", toText(json)); !done) return done;
  return writeWholeFile(folder + "/stability.txt", stabilityText(verdicts, options, scene));
}

Result<Done> writeFailure(const std::string& folder, const StabilityVerdict& verdict, const std::string& scene) {
  const std::string stem = folder + "/" + fileStem(verdict);
  if (const auto done = saveRecording(recordingOf(verdict, scene), stem + ".recording"); !done) return done;
  if (!verdict.figures.finite) return Done{};
  PictureWishes picture;
  picture.out = stem + ".png";
  picture.width = 960, picture.height = 720;
  const auto drawn = drawPicture(*verdict.model, verdict.figures.end, verdict.figures.contacts, picture, verdict.figures.dents);
  if (!drawn && drawn.error().fault != Fault::NoGraphics) return drawn;
  return Done{};
}

std::optional<std::string> stabilityTrialIn(const Recording& recording) {
  for (const RecordingMark& mark : recording.marks)
    if (mark.name.compare(0, kMark.size(), kMark) == 0) return mark.name.substr(kMark.size());
  return std::nullopt;
}

Result<StabilityScene> openStabilityScene(const std::string& word) {
  if (namesJoint(word)) {
    Result<Joint> joint = openJoint(word);
    if (!joint) return joint.error();
    return stabilityScene(std::move(*joint), std::nullopt);
  }
  Result<OpenScene> scene = openScenario(word);
  if (!scene) return scene.error();
  return stabilityScene(std::move(scene->joint), scene->scenario);
}

Result<StabilityAgain> openStabilityAgain(const Recording& recording) {
  const std::string id = stabilityTrialIn(recording).value_or("");
  const auto profile = profileNamed(recording.profile);
  if (!profile) return Error{Fault::UnknownId, {}, {recording.profile, "profile"}, "replay"};
  const Result<StabilityScene> scene = openStabilityScene(recording.scenario);
  if (!scene) return scene.error();
  auto stage = StabilityStage::make(*scene, *profile);
  if (!stage) return stage.error();
  const std::vector<StabilityTrial> trials = (*stage)->trials(false);
  const auto trial = std::find_if(trials.begin(), trials.end(), [&](const StabilityTrial& one) { return one.id() == id; });
  if (trial == trials.end()) return Error{Fault::UnknownId, {}, {id, "trial of the gauntlet"}, "replay"};
  Result<StabilityRun> run = (*stage)->runOf(*trial);
  if (!run) return run.error();
  run->seconds = (static_cast<double>(recording.steps) - 0.5) * trial->dt;
  run->quiet = 0;
  return StabilityAgain{std::move(*stage), *trial, std::move(*run)};
}

Result<StabilityVerdict> repeatStability(const Recording& recording) {
  const Result<StabilityAgain> again = openStabilityAgain(recording);
  if (!again) return again.error();
  StabilityVerdict verdict;
  verdict.trial = again->trial;
  verdict.profile = again->stage->profile();
  verdict.carried = again->stage->carried(again->trial);
  verdict.figures = measureStability(again->run);
  verdict.broken = brokenBounds(again->run, verdict.figures, verdict.carried.share <= 1);
  verdict.model = again->run.model;
  return verdict;
}

}  // namespace glenoid
