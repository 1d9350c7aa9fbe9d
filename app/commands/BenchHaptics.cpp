// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/BenchHaptics.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/Devices.h"
#include "app/commands/OpenScene.h"
#include "app/commands/StudyFiles.h"
#include "app/commands/TableText.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/file/JsonObject.h"
#include "simcore/live/BuildId.h"
#include "simcore/step/Stepper.h"
#include "simcore/study/HapticBench.h"
#include "simcore/study/Machine.h"

namespace glenoid {
namespace {

struct HapticsWishes {
  double minutes = 0.5, seconds = 10;
  std::string device = kReferenceDevice, csv;
  bool json = false, scenes = false;
};

const std::vector<double> kDelays{0, 0.001, 0.002, 0.005};  // s

std::string hapticTitleOf(const std::string& id) {
  if (id == "haptic-contact") return "Contact: a virtual hand on soft tissue, cartilage and bone, in a time of its own";
  if (id == "haptic-silence") return "Silence: the same hand while the simulation stands still now and then";
  if (id == "haptic-recorded-late") return "Recorded hands while the simulation stands still now and then";
  if (id == "haptic-recorded") return "Recorded hands, in a time of its own: beside the exact step at the rate of the loop";
  if (id == "haptic-z-width") return "Z-width: the stiffest wall that does not swing up, that is passive, and that is chosen";
  return "Clock: a haptic thread beside a simulation in real time";
}

/// Only what bars are about: the last column.
bool allKept(const StudyTable& table) {
  return std::all_of(table.rows.begin(), table.rows.end(), [](const std::vector<StudyCell>& row) { return std::get<bool>(row.back()); });
}

Result<Done> benchHaptics(const HapticsWishes& wishes) {
  const auto device = deviceNamed(wishes.device);
  if (!device) return device.error();
  if (!wishes.csv.empty())
    if (const auto good = checkWritable(wishes.csv); !good) return good;
  const HapticBars bars;
  if (!wishes.json) std::printf("Build %s on %s, kernels %s.\n", buildId(), processorName().c_str(), kernelIsa(false));
  std::vector<StudyTable> tables;
  const auto show = [&](StudyTable table) {
    if (!wishes.json) std::printf("\n%s", tableText(table, hapticTitleOf(table.id)).c_str());
    std::fflush(stdout);
    tables.push_back(std::move(table));
  };
  auto pressing = std::make_optional<ProgressLine>("Pressing");
  auto contact = hapticContactTable(*device, kDelays, wishes.seconds, bars, [&](double fraction) { pressing->show(fraction); return true; });
  pressing.reset();  // the line is wiped before the table
  if (!contact) return contact.error();
  show(std::move(*contact));
  auto silent = hapticSilenceTable(*device, wishes.seconds, bars, {});
  if (!silent) return silent.error();
  show(std::move(*silent));
  if (wishes.scenes) {
    std::vector<std::pair<std::string, StudyScene>> shipped;
    for (const char* name : {"builtin:arthroscopy", "builtin:palpation"}) {
      Result<OpenScene> scene = openScenario(name);
      if (!scene) return scene.error();
      Result<std::optional<Recording>> input = openShippedInput(name, scene->scenario);
      if (!input) return input.error();
      if (*input) shipped.push_back({name, {std::move(scene->joint), std::move(scene->scenario), std::move(**input)}});
    }
    auto progress = std::make_optional<ProgressLine>("Feeling recorded hands");
    auto recorded = hapticRecordedTable(shipped, *device, wishes.seconds, [&](double fraction) { progress->show(fraction); return true; });
    progress.reset();  // the line is wiped before the table
    if (!recorded) return recorded.error();
    show(std::move(*recorded));
    auto late = hapticRecordedLateTable(shipped, *device, 2.5 * wishes.seconds, bars, {});
    if (!late) return late.error();
    show(std::move(*late));
  }
  const StudyTable width = zWidthTable(*device, kDelays);
  if (!wishes.csv.empty())
    if (const auto saved = writeWholeFile(wishes.csv, tableCsv(width)); !saved) return saved;
  if (wishes.json) {
    tables.push_back(width);
  } else {
    StudyTable few = width;  // all of it is for a plot
    few.rows.clear();
    for (std::size_t i = 0; i < width.rows.size(); ++i)
      if (i % 21 % 5 == 0 || std::holds_alternative<double>(width.rows[i].back())) few.rows.push_back(width.rows[i]);
    std::printf("\n%s", tableText(few, hapticTitleOf(few.id)).c_str());
  }
  StudyTable clock = emptyHapticClockTable();
  if (wishes.minutes > 0) {
    for (const bool load : {false, true}) {
      ProgressLine progress(load ? "Keeping the clock under load" : "Keeping the clock");
      auto row = hapticClockRow(*device, 60 * wishes.minutes, load, bars, [&](double fraction) { progress.show(fraction); return true; });
      if (!row) return row.error();
      clock.rows.push_back(std::move(*row));
    }
    show(clock);
  }
  if (wishes.json) {
    JsonValue json = jsonObject({{"build", buildId()}, {"isa", kernelIsa(false)}, {"processor", processorName()}});
    JsonValue list = JsonValue::array();
    for (const StudyTable& table : tables) list.append(tableJson(table));
    json.set("tables", std::move(list));
    std::fputs(toText(json).c_str(), stdout);
  }
  for (const StudyTable& table : tables)
    if (table.columns.back() == "kept" && table.id != "haptic-clock" && !allKept(table))
      return Error{Fault::CheckFailed, {}, {"A row of the table “" + table.id + "” does not keep what it is held to"}, "bench haptics"};
  if (!clock.rows.empty() && !std::get<bool>(clock.rows.front().back()))
    return Error{Fault::CheckFailed, {}, {"The haptic thread did not keep its clock on this machine"}, "bench haptics"};
  return Done{};
}

}  // namespace

void addBenchHaptics(CLI::App& bench_, int& status) {
  auto wishes = std::make_shared<HapticsWishes>();
  CLI::App* command = bench_.add_subcommand("haptics", "How haptics keeps its clock and its promises; status 1 where it does not");
  command->add_option("--minutes", wishes->minutes, "How long the clock is watched, idle and then under load; 0: not at all")->check(CLI::Range(0.0, 600.0));
  command->add_option("--seconds", wishes->seconds, "Of each contact of the virtual hand")->check(CLI::Range(2.5, 600.0));
  command->add_option("--device", wishes->device, "Whose profile: an id of resources/devices/devices.json or ID@FILE");
  command->add_option("--csv", wishes->csv, "Write the Z-width table: stable and passive stiffness against damping, at each delay");
  command->add_flag("--scenes", wishes->scenes, "Also what the recorded hands of both scenes that ship feel: minutes");
  command->add_flag("--json", wishes->json, "Print the tables as JSON");
  command->callback([wishes, &status] {
    const Result<Done> done = benchHaptics(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
