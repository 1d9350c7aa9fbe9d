// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/records/RecordStore.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Json.h"

namespace glenoid {
namespace {

struct RecordsWishes {
  std::string place, trainee, out;
  bool json = false, all = false, yes = false;
};

Result<Done> listRuns(const RecordsWishes& wishes) {
  if (wishes.trainee.empty() && !wishes.all) return usageError("records list wants --trainee NAME, or --all for everybody's");
  const auto store = RecordStore::open(wishes.place);
  if (!store) return store.error();
  const auto runs = (*store)->list(wishes.trainee);
  if (!runs) return runs.error();
  if (wishes.json) {
    JsonValue list = JsonValue::array();
    for (const RecordedRun& run : *runs) {
      JsonValue entry = JsonValue::object();
      entry.set("id", run.id);
      entry.set("person", run.person);
      entry.set("scenario", run.scenario);
      entry.set("begun", run.begun);
      entry.set("seconds", run.seconds);
      entry.set("ended", run.ended);
      entry.set("score", run.score ? JsonValue(*run.score) : JsonValue());
      entry.set("passed", run.passed);
      entry.set("done", run.done);
      entry.set("tasks", run.tasks);
      list.append(std::move(entry));
    }
    std::fputs(toText(list).c_str(), stdout);
    return Done{};
  }
  for (const RecordedRun& run : *runs)
    std::printf("%5lld  %s  %-20s %-28s %6.1f s  %2d of %2d tasks  %s\n", run.id, run.begun.c_str(), run.person.c_str(), run.scenario.c_str(), run.seconds, run.done, run.tasks,
                !run.ended ? "not ended" : run.score ? text("%.1f of 100, %s", *run.score, run.passed ? "passed" : "not passed").c_str() : "no score");
  std::printf("%zu run%s in %s\n", runs->size(), runs->size() == 1 ? "" : "s", (*store)->where().c_str());
  return Done{};
}

Result<Done> exportRuns(const RecordsWishes& wishes) {
  if (const auto good = checkWritable(wishes.out); !good) return good;
  const auto store = RecordStore::open(wishes.place);
  if (!store) return store.error();
  const auto text = (*store)->exportPerson(wishes.trainee);
  if (!text) return text.error();
  return writeWholeFile(wishes.out, *text);
}

Result<Done> eraseRuns(const RecordsWishes& wishes) {
  if (!wishes.yes) return usageError("records erase takes all of a person's runs out for good; say --yes if that is meant, and export them first");
  const auto store = RecordStore::open(wishes.place);
  if (!store) return store.error();
  const auto runs = (*store)->erase(wishes.trainee);
  if (!runs) return runs.error();
  std::printf("%d run%s of “%s” taken out of %s\n", *runs, *runs == 1 ? "" : "s", wishes.trainee.c_str(), (*store)->where().c_str());
  return Done{};
}

}  // namespace

void addRecordsCommand(CLI::App& app, int& status) {
  auto wishes = std::make_shared<RecordsWishes>();
  CLI::App* command = app.add_subcommand("records", "Who did which training, and how well it went");
  command->require_subcommand(1);
  const auto add = [&](const char* name, const char* help, Result<Done> (*work)(const RecordsWishes&)) {
    CLI::App* sub = command->add_subcommand(name, help);
    sub->add_option("--records", wishes->place, "A file, or postgresql://USER@HOST/DATABASE; without it the user's own file");
    sub->callback([wishes, work, &status] {
      const Result<Done> done = work(*wishes);
      status = done ? kDone : complain(done.error());
    });
    return sub;
  };
  CLI::App* listing = add("list", "Show runs, the newest first", listRuns);
  listing->add_option("--trainee", wishes->trainee, "Whose; as --trainee of glenoid run");
  listing->add_flag("--all", wishes->all, "Everybody's, for instructors");
  listing->add_flag("--json", wishes->json, "As JSON");
  CLI::App* exporting = add("export", "Write all that is known of a person as JSON", exportRuns);
  exporting->add_option("--trainee", wishes->trainee, "Whose")->required();
  exporting->add_option("--out", wishes->out, "The file to write")->required();
  CLI::App* erasing = add("erase", "Take a person and all their runs out", eraseRuns);
  erasing->add_option("--trainee", wishes->trainee, "Whose")->required();
  erasing->add_flag("--yes", wishes->yes, "Do it: nothing brings them back");
}

}  // namespace glenoid
