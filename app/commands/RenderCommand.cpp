// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/OpenScene.h"
#include "app/commands/Picture.h"
#include "simcore/live/Run.h"
#include "simcore/reading/SurfaceField.h"

namespace glenoid {
namespace {

struct Wishes {
  std::string scene, size;
  double time = 0;
  PictureWishes picture;
};

Result<Done> render(Wishes wishes) {
  if (!wishes.size.empty())
    if (const auto read = readSize(wishes.size, wishes.picture); !read) return read.error();
  if (const auto good = checkColours(wishes.picture); !good) return good.error();
  if (wishes.picture.colour == quantityName(Quantity::Contact) && wishes.time <= 0)
    return usageError("--colour contact wants --time: at the start no step has found what presses");
  const Result<OpenScene> scene = openSceneOrJoint(wishes.scene);
  if (!scene) return scene.error();
  const auto model = compileModel(scene->joint, scene->scenario);
  if (!model) return model.error();
  wishes.picture.stretchLaw = hasStretchLaw(scene->scenario.profile);
  if (wishes.time <= 0) return drawPicture(**model, (*model)->start, {}, wishes.picture);

  const Result<std::optional<Recording>> input = openShippedInput(wishes.scene, scene->scenario);
  if (!input) return input.error();
  RunOptions options;
  options.seconds = wishes.time;
  options.stepper.profile = scene->scenario.profile;
  options.input = *input ? &**input : nullptr;
  options.checks = false;
  ProgressLine progress("Running " + wishes.scene);
  options.progress = [&](double fraction) {
    progress.show(fraction);
    return true;
  };
  const Result<RunResult> result = runScenario(*model, options);
  if (!result) return result.error();
  return drawPicture(**model, result->state, result->contacts, wishes.picture, result->dents);
}

}  // namespace

void addRenderCommand(CLI::App& app, int& status) {
  auto wishes = std::make_shared<Wishes>();
  CLI::App* command = app.add_subcommand("render", "Draw a scenario or a joint into a picture, without a display");
  command->add_option("SCENARIO|JOINT", wishes->scene, "A .scenario.json file, a .joint folder or builtin:NAME")->required();
  command->add_option("--out", wishes->picture.out, "PNG to write")->required();
  command->add_option("--size", wishes->size, "WIDTHxHEIGHT in pixels [1280x960]");
  command->add_option("--camera", wishes->picture.camera,
                      "One of the scenario's cameras, or anterior, posterior, lateral, medial (by the side of the joint), superior, inferior; scope: through "
                      "the scenario's first arthroscope, scope:TOOL through that one");
  command->add_option("--haze", wishes->picture.haze, "How much the fluid in the joint veils, 0 to 1; with --camera scope")->check(CLI::Range(0.0, 1.0));
  command->add_option("--bleeding", wishes->picture.bleeding, "How much of the field blood clouds, 0 to 1; with --camera scope")->check(CLI::Range(0.0, 1.0));
  command->add_option("--layers", wishes->picture.layers,
                      "Such as visual,contacts; of visual, collision, dynamics, couplings, contacts, tools, regions, labels");
  command->add_option("--time", wishes->time, "Run the scenario so far first, s")->check(CLI::NonNegativeNumber);
  command->add_option("--part", wishes->picture.part, "Show this part alone, or with --sheet cage its cage alone: its id or number");
  command->add_option("--sheet", wishes->picture.sheet,
                      "Take it apart into pictures side by side: anatomy (from the bones outwards) meshes (visual, collision, dynamics) or cage (overlaps at rest, cages, the start they make)");
  addColourOptions(*command, wishes->picture);
  command->callback([wishes, &status] {
    const Result<Done> done = render(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
