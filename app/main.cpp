// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <QGuiApplication>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>

#include "app/Resources.h"
#include "app/Studio.h"
#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "simcore/live/BuildId.h"
#include "simcore/scene/ResourcePaths.h"
#include "simcore/step/Stepper.h"

namespace glenoid {
namespace {

/// A word of the line that stands where a command should and is none: "glenoid stduy …" would be taken as the name
/// of a file, "glenoid joint polish …" as nothing at all. Empty when all is well.
std::string mistypedCommand(const CLI::App& app, int argc, char** argv) {
  const CLI::App* at = &app;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto commands = at->get_subcommands(nullptr);
    if (commands.empty() || word.empty() || word.front() == '-') return {};
    const CLI::App* next = nullptr;
    for (const CLI::App* command : commands)
      if (command->get_name() == word) next = command;
    std::error_code ignored;
    const bool file = at == &app && (word.find_first_of("./:") != std::string::npos || std::filesystem::exists(word, ignored));
    if (!next) return file ? std::string() : word;
    at = next;
  }
  return {};
}

/// Whether the studio would find what it is asked to open.
Result<Done> findFile(const std::string& word) {
  const Result<std::string> path = namesJoint(word) ? resolveJoint(word, "", resourceRoot()) : resolveScenario(word, "", resourceRoot());
  if (!path) return path.error();
  std::error_code ignored;
  if (std::filesystem::exists(*path, ignored)) return Done{};
  return Error{Fault::FileMissing, {word, "", "", {}}, {}, "studio"};
}

std::string oneLine(std::string words) {
  for (char& c : words)
    if (c == '\n') c = ' ';
  while (!words.empty() && (words.back() == ' ' || words.back() == '.')) words.pop_back();
  return words;
}

int runProgram(int argc, char** argv) {
  int status = kDone;
  std::string file, records;
  CLI::App app("Glenoid Studio: author interactive simulations of human joints and train on them.\n"
               "Without a command it opens the studio on FILE: a scenario, a joint, or builtin:arthroscopy.", "glenoid");
  app.set_version_flag("--version", [] {
    return text("glenoid %s (build %s, %s, Qt %s)", versionId(), buildId(), kernelIsa(false), qVersion());
  }, "Say which version this is and stop");
  app.set_help_flag("-h,--help", "Say what can be said and stop");
  app.add_option("FILE", file, "What the studio opens");
  app.add_option("--records", records, "Where the studio keeps trainings: a file, or postgresql://USER@HOST/DATABASE");
  app.require_subcommand(0, 1);
  addRunCommand(app, status);
  addRenderCommand(app, status);
  addJointCommand(app, status);
  addMeshCommand(app, status);
  addReplayCommand(app, status);
  addExportCommand(app, status);
  addBenchCommand(app, status);
  addDevicesCommand(app, status);
  addStudyCommand(app, status);
  addRecordsCommand(app, status);
  app.footer("SCENARIO is a file, builtin:arthroscopy, builtin:arthroscopy-full, builtin:palpation, builtin:tour or builtin:landmarks;\n"
             "JOINT a folder, builtin:shoulder, builtin:shoulder-capsule or builtin:shoulder-superficial.\n"
             "Exit status: 0 done, 1 a check did not hold, 2 bad input or usage.");

  if (const std::string word = mistypedCommand(app, argc, argv); !word.empty())
    return complain(usageError("there is no command and no file “" + word + "”"));
  std::string command;
  for (int i = 1; i < argc && command.empty(); ++i)
    for (const CLI::App* sub : app.get_subcommands(nullptr))
      if (sub->get_name() == argv[i]) command = argv[i];
  const auto parse = [&]() -> std::optional<int> {
    try {
      app.parse(argc, argv);
    } catch (const CLI::Success& wanted) {  // --help and --version
      return app.exit(wanted);
    } catch (const CLI::ParseError& wrong) {
      return complain(usageError(oneLine(wrong.what())));
    } catch (const std::exception& bug) {  // a library's, which its wrapper let through
      return complain({Fault::Internal, {}, {}, bug.what()});
    }
    return std::nullopt;
  };
  if (command == "study") {  // draws letters, still without a display
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Qt says on stderr where it would keep sockets, which a study has none of.
    qInstallMessageHandler([](QtMsgType kind, const QMessageLogContext&, const QString& message) {
      if (kind == QtCriticalMsg || kind == QtFatalMsg) std::fprintf(stderr, "%s\n", message.toUtf8().constData());
    });
    QGuiApplication application(argc, argv);
    return parse().value_or(status);
  }
  if (!command.empty()) {  // runs inside parse; needs no display
    QCoreApplication application(argc, argv);
    return parse().value_or(status);
  }
  if (const auto ended = parse()) return *ended;
  if (!file.empty())
    if (const auto found = findFile(file); !found) return complain(found.error());
  return runStudio(argc, argv, {file, records});
}

}  // namespace
}  // namespace glenoid

int main(int argc, char** argv) { return glenoid::runProgram(argc, argv); }
