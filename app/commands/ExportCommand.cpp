// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/OpenScene.h"
#include "editor/core/ExportSentences.h"
#include "simcore/export/ExportJoint.h"

namespace glenoid {
namespace {

struct Wishes {
  std::string joint, format, out, part;
};

Result<Done> run(const Wishes& wishes) {
  const ExportFormat* format = nullptr;
  std::string words;
  for (const ExportFormat& each : kExportFormats) {
    if (wishes.format == exportWord(each)) format = &each;
    words += (words.empty() ? "" : ", ") + std::string(exportWord(each));
  }
  if (!format) return usageError("--format is one of " + words + ", not “" + wishes.format + "”");
  const Result<Joint> joint = openJoint(wishes.joint);
  if (!joint) return joint.error();
  const auto report = exportJoint(*joint, *format, wishes.out, wishes.part);
  if (!report) return report.error();
  std::printf("%s: %ld nodes, %ld tetrahedra, %ld triangles\n", wishes.out.c_str(), report->nodes, report->tetrahedra, report->triangles);
  if (!report->losses.empty()) std::puts("What the file does not hold:");
  for (const Loss& loss : report->losses) std::printf("  %s\n", sentenceOf(loss).toUtf8().constData());
  return Done{};
}

}  // namespace

void addExportCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("export", "Write a joint for other programs, and say what is lost");
  auto wishes = std::make_shared<Wishes>();
  command->add_option("JOINT", wishes->joint, "A .joint folder, a .jointz file or builtin:shoulder")->required();
  command->add_option("--format", wishes->format, "msh (Gmsh), vtu (VTK), scn (SOFA), feb (FEBio) or glb (glTF)")->required();
  command->add_option("--out", wishes->out, "The file to write")->required();
  command->add_option("--part", wishes->part, "Only this part (id)");
  command->callback([wishes, &status] {
    const auto done = run(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
