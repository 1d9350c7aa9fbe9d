// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/StudyTruthFiles.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands/Console.h"
#include "app/commands/StudyFiles.h"
#include "app/commands/TableText.h"
#include "app/plot/PlotFile.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Json.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/scene/SceneWords.h"
#include "simcore/study/truth/Membranes.h"

namespace glenoid {

using truth::TruthOptions;
using truth::TruthPoint;
using truth::TruthProblem;
using truth::TruthVerdict;

namespace {

constexpr double kStiffestSupport = 1e15;  ///< N/m per m², of the scenario's schema

std::string nameOf(const TruthVerdict& verdict) {
  return verdict.problem->byElements
             ? std::string(verdict.problem->id) + ", " + truth::elementsWord(verdict.elements)
             : std::string(verdict.problem->id);
}

/// "0.31 %", and what is only round-off as it is.
std::string share(double error) {
  return error < 1e-6 ? text("%.1e", error) : text("%.3g %%", 100 * error);
}

std::string orderWords(const TruthVerdict& verdict) {
  if (std::isnan(verdict.order)) return "";
  return verdict.orderBar > 0 ? text(", order %.2f (at least %.1f)", verdict.order, verdict.orderBar)
                              : text(", order %.2f", verdict.order);
}

std::string unitOf(const TruthProblem& problem) {
  return *problem.unit ? " " + std::string(problem.unit) : "";
}

/// Runs of verdicts of one problem.
std::vector<std::span<const TruthVerdict>> byProblem(std::span<const TruthVerdict> verdicts) {
  std::vector<std::span<const TruthVerdict>> runs;
  for (std::size_t begin = 0, end = 0; begin < verdicts.size(); begin = end) {
    for (end = begin + 1; end < verdicts.size() && verdicts[end].problem == verdicts[begin].problem;) ++end;
    runs.push_back(verdicts.subspan(begin, end - begin));
  }
  return runs;
}

}  // namespace

std::vector<TruthOther> truthByCalculix(std::span<const TruthVerdict> verdicts, const std::string& folder) {
  std::vector<TruthOther> others;
  if (!truth::hasCalculix()) return others;
  const std::string own = inFolder(folder, "calculix");
  std::error_code failed;
  std::filesystem::create_directories(own, failed);
  for (const auto run : byProblem(verdicts)) {
    const std::string id = run.front().problem->id;
    std::optional<Mat3> stress;
    if (id == "le1") stress = truth::stressByCalculix(truth::ellipticMembraneBricks(), 1, 0, 0, own, id);
    if (id == "le10") stress = truth::stressByCalculix(truth::thickPlateBricks(), 1, 0, 1, own, id);
    if (stress)
      others.push_back({id, (*stress)(1, 1), std::abs((*stress)(1, 1) / run.front().problem->known - 1)});
  }
  return others;
}

LogLogPlot truthPlot(std::span<const TruthVerdict> verdicts, std::span<const TruthOther> others,
                     const std::string& machine) {
  const TruthProblem& problem = *verdicts.front().problem;
  LogLogPlot plot;
  plot.title = problem.title;
  plot.subtitle = {
      std::string(problem.quantity) +
          (problem.known != 0 ? text(", known: %.6g", problem.known) + unitOf(problem) : std::string()) + ".",
      std::string(problem.source) + ".", machine + "."};
  plot.xTitle = std::string("Size of the ") + problem.refined +
                (*problem.refinedUnit ? std::string(", ") + problem.refinedUnit : std::string());
  plot.yTitle = "Error, as a share of what is known";
  plot.marginTitle = "No figure";
  for (const TruthVerdict& verdict : verdicts) {
    const std::string kind = problem.byElements ? truth::elementsWord(verdict.elements) : "found";
    PlotSeries series{kind + orderWords(verdict), {}, true, true};
    for (const TruthPoint& point : verdict.points) {
      if (!point.failure.empty()) {
        plot.margin.push_back({std::nan(""), text("%g", point.size), point.failure});
        continue;
      }
      // What has no error at all has no place on a logarithmic axis; it stands at round-off.
      series.points.push_back(
          {point.size, std::max(point.found.error, 1e-16), text("%.3g", point.found.value)});
    }
    plot.series.push_back(std::move(series));
    plot.levels.push_back({verdict.bar, verdicts.size() > 1 ? "bar, " + kind : "bar"});
  }
  for (const TruthOther& other : others)
    if (other.problem == problem.id && other.error > 0) plot.levels.push_back({other.error, "CalculiX"});
  return plot;
}

std::string truthSummaryText(std::span<const TruthVerdict> verdicts, std::span<const TruthOther> others) {
  std::string out;
  std::size_t met = 0;
  for (const TruthVerdict& verdict : verdicts) {
    const TruthProblem& problem = *verdict.problem;
    const TruthPoint& finest = verdict.points.back();
    met += verdict.met();
    out += text("%-36s %-6s ", nameOf(verdict).c_str(), verdict.met() ? "met" : "MISSED");
    if (!finest.failure.empty()) {
      out += finest.failure + "\n";
      continue;
    }
    if (problem.known != 0)
      out += text("%.6g%s beside %.6g: ", finest.found.value, unitOf(problem).c_str(), problem.known);
    out += text("error %s (bar %s)", share(finest.found.error).c_str(), share(verdict.bar).c_str()) +
           orderWords(verdict) + "\n";
  }
  for (const TruthOther& other : others)
    out += text("CalculiX, %s: %.6g, error %s\n", other.problem.c_str(), other.value,
                share(other.error).c_str());
  return out + text("%zu of %zu answers are within their bars.\n", met, verdicts.size());
}

Result<Done> writeTruth(const std::string& folder, std::span<const TruthVerdict> verdicts,
                        std::span<const TruthOther> others, const TruthOptions& options) {
  if (const auto saved = writeWholeFile(inFolder(folder, "truth.csv"), tableCsv(truth::truthTable(verdicts)));
      !saved)
    return saved;
  JsonValue json = machineJson();
  json.set("study", "truth");
  json.set("profile", scene_words::wordOf(scene_words::kProfiles, options.profile));
  json.set("quick", options.quick);
  JsonValue tables = JsonValue::array();
  tables.append(tableJson(truth::truthTable(verdicts)));
  tables.append(tableJson(truth::truthSummary(verdicts)));
  json.set("tables", std::move(tables));
  JsonValue beside = JsonValue::array();
  for (const TruthOther& other : others) {
    JsonValue one = JsonValue::object();
    one.set("program", "CalculiX");
    one.set("problem", other.problem);
    one.set("found", other.value);
    one.set("error", other.error);
    beside.append(std::move(one));
  }
  json.set("others", std::move(beside));
  if (const auto saved = writeWholeFile(inFolder(folder, "truth.json"), toText(json)); !saved) return saved;
  if (const auto saved = writeWholeFile(inFolder(folder, "summary.txt"),
                                        truthSummaryText(verdicts, others) + machineWords() + ".\n");
      !saved)
    return saved;
  for (const auto run : byProblem(verdicts))
    if (const auto saved =
            writePlot(truthPlot(run, others, machineWords()), inFolder(folder, run.front().problem->id));
        !saved)
      return saved;
  return Done{};
}

Result<Done> writeTruthScenes(const std::string& folder, std::span<const TruthVerdict> verdicts,
                              const TruthOptions& options) {
  const std::string own = inFolder(folder, "scenes");
  if (const auto good = prepareFolder(own); !good) return good;
  std::string why = "Scenes of problems with known answers, for “glenoid run” and the window.\n";
  for (const auto run : byProblem(verdicts)) {
    const TruthProblem& problem = *run.front().problem;
    if (!problem.scene) {
      why += text("%s: none, since %s.\n", problem.id, problem.noScene);
      continue;
    }
    const TruthVerdict& verdict = run.back();
    truth::TruthScene scene =
        problem.scene({verdict.elements, options.profile, 1}, verdict.points.back().size);
    scene.scenario.id = scene.joint.id = problem.id;
    scene.scenario.name = scene.joint.name = problem.title;
    scene.scenario.description =
        std::string(problem.quantity) +
        (problem.known != 0 ? text(": %.6g", problem.known) + unitOf(problem) : std::string(": none")) +
        ". " + problem.source + ".";
    scene.scenario.profile = options.profile;
    if (problem.byElements) scene.scenario.elements = verdict.elements;
    // Steel is held harder than a file may say; what it may is still hundreds of times as hard as the cells.
    for (Support& support : scene.scenario.supports)
      support.stiffnessPerArea = std::min(support.stiffnessPerArea, kStiffestSupport);
    scene.scenario.joint = std::string(problem.id) + ".joint";
    if (const auto saved = saveJoint(scene.joint, inFolder(own, scene.scenario.joint)); !saved) return saved;
    if (const auto saved =
            saveScenario(scene.scenario, inFolder(own, std::string(problem.id) + ".scenario.json"));
        !saved)
      return saved;
    why += text("%s.scenario.json: %s\n", problem.id, scene.scenario.description.c_str());
  }
  return writeWholeFile(inFolder(own, "README.txt"), why);
}

}  // namespace glenoid
