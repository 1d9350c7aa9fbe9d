// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands/BenchHaptics.h"
#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/OpenScene.h"
#include "app/commands/PeerSection.h"
#include "app/commands/TableText.h"
#include "simcore/file/JsonObject.h"
#include "simcore/live/BuildId.h"
#include "simcore/scene/JointFile.h"
#include "simcore/study/Bench.h"
#include "simcore/study/Machine.h"

namespace glenoid {
namespace {

constexpr const char* kScene = "builtin:arthroscopy";

struct Wishes {
  std::vector<std::string> sections;
  bool json = false, quick = false, smallest = false;
};

/// Every section, ours first. A section that compares with another program belongs here, after simcore's.
std::vector<BenchSection> allSections() {
  std::vector<BenchSection> sections = benchSections();
  sections.push_back(peerSection());
  return sections;
}

std::string titleOf(const std::string& id) {
  if (id == "states") return "States: steps of the shipped input, by number of contacts";
  if (id == "profiles") return "Profiles: one step from each state; times are thread CPU time unless they say wall";
  if (id == "stages") return "Stages of these steps, median, ms";
  if (id == "bursa") return "Bursa: the same states with a film under the acromion";
  if (id == "friction") return "Friction: the same states with Coulomb's law";
  if (id == "growth") return "Growth: the same joint in finer cells";
  if (id == "peers") return "Peers: seven blocks, a ridge and a ball, in ours and in Bullet; thread CPU time of whole steps";
  return id;
}

/// For tests of the command: every section, hardly any repetition, the joint as it is.
BenchOptions smallestBench() {
  BenchOptions options;
  options.tetrahedra = {750};
  options.fast = {2, 20, 1};
  options.slow = {1, 3, 1};
  options.grown = {1, 5, 1};
  return options;
}

Result<std::vector<BenchSection>> chosenSections(const std::vector<std::string>& wanted) {
  const std::vector<BenchSection> all = allSections();
  if (wanted.empty()) return all;
  std::vector<BenchSection> chosen;
  for (const std::string& id : wanted) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const BenchSection& section) { return section.id == id; });
    if (found == all.end()) return usageError("there is no section “" + id + "” of the benchmark");
    chosen.push_back(*found);
  }
  return chosen;
}

Result<StudyScene> studyScene() {
  Result<OpenScene> scene = openScenario(kScene);
  if (!scene) return scene.error();
  Result<std::optional<Recording>> input = openShippedInput(kScene, scene->scenario);
  if (!input) return input.error();
  if (!*input) return Error{Fault::Unusable, {kScene, "", "", {}}, {"the scenario ships no input"}, "bench"};
  return StudyScene{std::move(scene->joint), std::move(scene->scenario), std::move(**input)};
}

Result<Done> bench(const Wishes& wishes) {
  const auto sections = chosenSections(wishes.sections);
  if (!sections) return sections.error();
  const Result<StudyScene> scene = studyScene();
  if (!scene) return scene.error();
  BenchOptions options = wishes.smallest ? smallestBench() : wishes.quick ? quickBench() : BenchOptions();
  ProgressLine progress("Measuring");
  double sectionsDone = 0;
  options.progress = [&](const std::string&, double fraction) {
    progress.show((sectionsDone + fraction) / static_cast<double>(sections->size()));
    return true;
  };

  const std::string extent = wishes.smallest ? "smallest" : wishes.quick ? "quick" : "full";
  JsonValue json = jsonObject({{"build", buildId()}, {"isa", kernelIsa(false)}, {"processor", processorName()}, {"threads", 1},
                               {"scenario", kScene}, {"jointHash", jointHash(scene->joint)}, {"dt", scene->scenario.dt},
                               {"extent", extent}});
  if (!wishes.json)
    std::printf("Build %s on %s, kernels %s, one thread.\nScene %s, joint %s, time step %g ms.\n", buildId(), processorName().c_str(),
                kernelIsa(false), kScene, jointHash(scene->joint).c_str(), 1e3 * scene->scenario.dt);
  JsonValue tables = JsonValue::array();
  for (const BenchSection& section : *sections) {
    const auto found = section.run(*scene, options);
    if (!found) return found.error();
    ++sectionsDone;
    for (const StudyTable& table : *found) {
      if (wishes.json) tables.append(tableJson(table));
      else std::printf("\n%s", tableText(table, titleOf(table.id)).c_str());
    }
    std::fflush(stdout);
  }
  json.set("tables", std::move(tables));
  if (wishes.json) std::fputs(toText(json).c_str(), stdout);
  return Done{};
}

}  // namespace

void addBenchCommand(CLI::App& app, int& status) {
  auto wishes = std::make_shared<Wishes>();
  CLI::App* command = app.add_subcommand("bench", "Measure what a step costs on this machine (up to ten minutes)");
  command->add_flag("--json", wishes->json, "Print the tables as JSON");
  command->add_flag("--quick", wishes->quick, "Fewer repetitions and no 75 000 tetrahedra: a minute or two");
  command->add_option("--sections", wishes->sections, "Only these: profiles, friction, bursa, growth, peers")->delimiter(',');
  command->add_flag("--smallest", wishes->smallest, "For tests")->group("");
  addBenchHaptics(*command, status);
  command->callback([wishes, command, &status] {
    if (!command->get_subcommands().empty()) return;  // that one has run
    const Result<Done> done = bench(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
