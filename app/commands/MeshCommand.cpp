// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <sstream>

#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/MeshReport.h"
#include "simcore/file/Json.h"
#include "simcore/file/SurfaceWrite.h"
#include "simcore/import/ImportSurfaces.h"
#include "simcore/import/LengthUnit.h"
#include "simcore/repair/GuessUnit.h"

namespace glenoid {
namespace {

struct Wishes {
  std::vector<std::string> files;
  std::string in, out, surface, steps, unit, axes;
  double seconds = 60, memory = 2;
  bool json = false, automatic = false;
};

ImportLimits limitsOf(const Wishes& wishes) {
  ImportLimits limits;
  limits.seconds = wishes.seconds;
  limits.memory = static_cast<std::uint64_t>(wishes.memory * (1ull << 30));
  return limits;
}

std::string stemOf(const std::string& path) {
  const std::size_t slash = path.rfind('/'), from = slash == std::string::npos ? 0 : slash + 1;
  return path.substr(from, path.rfind('.') - from);
}

SurfaceDiagnosis lookAt(const ImportedFile& file, const ImportedSurface& surface, const std::string& path) {
  DiagnosisOptions options;
  options.name = surface.name + " " + stemOf(path);
  options.metresPerUnit = file.metresPerUnit;
  return diagnose(surface.mesh, options);
}

Result<Done> info(const Wishes& wishes) {
  JsonValue all = JsonValue::array();
  for (const std::string& path : wishes.files) {
    const auto file = importSurfaces(path, limitsOf(wishes));
    if (!file) return file.error();
    const std::vector<SurfaceDiagnosis> diagnoses = diagnoseFile(*file, stemOf(path));
    if (wishes.json)
      all.append(meshInfoJson(path, *file, diagnoses));
    else
      std::fputs(meshInfoText(path, *file, diagnoses).c_str(), stdout);
  }
  if (wishes.json) std::fputs(toText(all).c_str(), stdout);
  return Done{};
}

/// By number from 1 or by name; the only one where nothing is said.
Result<const ImportedSurface*> chosen(const ImportedFile& file, const Wishes& wishes) {
  if (wishes.surface.empty()) {
    if (file.surfaces.size() == 1) return &file.surfaces[0];
    return usageError(text("the file holds %zu surfaces: choose one with --surface", file.surfaces.size()));
  }
  for (std::size_t i = 0; i < file.surfaces.size(); ++i)
    if (file.surfaces[i].name == wishes.surface || std::to_string(i + 1) == wishes.surface) return &file.surfaces[i];
  return Error{Fault::UnknownId, {wishes.in, {}, {}, {}}, {wishes.surface, "surface"}, "mesh repair"};
}

Result<std::vector<RepairStep>> stepsOf(const Wishes& wishes) {
  std::vector<RepairStep> steps;
  std::istringstream words(wishes.steps);
  for (std::string word; std::getline(words, word, ',');) {
    const auto step = repairStepFrom(word);
    if (!step) return step.error();
    steps.push_back(*step);
  }
  return steps;
}

Result<Done> mend(const Wishes& wishes) {
  if (!isWrittenAsSurface(wishes.out)) return usageError("“" + wishes.out + "” must end in .ply, .stl or .obj, whose format is then written");
  double metres = 0;
  AxisMap axes;
  if (!wishes.unit.empty()) {
    const auto known = metresIn(wishes.unit);
    if (!known) return usageError("“" + wishes.unit + "” is no unit; there are mm, cm, m, inch, ft and um");
    metres = *known;
  }
  if (!wishes.axes.empty()) {
    std::array<std::string, 3> words;
    std::istringstream(wishes.axes) >> words[0] >> words[1] >> words[2];
    const auto map = axisMapFrom(words);
    if (!map) return map.error();
    axes = *map;
  }
  auto steps = stepsOf(wishes);
  if (!steps) return steps.error();
  auto file = importSurfaces(wishes.in, limitsOf(wishes));
  if (!file) return file.error();
  const auto surface = chosen(*file, wishes);
  if (!surface) return surface.error();
  ImportedSurface work = **surface;
  // Lengths in steps without a unit of their own are in metres where --unit is given, in the file's unit otherwise.
  work.mesh = placed(work.mesh, metres > 0 ? metres : 1, axes, Vec3::Zero());
  if (metres > 0) file->metresPerUnit = 1;
  if (wishes.automatic) {
    const std::vector<RepairStep> own = automaticRepairs(lookAt(*file, work, wishes.in));
    steps->insert(steps->begin(), own.begin(), own.end());
  }
  const double unit = file->metresPerUnit.value_or(0);
  auto outcome = repair(work.mesh, *steps, unit);
  if (!outcome) {
    outcome.error().place.file = wishes.in;
    return outcome.error();
  }
  if (const auto written = writeSurface(wishes.out, outcome->mesh); !written) return written.error();
  std::fputs(repairText(outcome->changes, unit).c_str(), stdout);
  work.mesh = std::move(outcome->mesh);
  file->notes.clear();
  file->format = writtenFormat(wishes.out);
  const SurfaceDiagnosis after = lookAt(*file, work, wishes.in);
  file->surfaces = {work};
  std::fputs(meshInfoText(wishes.out, *file, {after}).c_str(), stdout);
  if (after.healthy()) return Done{};
  return Error{Fault::CheckFailed, {wishes.out, {}, {}, {}}, {"the surface is not closed, manifold and outwards yet, as listed above"}, "mesh repair"};
}

}  // namespace

void addMeshCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("mesh", "Look at surfaces from other programs and mend them");
  command->require_subcommand(1);
  auto wishes = std::make_shared<Wishes>();
  const auto finish = [&status](const Result<Done>& done) { status = done ? kDone : complain(done.error()); };

  CLI::App* infoCommand = command->add_subcommand("info", "What a file holds, its unit and size, and what is wrong with it");
  infoCommand->add_option("FILE", wishes->files, "OBJ, STL, PLY, glTF, GLB, 3MF, DAE, FBX, VTP, VTU or VTK")->required();
  infoCommand->add_flag("--json", wishes->json, "For programs");
  infoCommand->callback([=] { finish(info(*wishes)); });

  CLI::App* repairCommand = command->add_subcommand("repair", "Mend one surface and write it");
  repairCommand->add_option("IN", wishes->in, "A file as for info")->required();
  repairCommand->add_option("--out", wishes->out, "The file to write: .ply (all digits), .obj or .stl")->required();
  repairCommand->add_flag("--auto", wishes->automatic, "Take all repairs that harm nothing");
  repairCommand->add_option("--steps", wishes->steps, "Repairs in this order, such as weld,orient,fillHoles,thicken=0.5mm; after those of --auto");
  repairCommand->add_option("--surface", wishes->surface, "Which one, by name or number from 1");
  repairCommand->add_option("--unit", wishes->unit, "What the file's numbers are in: mm, cm, m, inch, ft, um; the answer is then in metres");
  repairCommand->add_option("--axes", wishes->axes, "Which axes become x, y and z, such as \"-y z -x\"");
  repairCommand->callback([=] { finish(mend(*wishes)); });

  for (CLI::App* with : {infoCommand, repairCommand}) {
    with->add_option("--seconds", wishes->seconds, "How long reading a file may take")->check(CLI::Range(0.01, 86400.0));
    with->add_option("--memory", wishes->memory, "How much memory reading a file may take, GiB")->check(CLI::Range(0.05, 1024.0));
  }
}

}  // namespace glenoid
