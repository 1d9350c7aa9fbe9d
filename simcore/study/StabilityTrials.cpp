// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/StabilityTrials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "simcore/body/RigidObject.h"
#include "simcore/step/StepModel.h"

namespace glenoid {
namespace {

constexpr double kSettle = 3, kQuiet = 0.3;          ///< s
constexpr double kTail = 0.35;                       ///< s that a run goes on after it must be at rest
constexpr double kLookEvery = 0.01;                  ///< s
constexpr double kTorqueRise = 0.2, kShake = 0.05;   ///< s
constexpr double kOwnWeights = 20;
constexpr double kStrong = 10;                       ///< times as strong a hand
constexpr double kBoneShare = 0.1;                   ///< of the heaviest bone that moves
constexpr double kMatterPressAt = 0.5;               ///< s after the loads are whole

std::string millisecondsOf(double dt) {
  char text[32];
  std::snprintf(text, sizeof text, "%gms", std::round(1e6 * dt) / 1e3);
  return text;
}

std::string axisName(int side) { return std::string(side % 2 ? "-" : "+") + "xyz"[side / 2]; }
Vec3 axisOf(int side) { return (side % 2 ? -1.0 : 1.0) * Vec3::Unit(side / 2); }

/// At rest, tools at home: nothing moves for a while; or after three seconds, which `rests` says.
State settled(const std::shared_ptr<const Model>& model, Profile profile, bool& rests) {
  const double dt = model->scenario.dt;
  StepperOptions options;
  options.profile = profile;
  Stepper stepper(model, options);
  State state = model->start;
  double moved = model->scenario.loadRise;
  for (long step = 0; static_cast<double>(step) * dt < kSettle + model->scenario.loadRise; ++step) {
    stepper.step({}, state);
    if (fastestPoint(*model, state) >= kGauntletBounds.restSpeed) moved = std::max(moved, state.time);
    rests = state.time > moved + kQuiet;
    if (rests) break;
  }
  return state;
}

double holdOf(const Scenario& scenario, const std::string& part) {
  for (const Hold& hold : scenario.holds)
    if (hold.part == part) return hold.angularStiffness;
  return 0;
}

double halfLength(const SceneObject& object) { return 0.5 * boundsOf(*object.visual.mesh).diagonal().norm(); }

/// Turns a bone by a torque for a while.
std::function<void(double, State&)> torqueOn(std::shared_ptr<const Model> model, int object, const Vec3& torque_W, double seconds) {
  return [model = std::move(model), object, torque_W, seconds](double time, State& state) {
    if (time >= seconds) return;
    const auto& body = static_cast<const RigidObject&>(*model->inside->objects[static_cast<std::size_t>(object)]);
    const Mat3 R = body.pose(state.q).q_WB.toRotationMatrix();
    const double dt = model->scenario.dt, share = std::min(1.0, (time + dt) / kTorqueRise);
    state.v.segment<3>(body.layout().vOffset + 3) += dt * share * (R * body.properties().inertia.inverse() * R.transpose() * torque_W);
  };
}

/// Shakes every part by itself.
std::function<void(double, State&)> shaking(std::shared_ptr<const Model> model, double most, int seed, double seconds) {
  return [model = std::move(model), most, seed, seconds](double time, State& state) {
    if (time >= seconds) return;
    const double dt = model->scenario.dt;
    const long spell = std::lround(std::floor((time + 0.25 * dt) / kShake));
    for (std::size_t i = 0; i < model->objects.size(); ++i) {
      const SceneObject& object = model->objects[i];
      if (object.tool || !object.layout.free) continue;
      std::mt19937 draw(static_cast<unsigned>(1000003 * seed + 9176 * spell) + static_cast<unsigned>(i));
      const auto any = [&] {
        Vec3 value;
        for (int k = 0; k < 3; ++k) value[k] = most * (draw() / 2147483648.0 - 1);
        return value;
      };
      const Vec3 linear = dt * any(), angular = dt / std::max(halfLength(object), 1e-3) * any();
      for (int k = 0; k < (object.layout.rigid ? 1 : object.layout.nodeCount); ++k) state.v.segment<3>(object.layout.vOffset + 3 * k) += linear;
      if (object.layout.rigid) state.v.segment<3>(object.layout.vOffset + 3) += angular;
    }
  };
}

void setSpeed(const Model& model, const Vec3& linear, const Vec3& angular, State& state) {
  for (const SceneObject& object : model.objects) {
    if (object.tool || !object.layout.free) continue;
    for (int k = 0; k < (object.layout.rigid ? 1 : object.layout.nodeCount); ++k) state.v.segment<3>(object.layout.vOffset + 3 * k) = linear;
    if (object.layout.rigid) state.v.segment<3>(object.layout.vOffset + 3) = angular;
  }
}

bool ofMatter(const StabilityTrial& trial) { return trial.what->ordeal == Ordeal::Stiffness || trial.what->ordeal == Ordeal::Poisson; }

}  // namespace

std::string StabilityTrial::id() const { return std::string(what->id) + (subject.empty() ? "" : "." + subject) + "." + millisecondsOf(dt); }

Result<std::unique_ptr<StabilityStage>> StabilityStage::make(StabilityScene scene, Profile profile) {
  std::unique_ptr<StabilityStage> stage(new StabilityStage);
  stage->m_scene = std::move(scene);
  stage->m_profile = profile;
  auto model = stage->compiled(stage->m_scene);
  if (!model) return model.error();
  stage->m_model = *model;
  const Result<State> rest = stage->restAt(stage->m_scene.scenario.dt);
  if (!rest) return rest.error();
  stage->m_touches = touchesOf(**model, *rest);
  double heaviest = 0;
  for (const SceneObject& object : (*model)->objects)
    if (object.layout.free && object.layout.rigid && !object.tool) heaviest = std::max(heaviest, object.mass);
  for (std::size_t i = 0; i < (*model)->objects.size(); ++i) {
    const SceneObject& object = (*model)->objects[i];
    if (object.tool || !object.layout.free) continue;
    if (!object.layout.rigid) stage->m_soft.push_back(static_cast<int>(i));
    else if (object.mass >= kBoneShare * heaviest) stage->m_bones.push_back(static_cast<int>(i));
  }
  return stage;
}

Result<std::shared_ptr<const Model>> StabilityStage::compiled(const StabilityScene& scene) const {
  Scenario scenario = scene.scenario;
  scenario.profile = m_profile;
  return compileModel(scene.joint, scenario);
}

Result<State> StabilityStage::restAt(double dt) {
  Rest* rest = nullptr;
  {
    const std::lock_guard lock(m_mutex);
    auto& slot = m_rest[dt];
    if (!slot) slot = std::make_unique<Rest>();
    rest = slot.get();
  }
  std::call_once(rest->once, [&] {
    StabilityScene scene = m_scene;
    scene.scenario.dt = dt;
    const auto model = compiled(scene);
    if (!model) {
      rest->error = model.error();
      return;
    }
    bool rests = false;
    rest->state = settled(*model, m_profile, rests);
    if (dt == m_scene.scenario.dt) m_rests = rests;
  });
  if (rest->error) return *rest->error;
  return rest->state;
}

std::vector<StabilityTrial> StabilityStage::trials(bool quick) const {
  std::vector<StabilityTrial> trials;
  for (const StabilityCase& one : stabilityCases()) {
    if (quick && !one.quick) continue;
    std::vector<StabilityTrial> of;
    const auto add = [&](std::string subject, int index, const Vec3& direction = Vec3::Zero()) {
      of.push_back({&one, std::move(subject), m_scene.scenario.dt, index, direction});
    };
    switch (one.over) {
      case Over::Scene: add("", 0); break;
      case Over::Touches:
        for (std::size_t i = 0; i < m_touches.size(); ++i) {
          const Touch& touch = m_touches[i];
          if (quick && touch.tool != m_touches[0].tool) continue;
          add(m_model->scenario.tools[static_cast<std::size_t>(touch.tool)].id + "-" + m_model->objects[static_cast<std::size_t>(touch.object)].id,
              static_cast<int>(i));
        }
        break;
      case Over::Axes:
        for (int side = 0; side < (quick ? 1 : 6); ++side) add(axisName(side), side, axisOf(side));
        break;
      case Over::Bones:
        for (const int bone : m_bones)
          for (int side = 0; side < 6; side += quick ? 2 : 1) add(m_model->objects[static_cast<std::size_t>(bone)].id + axisName(side), bone, axisOf(side));
        break;
      case Over::Soft:
        for (const int soft : m_soft)
          if (!quick || of.empty()) add(m_model->objects[static_cast<std::size_t>(soft)].id, soft);
        break;
      case Over::Seeds:
        for (int seed = 1; seed <= (quick ? 1 : 3); ++seed) add(std::to_string(seed), seed);
        break;
    }
    if (one.ordeal == Ordeal::Shape && m_soft.empty()) continue;
    if ((one.ordeal == Ordeal::Stiffness || one.ordeal == Ordeal::Poisson) && m_soft.empty()) continue;
    for (const StabilityTrial& trial : of) {
      trials.push_back(trial);
      for (const double dt : one.dts) {
        if (quick || dt == 0 || std::abs(dt - trial.dt) < 1e-9) continue;
        trials.push_back(trial);
        trials.back().dt = dt;
      }
    }
  }
  std::stable_sort(trials.begin(), trials.end(), [&](const auto& a, const auto& b) {
    return (a.dt == m_scene.scenario.dt) > (b.dt == m_scene.scenario.dt);
  });
  return trials;
}

StabilityScene StabilityStage::varied(const StabilityTrial& trial) const {
  StabilityScene scene = m_scene;
  scene.scenario.dt = trial.dt;
  const double amount = trial.what->amount;
  switch (trial.what->ordeal) {
    case Ordeal::StrongHands: {
      Tool& tool = scene.scenario.tools[static_cast<std::size_t>(m_touches[static_cast<std::size_t>(trial.index)].tool)];
      tool.stiffness *= kStrong;
      tool.forceMax *= kStrong;
      break;
    }
    case Ordeal::Gravity: scene.scenario.gravity_W = amount * scene.scenario.gravity_W.norm() * trial.direction; break;
    case Ordeal::Stiffness:
    case Ordeal::Poisson: {
      std::vector<std::string> tissue;  // of soft parts; what bone is made of moves nothing
      for (const Part& part : scene.joint.parts)
        for (const MaterialUse& use : part.materials)
          if (part.kind == PartKind::Soft) tissue.push_back(use.material);
      for (Material& material : scene.joint.materials) {
        if (std::find(tissue.begin(), tissue.end(), material.id) == tissue.end()) continue;
        if (trial.what->ordeal == Ordeal::Stiffness) material.youngsModulus *= amount;
        else material.poissonRatio = amount;
      }
      break;
    }
    default: break;
  }
  return scene;
}

CarriedShare StabilityStage::carried(const StabilityTrial& trial) const {
  const StabilityScene scene = varied(trial);
  return carriedShare(scene.joint, scene.scenario);
}

Result<StabilityRun> StabilityStage::runOf(const StabilityTrial& trial) {
  const auto model = compiled(varied(trial));
  if (!model) return model.error();
  const Result<State> rest = restAt(trial.dt);
  if (!rest) return rest.error();
  const StabilityCase& what = *trial.what;
  const SceneObject& object = (*model)->objects[what.over == Over::Bones || what.over == Over::Soft ? static_cast<std::size_t>(trial.index) : 0];
  StabilityRun run;
  run.model = *model;
  run.stepper.profile = m_profile;
  run.bounds = kGauntletBounds;
  run.start = ofMatter(trial) ? run.model->start : *rest;
  run.loadEnds = what.seconds;
  const auto play = [&](const Touch& touch, double amount, double begin) {
    run.loadEnds = begin + endOf(touch, what.play, amount);
    run.hands = [model = run.model, touch, kind = what.play, amount, begin](double time) {
      // What a hand wants at a step's end is what the step pulls towards.
      return time < begin ? Inputs{} : playHands(*model, touch, kind, amount, time + model->scenario.dt - begin);
    };
  };
  switch (what.ordeal) {
    case Ordeal::Hands:
    case Ordeal::StrongHands: play(m_touches[static_cast<std::size_t>(trial.index)], what.amount, 0); break;
    case Ordeal::Blow: run.start.v.segment<3>(object.layout.vOffset) += what.amount * trial.direction; break;
    case Ordeal::EndOfRange: {
      const double torque = what.amount * holdOf(m_scene.scenario, object.id) + kOwnWeights * 9.81 * object.mass * halfLength(object);
      run.push = torqueOn(run.model, trial.index, torque * trial.direction, what.seconds);
      break;
    }
    case Ordeal::Speed: setSpeed(*run.model, what.amount * trial.direction, 10 * what.amount * trial.direction, run.start); break;
    case Ordeal::RandomLoads: run.push = shaking(run.model, what.amount, trial.index, what.seconds); break;
    case Ordeal::Shape:
      run.misshapen = trial.index;
      misshape(*run.model, trial.index, what.shape, static_cast<unsigned>(what.amount) + static_cast<unsigned>(1000 * trial.index), run.start);
      break;
    case Ordeal::Stiffness:
    case Ordeal::Poisson:
      if (m_touches.empty()) run.loadEnds = m_scene.scenario.loadRise;
      else play(m_touches[0], 0.005, m_scene.scenario.loadRise + kMatterPressAt);
      break;
    default: break;
  }
  run.seconds = run.loadEnds + run.bounds.secondsToRest + kTail;
  run.quiet = kQuiet;
  run.lookEvery = kLookEvery;
  return run;
}

}  // namespace glenoid
