// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/effects/EffectsStudy.h"

#include <algorithm>
#include <cmath>

#include "simcore/body/SurfaceBinding.h"

namespace glenoid {
namespace {

using Traces = std::vector<AccuracyTrace>;
constexpr auto kOff = static_cast<std::size_t>(EffectChoice::Off),
               kOn = static_cast<std::size_t>(EffectChoice::On),
               kAuto = static_cast<std::size_t>(EffectChoice::Auto);

Error cancelled() {
  return {Fault::Cancelled, {}, {}, "study of effects"};
}

/// One effect with its three choices.
struct Case {
  EffectRow row;
  std::array<std::shared_ptr<const Model>, kEffectChoices> models;
  std::array<std::unique_ptr<EffectPlayer>, kEffectChoices> players;
};

/// What is the same for all effects.
struct Ground {
  const StudyScene& scene;
  const EffectsOptions& options;
  std::shared_ptr<const Model> base, judge;
  WindowWishes wishes;
  std::vector<AccuracyWindow> windows = {};
  Traces baseTraces = {};
  double done = 0, whole = 1;

  bool goOn(double share = 0) const {
    return !options.progress || options.progress(std::min(1.0, (done + share) / whole));
  }
};

EffectFacts factsOf(const Model& model, const std::string& name) {
  for (EffectFacts& facts : effectFacts(model))
    if (facts.name == name) return facts;
  return {};
}

/// Haptics is what a run in real time does after a step.
void beginHaptics(const Ground& ground, Case& one) {
  one.models.fill(ground.base);
  one.row.automatic = factsOf(*ground.base, one.row.name);
  one.row.on = one.row.automatic;
  one.row.acts = ground.base->effectOn("contact") && one.row.on.count("tools") > 0 &&
                 ground.base->scenario.profile != Profile::Paper;
}

/// Compiles what differs from the scene as it is.
void beginCase(const Ground& ground, Case& one) {
  EffectRow& row = one.row;
  Effects effects = ground.base->scenario.effects;
  row.wish = *wishNamed(effects, row.name);
  if (row.name == "haptics") return beginHaptics(ground, one);
  const bool baseOn = ground.base->effectOn(row.name);
  for (const EffectChoice choice : {EffectChoice::Off, EffectChoice::On, EffectChoice::Auto}) {
    const bool asItIs = (choice == EffectChoice::Auto && row.wish == Wish::Auto) ||
                        (choice == EffectChoice::On && baseOn) ||
                        (choice == EffectChoice::Off && (row.wish == Wish::Off || !baseOn));
    auto& model = one.models[static_cast<std::size_t>(choice)];
    if (asItIs) {
      model = ground.base;
      continue;
    }
    auto made = modelWith(ground.scene, row.name, choice);
    if (!made) {
      row.failed = made.error();
      return;
    }
    model = *made;
  }
  row.automatic = factsOf(*one.models[kAuto], row.name);
  row.on = factsOf(*one.models[kOn], row.name);
  row.acts = row.on.on;
  row.with = effectsMissing(*one.models[kOff], *one.models[kOn], row.name);
}

Result<Traces> playAll(Ground& ground, AccuracyPlayer& player) {
  Traces traces;
  for (const AccuracyWindow& window : ground.windows) {
    if (!ground.goOn(static_cast<double>(traces.size()) / static_cast<double>(ground.windows.size())))
      return cancelled();
    traces.push_back(player.play(window, ground.wishes));
  }
  ground.done += 1;
  return traces;
}

/// The end of a window, and the surfaces there.
struct End {
  State state;
  std::vector<DentView> dents;
  std::vector<std::vector<Vec3>> surfaces;
};

End endOf(EffectPlayer& player, const AccuracyWindow& window, double seconds) {
  const Model& model = player.player().model();
  End end{player.player().begin(window), {}, {}};
  for (long left = std::lround(seconds / model.scenario.dt); left > 0; --left) player.step(end.state);
  end.dents = player.report().dents;
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const SceneObject& object = model.objects[i];
    std::vector<Vec3>& surface = end.surfaces.emplace_back(object.visual.vertices.size());
    surfacePositions(object.visual, object.layout, end.state.q, surface);
    sinkInto(end.dents, static_cast<int>(i), surface);
  }
  return end;
}

void sumUp(const Traces& traces, double& deepest, std::string& where, double& hand) {
  for (const AccuracyTrace& trace : traces) {
    if (trace.deepest > deepest) {
      deepest = trace.deepest;
      where = trace.deepestWhere;
    }
    for (const AccuracySample& sample : trace.samples)
      for (const Vec3& force : sample.handForces) hand = std::max(hand, force.norm());
  }
}

/// Plays all windows with and without. The scene as it is has been played already.
Result<EffectLoss> lossOf(Ground& ground, Case& one) {
  std::array<Traces, 2> traces;
  for (const std::size_t k : {kOff, kOn}) {
    if (one.models[k] == ground.base) {  // haptics moves nothing: both are the scene
      traces[k] = ground.baseTraces;
      ground.done += 1;
      continue;
    }
    Result<Traces> played = playAll(ground, one.players[k]->player());
    if (!played) return played.error();
    traces[k] = std::move(*played);
  }
  EffectLoss loss;
  loss.apart = errorsOf(*ground.base, traces[kOff], traces[kOn]);
  sumUp(traces[kOn], loss.deepestWith, loss.whereWith, loss.handWith);
  sumUp(traces[kOff], loss.deepestWithout, loss.whereWithout, loss.handWithout);
  for (const AccuracyTrace& trace : traces[kOff]) {
    loss.steps += trace.steps;
    loss.notTaken += trace.notTaken;
  }
  double most = -1;
  for (std::size_t w = 0; w < ground.windows.size(); ++w) {
    const double apart = errorsOf(*ground.base, std::span(&traces[kOff][w], 1),
                                  std::span(&traces[kOn][w], 1))[AccuracyQuantity::Displacement]
                             .most;
    if (!(apart > most)) continue;
    most = apart;
    loss.moment.window = w;
  }
  const AccuracyWindow& window = ground.windows[loss.moment.window];
  End with = endOf(*one.players[kOn], window, ground.wishes.seconds);
  const End without = endOf(*one.players[kOff], window, ground.wishes.seconds);
  loss.moment.with = std::move(with.state);
  loss.moment.dents = std::move(with.dents);
  for (std::size_t i = 0; i < with.surfaces.size(); ++i) {
    std::vector<float>& apart = loss.moment.apart.emplace_back();
    for (std::size_t v = 0; v < with.surfaces[i].size(); ++v)
      apart.push_back(static_cast<float>((with.surfaces[i][v] - without.surfaces[i][v]).norm()));
  }
  return loss;
}

/// Steps of the three choices, one after another from each state, in an order that turns from repeat to
/// repeat. False where it was cancelled.
bool timeCases(Ground& ground, std::vector<Case>& cases, Timing& whole) {
  struct Samples {
    std::array<std::vector<float>, kEffectChoices> of;
  };
  std::vector<Samples> samples(cases.size());
  const int repeats = ground.options.repeats;
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (std::size_t c = 0; c < cases.size(); ++c) {
      if (!ground.goOn(static_cast<double>(repeat * static_cast<int>(cases.size()) + static_cast<int>(c)) /
                       repeats))
        return false;
      if (!cases[c].row.acts) continue;
      for (const AccuracyWindow& window : ground.windows)
        for (std::size_t turn = 0; turn < kEffectChoices; ++turn) {
          const std::size_t k = (static_cast<std::size_t>(repeat) + turn) % kEffectChoices;
          EffectPlayer& player = *cases[c].players[k];
          State state = player.player().begin(window);
          for (int s = 0; s <= ground.options.stepsTimed; ++s) {
            const double ms = player.step(state);
            if (s > 0)
              samples[c].of[k].push_back(static_cast<float>(ms));  // the first brings memory and guesses up
          }
        }
    }
  std::vector<float> all;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    EffectRow& row = cases[c].row;
    if (!row.acts) continue;
    auto& of = samples[c].of;
    EffectTimes& times = row.times.emplace();
    const auto& same = of[row.automatic.on ? kOn : kOff];
    std::vector<float> price, noise;
    for (std::size_t i = 0; i < same.size(); ++i) {
      price.push_back(of[kOn][i] - of[kOff][i]);
      noise.push_back(of[kAuto][i] - same[i]);
    }
    const auto& asIs = of[row.wish == Wish::Auto ? kAuto : row.wish == Wish::On ? kOn : kOff];  // the scene as it stands
    all.insert(all.end(), asIs.begin(), asIs.end());
    times.pairs = static_cast<long>(price.size());
    times.price = timingOf(price);
    times.noise = timingOf(noise);
    for (std::size_t k = 0; k < kEffectChoices; ++k) times.step[k] = timingOf(of[k]);
  }
  whole = timingOf(all);
  return true;
}

/// What the scene's own steps leave out.
Result<AccuracyErrors> floorOf(Ground& ground) {
  Scenario scenario = ground.scene.scenario;
  scenario.dt /= ground.options.finer;
  const auto fine = compileModel(ground.scene.joint, scenario);
  if (!fine) return fine.error();
  AccuracyPlayer player(ground.base, *fine, {scenario.profile}, ground.scene.input, nullptr);
  player.countDents();
  const Result<Traces> traces = playAll(ground, player);
  if (!traces) return traces.error();
  return errorsOf(*ground.base, ground.baseTraces, *traces);
}

}  // namespace

EffectsOptions quickEffects() {
  EffectsOptions options;
  options.windows.count = 8;
  options.windows.seconds = 0.1;
  return options;
}

Result<EffectsResult> studyEffects(const StudyScene& scene, const EffectsOptions& options) {
  const auto base = compileModel(scene.joint, scene.scenario);
  if (!base) return base.error();
  EffectsResult result;
  result.base = *base;
  result.repeats = options.repeats;
  result.hands = !scene.scenario.tools.empty();
  result.wishes = options.windows;
  result.wishes.grid = 4 * scene.scenario.dt;
  result.wishes.seconds =
      std::max(1.0, std::round(options.windows.seconds / result.wishes.grid)) * result.wishes.grid;

  Ground ground{scene, options, *base, *base, result.wishes};
  if (!(*base)->effectOn("contact")) {
    auto touching = modelWith(scene, "contact", EffectChoice::On);
    if (!touching) return touching.error();
    ground.judge = *touching;
  }
  for (const std::string& name : options.only)
    if (Effects all; !wishNamed(all, name))
      return Error{Fault::UnknownId, {}, {name, "effect"}, "study of effects"};
  std::vector<Case> cases;
  for (const EffectPlan& plan : (*base)->effects) {
    if (!options.only.empty() &&
        std::find(options.only.begin(), options.only.end(), plan.name) == options.only.end())
      continue;
    cases.emplace_back().row.name = plan.name;
  }
  ground.whole = 3.0 + 4.0 * static_cast<double>(cases.size());

  auto windows = findWindows(scene, *base, result.wishes, [&](double share) { return ground.goOn(share); });
  if (!windows) return windows.error();
  ground.done += 1;
  ground.windows = std::move(*windows);
  {
    AccuracyPlayer player(*base, *base, {scene.scenario.profile}, scene.input, ground.judge);
    player.countDents();
    Result<Traces> traces = playAll(ground, player);
    if (!traces) return traces.error();
    ground.baseTraces = std::move(*traces);
  }
  const Result<AccuracyErrors> floor = floorOf(ground);
  if (!floor) return floor.error();
  result.floor = *floor;

  for (Case& one : cases) {
    if (!ground.goOn()) return cancelled();
    beginCase(ground, one);
    if (!one.row.acts) {
      ground.done += 2;
      continue;
    }
    for (std::size_t k = 0; k < kEffectChoices; ++k) {
      one.players[k] = std::make_unique<EffectPlayer>(*base, one.models[k], ground.judge, scene.input,
                                                      one.row.name == "haptics" && k == kOn);
      one.players[k]->player().countDents();
    }
    Result<EffectLoss> loss = lossOf(ground, one);
    if (!loss) return loss.error();
    one.row.loss = std::move(*loss);
  }
  if (!timeCases(ground, cases, result.step)) return cancelled();
  for (Case& one : cases) result.rows.push_back(std::move(one.row));
  result.windows = std::move(ground.windows);
  return result;
}

}  // namespace glenoid
