// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/Bench.h"

namespace glenoid {
namespace {

using Rows = std::vector<StudyCell>;

std::string stateName(const ContactState& state) { return "contacts-" + std::to_string(state.wanted); }

bool goOn(const BenchOptions& options, const std::string& section, double fraction) {
  return !options.progress || options.progress(section, fraction);
}

Error cancelled() { return {Fault::Cancelled, {}, {}, "benchmark"}; }

/// How each state was reached, so that a figure can be repeated.
StudyTable statesTable(const std::vector<ContactState>& states) {
  StudyTable table;
  table.id = "states";
  table.columns = {"state", "contacts", "pressing", "timeS", "mark", "loadFactor", "contactDistanceMm", "distanceChanged", "stateHash"};
  for (const ContactState& state : states)
    table.rows.push_back({stateName(state), long{state.contacts}, long{state.pressing}, state.time, state.mark, state.loadFactor,
                          1e3 * state.contactDistance, state.distanceChanged, toHex(stateHash(state.state))});
  return table;
}

}  // namespace

BenchOptions quickBench() {
  BenchOptions options;
  options.tetrahedra = {750, 7'500};
  options.fast = {20, 500, 2};
  options.slow = {1, 20, 3};
  options.grown = {2, 60, 2};
  return options;
}

std::vector<BenchSection> benchSections() {
  return {{"profiles", benchProfiles}, {"friction", benchFriction}, {"bursa", benchBursa}, {"growth", benchGrowth}};
}

Result<std::vector<StudyTable>> benchProfiles(const StudyScene& scene, const BenchOptions& options) {
  const auto states = findContactStates(scene, options.contacts, [&](double done) { return goOn(options, "profiles", 0.3 * done); });
  if (!states) return states.error();
  StudyTable steps, stages;
  steps.id = "profiles";
  steps.facts = {{"solveStages", std::string("assemble factor unconstrained delassus contact")}};
  steps.columns = {"state", "profile", "contacts", "pressing", "repeats", "stepMedianMs", "stepP95Ms", "stepP99Ms", "stepP999Ms",
                   "wallMedianMs", "wallP99Ms", "solveMedianMs", "solveP99Ms", "velocityError", "complementarityMPerS", "diverged"};
  stages.id = "stages";
  stages.columns = {"state", "profile"};
  for (int s = 0; s < kStageCount; ++s) stages.columns.push_back(std::string(stageName(static_cast<Stage>(s))) + "MedianMs");
  double done = 0;
  for (const ContactState& state : *states) {
    const auto model = compileModel(scene.joint, scenarioOf(scene, state));
    if (!model) return model.error();
    // The reference first: the others are compared with it.
    const StepCost reference = measureStep(*model, {Profile::Reference}, state.state, state.inputs, options.slow);
    for (const Profile profile : {Profile::Direct, Profile::Paper, Profile::Reference}) {
      if (!goOn(options, "profiles", 0.3 + 0.7 * done++ / (3.0 * static_cast<double>(states->size())))) return cancelled();
      const bool direct = profile == Profile::Direct;
      const StepCost cost = profile == Profile::Reference ? reference
                                                          : measureStep(*model, {profile}, state.state, state.inputs,
                                                                        direct ? options.fast : options.slow);
      steps.rows.push_back({stateName(state), std::string(profileName(profile)), long{cost.contacts}, long{cost.pressing}, cost.repeats,
                            cost.cpu.median, cost.cpu.p95, cost.cpu.p99, cost.cpu.p999, cost.wall.median, cost.wall.p99,
                            cost.solve.median, cost.solve.p99, relativeVelocityError(cost.after, reference.after),
                            cost.complementarity, cost.paper.diverged});
      Rows row{stateName(state), std::string(profileName(profile))};
      for (const Timing& stage : cost.stages) row.emplace_back(stage.median);
      stages.rows.push_back(std::move(row));
    }
  }
  return std::vector<StudyTable>{statesTable(*states), std::move(steps), std::move(stages)};
}

namespace {

/// The same states with an effect off and on.
Result<std::vector<StudyTable>> benchEffect(const char* name, Wish Effects::*wished, const StudyScene& scene,
                                            const BenchOptions& options) {
  StudyTable table;
  table.id = name;
  table.columns = {"state", name, "reason", "contacts", "pressing", "stepMedianMs", "stepP99Ms", "ratio"};
  const auto states = findContactStates(scene, options.contacts, [&](double done) { return goOn(options, name, 0.5 * done); });
  if (!states) return states.error();
  for (const ContactState& state : *states) {
    double without = 0;
    for (const Wish wish : {Wish::Off, Wish::On}) {
      Scenario scenario = scenarioOf(scene, state);
      scenario.effects.*wished = wish;
      const auto model = compileModel(scene.joint, scenario);
      if (!model) return model.error();
      const bool on = (*model)->effectOn(name);
      std::string reason;
      for (const EffectPlan& effect : (*model)->effects)
        if (effect.name == name) reason = effect.reason;
      Rows row{stateName(state), std::string(on ? "on" : "off"), reason};
      if (wish == Wish::On && !on) {
        row.resize(table.columns.size());
        table.rows.push_back(std::move(row));
        continue;
      }
      // One step first, so that each starts from impulses of its own kind.
      Stepper stepper(*model, {});
      State start = state.state;
      stepper.step(state.inputs, start);
      const StepCost cost = measureStep(*model, {}, start, state.inputs, options.fast);
      if (wish == Wish::Off) without = cost.cpu.median;
      for (StudyCell cell : Rows{long{cost.contacts}, long{cost.pressing}, cost.cpu.median, cost.cpu.p99, cost.cpu.median / without})
        row.push_back(std::move(cell));
      table.rows.push_back(std::move(row));
      if (!goOn(options, name, 0.5)) return cancelled();
    }
  }
  return std::vector<StudyTable>{std::move(table)};
}

}  // namespace

Result<std::vector<StudyTable>> benchFriction(const StudyScene& scene, const BenchOptions& options) {
  return benchEffect("friction", &Effects::friction, scene, options);
}

Result<std::vector<StudyTable>> benchBursa(const StudyScene& scene, const BenchOptions& options) {
  return benchEffect("bursa", &Effects::bursa, scene, options);
}

}  // namespace glenoid
