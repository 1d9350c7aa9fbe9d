// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <tuple>

#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/OpenScene.h"
#include "editor/core/ExportSentences.h"
#include "simcore/export/ExportJoint.h"
#include "simcore/import/LengthUnit.h"

namespace glenoid {
namespace {

struct Wishes {
  std::string joint, format, out, part, mesh, size, distance;
};

/// "1.5mm", "0.1cm": a length with its unit, m.
Result<double> lengthOf(const std::string& option, const std::string& text) {
  double number = 0;
  const auto [end, trouble] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto metres = metresIn(std::string_view(end, text.data() + text.size()));
  if (trouble != std::errc() || !metres || !(number > 0) || !std::isfinite(number))
    return usageError(option + " wants a length with its unit, such as 1.5mm, not “" + text + "”");
  return number * *metres;
}

Result<ExportWish> wishOf(const Wishes& wishes, ExportFormat format) {
  ExportWish wish;
  wish.part = wishes.part;
  wish.mesh = usualMesh(format);
  bool known = wishes.mesh.empty();
  for (const ExportMesh mesh : kExportMeshes)
    if (wishes.mesh == exportMeshWord(mesh)) wish.mesh = mesh, known = true;
  if (!known) return usageError("--mesh is cells or conforming, not “" + wishes.mesh + "”");
  if (!wishes.mesh.empty() && !holdsVolumes(format)) return usageError("--mesh is for formats that hold tetrahedra, which " + wishes.format + " does not");
  for (const auto& [option, text, value] : {std::tuple("--size", &wishes.size, &wish.size.edge), std::tuple("--facet-distance", &wishes.distance, &wish.size.distance)}) {
    if (text->empty()) continue;
    if (!holdsVolumes(format) || wish.mesh != ExportMesh::Conforming) return usageError(std::string(option) + " is for --mesh conforming");
    const auto length = lengthOf(option, *text);
    if (!length) return length.error();
    *value = *length;
  }
  return wish;
}

Result<Done> run(const Wishes& wishes) {
  const ExportFormat* format = nullptr;
  std::string words;
  for (const ExportFormat& each : kExportFormats) {
    if (wishes.format == exportWord(each)) format = &each;
    words += (words.empty() ? "" : ", ") + std::string(exportWord(each));
  }
  if (!format) return usageError("--format is one of " + words + ", not “" + wishes.format + "”");
  const auto wish = wishOf(wishes, *format);
  if (!wish) return wish.error();
  const Result<Joint> joint = openJoint(wishes.joint);
  if (!joint) return joint.error();
  const auto report = exportJoint(*joint, *format, wishes.out, *wish);
  if (!report) return report.error();
  std::printf("%s: %ld nodes, %ld tetrahedra, %ld triangles\n", wishes.out.c_str(), report->nodes, report->tetrahedra, report->triangles);
  for (const SolidFigures& solid : report->solids) std::printf("  %s\n", sentenceOf(solid, wish->mesh).toUtf8().constData());
  if (!report->losses.empty()) std::puts("What the file does not hold:");
  for (const Loss& loss : report->losses) std::printf("  %s\n", sentenceOf(loss).toUtf8().constData());
  return Done{};
}

}  // namespace

void addExportCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("export", "Write a joint for other programs, and say what is lost");
  auto wishes = std::make_shared<Wishes>();
  command->add_option("JOINT", wishes->joint, "A .joint folder, a .jointz file or builtin:shoulder")->required();
  command->add_option("--format", wishes->format, "msh (Gmsh), vtu (VTK), scn (SOFA), feb (FEBio), inp (CalculiX) or glb (glTF)")->required();
  command->add_option("--out", wishes->out, "The file to write")->required();
  command->add_option("--part", wishes->part, "Only this part (id)");
  command->add_option("--mesh", wishes->mesh,
                      "Tetrahedra of soft parts: cells (of the simulation, which stand out of the part; default but for inp) or conforming (of the part "
                      "itself, for solvers)");
  command->add_option("--size", wishes->size, "Length of the edges of conforming tetrahedra, such as 1.5mm; without it two thirds of each part's thickness");
  command->add_option("--facet-distance", wishes->distance,
                      "How far their faces may lie from the part's surface, such as 0.1mm; without it a tenth of --size");
  command->callback([wishes, &status] {
    const auto done = run(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
