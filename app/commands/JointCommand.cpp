// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/Resources.h"
#include "app/commands/BuildJointFile.h"
#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/JointPack.h"
#include "app/commands/JointReport.h"
#include "app/commands/MirrorFile.h"
#include "app/commands/OpenScene.h"
#include "simcore/author/MakeDents.h"
#include "simcore/scene/JointFile.h"
#include "simcore/starter/Starter.h"

namespace glenoid {
namespace {

Result<std::shared_ptr<const Model>> modelOf(const std::string& word) {
  Result<Joint> joint = openJoint(word);
  if (!joint) return joint.error();
  const OpenScene scene = sceneAround(std::move(*joint));
  return compileModel(scene.joint, scene.scenario);
}

Result<Done> info(const std::string& word, bool json) {
  const auto model = modelOf(word);
  if (!model) return model.error();
  std::fputs((json ? jointInfoJson(**model) : jointInfoText(**model)).c_str(), stdout);
  return Done{};
}

Result<Done> check(const std::string& word, bool json) {
  const Result<OpenScene> scene = openSceneOrJoint(word);
  if (!scene) return scene.error();
  const Joint* const joint = &scene->joint;
  const Scenario* const around = namesJoint(word) ? nullptr : &scene->scenario;
  const CheckReport found = *ProblemFinder().find(*joint, around);  // fails only where it is asked to stop
  std::fputs((json ? jointCheckJson(*joint, found) : jointCheckText(*joint, found)).c_str(), stdout);
  if (found.holds()) return Done{};
  return Error{Fault::CheckFailed, {word, "", "", {}}, {"the joint has problems, listed above"}, "joint check"};
}

Result<Done> dents(const std::string& word, const std::string& part, const std::string& out) {
  Result<Joint> joint = openJoint(word);
  if (!joint) return joint.error();
  DentWishes dentWishes;
  dentWishes.part = part;
  if (const int index = part.empty() ? -1 : findPart(*joint, part); !part.empty()) {
    const auto unfit = [&](const char* why) { return Error{Fault::BadUsage, {word, "", "", {}}, {"--part " + part + why}, "joint dents"}; };
    if (index < 0) return unfit(": no part of the joint has that name (glenoid joint info lists them)");
    if (joint->parts[static_cast<std::size_t>(index)].kind != PartKind::Soft) return unfit(": that part is rigid, and only soft ones have dents");
  }
  std::vector<DentPlaces> pressed;
  {
    ProgressLine progress("Pressing " + joint->name);
    auto made = makeDents(*joint, dentWishes, [&](const std::string&, double done) {
      progress.show(done);
      return true;
    });
    if (!made) return made.error();
    pressed = std::move(*made);
  }
  if (const auto saved = saveJoint(*joint, out); !saved) return saved.error();
  for (const DentPlaces& places : pressed) {
    const Part& part = joint->parts[places.part];
    if (part.dents) {
      std::printf("%3d  %-24s gives", part.number, part.id.c_str());
      for (std::size_t k = 0; k < part.dents->radii.size(); ++k) {
        const auto [least, most] = std::ranges::minmax(part.dents->samples, {}, [k](const DentSample& s) { return s.compliance[k]; });
        std::printf("%s %.3g to %.3g mm/N", k ? "," : "", 1e3 * least.compliance[k], 1e3 * most.compliance[k]);
      }
      const auto deepest = std::ranges::max(part.dents->samples, {}, &DentSample::depthMost);
      std::printf(" under patches of %.1f, %.1f and %.1f mm; dents at most %.1f mm deep\n", 1e3 * part.dents->radii[0], 1e3 * part.dents->radii[1],
                  1e3 * part.dents->radii[2], 1e3 * deepest.depthMost);
    }
    if (places.coarse > 0)
      std::printf("     %-24s was pressed at %d places, some %.0f mm apart: what changes within less is evened out there\n", part.id.c_str(), places.count,
                  1e3 * places.coarse);
    if (places.tooThin > 0)
      std::printf("     %-24s is too thin for dents at %d of %d places: none there\n", part.id.c_str(), places.tooThin, places.count);
  }
  return Done{};
}

}  // namespace

void addJointCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("joint", "Begin a joint, build it from surfaces, look at it, check it, mirror it, pack it in one file");
  command->require_subcommand(1);
  struct Wishes {
    std::string joint, recipe, meshes, out, part, kind = starterKinds().front().name;
    bool json = false;
  };
  auto wishes = std::make_shared<Wishes>();
  const auto finish = [&status](const Result<Done>& done) { status = done ? kDone : complain(done.error()); };

  CLI::App* newCommand = command->add_subcommand("new", "Write a small joint to begin with: bones, ligaments, recipe, scenario and README");
  newCommand->add_option("FOLDER", wishes->out, "The folder to make")->required();
  newCommand->add_option("--kind", wishes->kind, "Which: " + starterNames())->capture_default_str();
  newCommand->callback([=] { finish(newJoint(wishes->out, wishes->kind)); });

  CLI::App* infoCommand = command->add_subcommand("info", "Parts and couplings; the built-in shoulder beside the paper's Table 1");
  CLI::App* checkCommand = command->add_subcommand("check", "List what is wrong with a joint, and what to do about it");
  for (CLI::App* with : {infoCommand, checkCommand}) {
    with->add_option("JOINT", wishes->joint, "A .joint folder, a .jointz file or builtin:shoulder")->required();
    with->add_flag("--json", wishes->json, "For programs");
  }
  infoCommand->callback([=] { finish(info(wishes->joint, wishes->json)); });
  checkCommand->callback([=] { finish(check(wishes->joint, wishes->json)); });

  CLI::App* dentsCommand = command->add_subcommand("dents", "Press every soft part finely and keep how much more it gives than its tetrahedra");
  dentsCommand->add_option("JOINT", wishes->joint, "A .joint folder, a .jointz file or builtin:shoulder")->required();
  dentsCommand->add_option("--out", wishes->out, "The .joint folder or .jointz file to write; may be the same")->required();
  dentsCommand->add_option("--part", wishes->part, "Only this part; the tables of the others stay as they are");
  dentsCommand->callback([=] { finish(dents(wishes->joint, wishes->part, wishes->out)); });

  CLI::App* mirrorCommand = command->add_subcommand("mirror", "Make the joint of the other side of the body: its mirror image in the sagittal plane, z = 0");
  mirrorCommand->add_option("JOINT", wishes->joint, "A .joint folder, builtin:shoulder, or a scenario, which is mirrored with its joint and recording")->required();
  mirrorCommand->add_option("--out", wishes->out, "The .joint folder to write; of a scenario the .scenario.json")->required();
  mirrorCommand->callback([=] { finish(mirrorFile(wishes->joint, wishes->out)); });

  CLI::App* buildCommand = command->add_subcommand("build", "Simplify, embed and bind surfaces as a recipe says");
  buildCommand->add_option("RECIPE", wishes->recipe, "A recipe, JSON")->required();
  buildCommand->add_option("--meshes", wishes->meshes, "Folder of the surfaces it names; without it “meshes” beside the recipe");
  buildCommand->add_option("--out", wishes->out, "The .joint folder or .jointz file to write")->required();
  buildCommand->callback([=] { finish(buildJointFile(wishes->recipe, wishes->meshes, wishes->out)); });

  CLI::App* packCommand = command->add_subcommand("pack", "A .joint folder as one .jointz file, to give away");
  packCommand->add_option("JOINT", wishes->joint, "A .joint folder or builtin:shoulder")->required();
  packCommand->add_option("OUT", wishes->out, "The .jointz file to write")->required();
  packCommand->callback([=] { finish(packJointFile(wishes->joint, wishes->out)); });
  CLI::App* unpackCommand = command->add_subcommand("unpack", "A .jointz file as a .joint folder");
  unpackCommand->add_option("FILE", wishes->joint, "A .jointz file")->required();
  unpackCommand->add_option("OUT", wishes->out, "The .joint folder to make")->required();
  unpackCommand->callback([=] { finish(unpackJointFile(wishes->joint, wishes->out)); });
}

}  // namespace glenoid
