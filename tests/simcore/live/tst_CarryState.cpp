// SPDX-License-Identifier: GPL-3.0-or-later
// A live edit changes no bit that it does not edit. The built-in arthroscopy is brought to a moment at which the probe
// presses, and carried into equal and into edited models.
#include "simcore/live/CarryState.h"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <thread>

#include "simcore/collide/FeatureKey.h"
#include "simcore/live/Run.h"
#include "simcore/live/SimulationThread.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/scenes/FoldScenes.h"
#include "tests/simcore/study/ShippedScene.h"

namespace glenoid {
namespace {

using namespace std::chrono_literals;

constexpr double kPressing = 6.4;  ///< s, at which the probe of the shipped recording presses

struct Moment {
  StudyScene scene = test::shippedScene();
  std::shared_ptr<const Model> model = compileModel(scene.joint, scene.scenario).value();
  State state = test::stateAt(scene, model, kPressing);
};
const Moment& moment() {
  static const Moment made;
  return made;
}

/// The run's next steps from a state.
void goOn(const Model& model, Stepper& stepper, const Recording& input, State& state, int steps) {
  Inputs inputs;
  for (int i = 0; i < steps; ++i) {
    handsAt(model.scenario, &input, static_cast<double>(state.step + 1) * model.scenario.dt, inputs.hands);
    stepper.step(inputs, state);
  }
}

/// Numbers of one object out of a state.
std::vector<double> numbersOf(const Model& model, const State& state, const std::string& id, bool tool) {
  std::vector<double> numbers;
  int rotation = 0;
  for (const SceneObject& object : model.objects) {
    const int rotations = 4 * object.elements;
    if (object.id == id && object.tool == tool) {
      const ObjectLayout& l = object.layout;
      numbers.insert(numbers.end(), &state.q[l.qOffset], &state.q[l.qOffset] + l.qSize);
      if (l.vSize > 0) numbers.insert(numbers.end(), &state.v[l.vOffset], &state.v[l.vOffset] + l.vSize);
      if (rotations > 0) numbers.insert(numbers.end(), &state.rotations[rotation], &state.rotations[rotation] + rotations);
      if (tool) numbers.insert(numbers.end(), &state.hands[7 * object.toolIndex], &state.hands[7 * object.toolIndex] + 7);
    }
    rotation += rotations;
  }
  return numbers;
}

/// Impulses by the ids of their objects, whichever of the two is called a; of a film under its own name.
using Impulses = std::map<std::string, std::multiset<std::pair<double, double>>>;
Impulses impulsesOf(const Model& model, const State& state, const std::string& without = "") {
  Impulses impulses;
  for (const State::Impulse& impulse : state.impulses) {
    std::string name = "film";
    if (const int pair = FeatureKey::pairOf(impulse.key); pair != FeatureKey::kFilm) {
      std::string a = model.objects[model.collisionPairs[pair].surfaceA].id, b = model.objects[model.collisionPairs[pair].surfaceB].id;
      if (a == without || b == without) continue;
      name = a < b ? a + " / " + b : b + " / " + a;
    }
    impulses[name].insert({impulse.value, impulse.friction_W.norm()});
  }
  return impulses;
}

/// Everything but `edited` is in both models with the same bits.
void expectKept(const Model& from, const State& state, const Model& to, const State& carried, const std::string& edited = "") {
  int kept = 0;
  for (const SceneObject& object : to.objects) {
    if (object.id == edited) continue;
    const std::vector<double> before = numbersOf(from, state, object.id, object.tool);
    EXPECT_EQ(before, numbersOf(to, carried, object.id, object.tool)) << object.id;
    kept += before.size() > 7;
  }
  EXPECT_GT(kept, 5) << "most of the shoulder is still there";
  EXPECT_EQ(carried.time, state.time);
  EXPECT_EQ(carried.step, state.step);
  EXPECT_EQ(impulsesOf(from, state, edited), impulsesOf(to, carried));
}

Part smallBone(const std::string& id, int number) {
  Part part = scenes::boxPart(id, number, PartKind::Rigid, {0.5, 0.5, 0.5}, {0.52, 0.52, 0.52});
  part.materials = {{moment().scene.joint.materials[0].id, ""}};
  return part;
}

TEST(CarryState, intoAnEqualModelChangesNoBit) {
  const Moment& now = moment();
  ASSERT_FALSE(now.state.impulses.empty()) << "the moment has contacts that press";
  const auto equal = compileModel(now.scene.joint, now.scene.scenario).value();
  State carried = carryState(*now.model, now.state, *equal), alone = now.state;
  EXPECT_EQ(toHex(stateHash(carried)), toHex(stateHash(alone)));
  EXPECT_EQ(carried.q, alone.q);
  EXPECT_EQ(carried.v, alone.v);
  EXPECT_EQ(carried.rotations, alone.rotations);
  EXPECT_EQ(carried.hands, alone.hands);
  Stepper fresh(equal, {}), same(now.model, {});
  for (int round = 0; round < 50; ++round) {
    goOn(*equal, fresh, now.scene.input, carried, 1);
    goOn(*now.model, same, now.scene.input, alone, 1);
    ASSERT_EQ(toHex(stateHash(carried)), toHex(stateHash(alone))) << "step " << round + 1;
  }
}

TEST(CarryState, looksAndNamesChangeNoBit) {
  const Moment& now = moment();
  Joint joint = now.scene.joint;
  joint.name = "Another shoulder";
  for (Part& part : joint.parts) {
    part.name += " (renamed)";
    part.color = {0.1f, 0.2f, 0.3f};
  }
  const auto edited = compileModel(joint, now.scene.scenario).value();
  EXPECT_EQ(toHex(stateHash(carryState(*now.model, now.state, *edited))), toHex(stateHash(now.state)));
}

TEST(CarryState, aStifferCouplingKeepsAllThatMoves) {
  const Moment& now = moment();
  Joint joint = now.scene.joint;
  for (Coupling& coupling : joint.couplings) coupling.stiffnessPerArea *= 1.5;
  const auto edited = compileModel(joint, now.scene.scenario).value();
  EXPECT_EQ(toHex(stateHash(carryState(*now.model, now.state, *edited))), toHex(stateHash(now.state)));
}

TEST(CarryState, exclusionsRenumberPairsAndImpulsesFollow) {
  const Moment& now = moment();
  // The first pairs that do not press are excluded, so that those that press get other numbers.
  const Impulses before = impulsesOf(*now.model, now.state);
  Joint joint = now.scene.joint;
  int added = 0;
  for (const CollisionPair& pair : now.model->collisionPairs) {
    const SceneObject &a = now.model->objects[pair.surfaceA], &b = now.model->objects[pair.surfaceB];
    if (a.tool || b.tool || before.count(a.id + " / " + b.id) || before.count(b.id + " / " + a.id) || added == 3) continue;
    joint.exclusions.push_back({a.id, b.id, "a test"});
    ++added;
  }
  ASSERT_GT(added, 0);
  const auto fewer = compileModel(joint, now.scene.scenario).value();
  ASSERT_LT(fewer->collisionPairs.size(), now.model->collisionPairs.size());
  const State carried = carryState(*now.model, now.state, *fewer);
  expectKept(*now.model, now.state, *fewer, carried);
  const State back = carryState(*fewer, carried, *now.model);
  EXPECT_EQ(toHex(stateHash(back)), toHex(stateHash(now.state))) << "there and back";
}

TEST(CarryState, aPartThatPressesOnItselfKeepsItsImpulses) {
  Joint joint = scenes::zigzagJoint(0.004);
  Scenario scenario;
  scenario.id = scenario.name = "zigzag";
  scenario.fixedParts = {"floor"};
  scenario.selfContactParts = {"zigzag"};
  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  for (int i = 0; i < 40; ++i) stepper.step({}, state);
  const Impulses before = impulsesOf(*model, state);
  ASSERT_TRUE(before.count("zigzag / zigzag"));
  ASSERT_TRUE(before.count("floor / zigzag"));
  EXPECT_EQ(toHex(stateHash(carryState(*model, state, *compileModel(joint, scenario).value()))), toHex(stateHash(state)));
  // Another order of parts turns the pair with the floor round, a pair more gives both another number.
  std::swap(joint.parts[0], joint.parts[1]);
  joint.parts.push_back(scenes::boxPart("far", 3, PartKind::Rigid, Vec3(0.5, 0, 0), Vec3(0.6, 0.1, 0.1)));
  const auto turned = compileModel(joint, scenario).value();
  const State there = carryState(*model, state, *turned);
  EXPECT_EQ(impulsesOf(*turned, there), before);
  EXPECT_EQ(toHex(stateHash(carryState(*turned, there, *model))), toHex(stateHash(state))) << "there and back";
  // Without the effect they are gone, and nothing else.
  scenario.effects.selfContact = Wish::Off;
  const State without = carryState(*turned, there, *compileModel(joint, scenario).value());
  Impulses rest = before;
  rest.erase("zigzag / zigzag");
  EXPECT_EQ(impulsesOf(*compileModel(joint, scenario).value(), without), rest);
}

TEST(CarryState, aPartMoreInFrontShiftsEverythingAndChangesNothing) {
  const Moment& now = moment();
  Joint joint = now.scene.joint;
  joint.parts.insert(joint.parts.begin(), smallBone("new", 0));
  const auto more = compileModel(joint, now.scene.scenario).value();
  const State carried = carryState(*now.model, now.state, *more);
  expectKept(*now.model, now.state, *more, carried, "new");
  EXPECT_EQ(numbersOf(*more, carried, "new", false), numbersOf(*more, more->start, "new", false));
  // And taken away again.
  const State back = carryState(*more, carried, *now.model);
  EXPECT_EQ(toHex(stateHash(back)), toHex(stateHash(now.state)));
  Stepper a(now.model, {}), b(now.model, {});
  State other = now.state, mine = back;
  goOn(*now.model, a, now.scene.input, mine, 10);
  goOn(*now.model, b, now.scene.input, other, 10);
  EXPECT_EQ(toHex(stateHash(mine)), toHex(stateHash(other)));
}

TEST(CarryState, toolsInAnotherOrderKeepTheirHands) {
  const Moment& now = moment();
  Scenario scenario = now.scene.scenario;
  ASSERT_GT(scenario.tools.size(), 1u);
  std::reverse(scenario.tools.begin(), scenario.tools.end());
  const auto turned = compileModel(now.scene.joint, scenario).value();
  State carried = carryState(*now.model, now.state, *turned);
  expectKept(*now.model, now.state, *turned, carried);
  // The order of sums changes, so the next steps agree to round-off only: metres beside a scene of 0.2 m.
  State alone = now.state;
  Stepper mine(turned, {}), same(now.model, {});
  goOn(*turned, mine, now.scene.input, carried, 4);
  goOn(*now.model, same, now.scene.input, alone, 4);
  for (const SceneObject& object : turned->objects) {
    const std::vector<double> a = numbersOf(*turned, carried, object.id, object.tool), b = numbersOf(*now.model, alone, object.id, object.tool);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << object.id;
  }
}

TEST(CarryState, partsInAnotherOrderChangeSidesOfTheirContacts) {
  Joint joint = scenes::blockOnPlateJoint();
  const Scenario scenario = scenes::blockOnPlateScenario();
  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  for (int i = 0; i < 200; ++i) stepper.step({}, state);
  ASSERT_FALSE(state.impulses.empty()) << "the block stands on the plate";
  std::reverse(joint.parts.begin(), joint.parts.end());
  const auto turned = compileModel(joint, scenario).value();
  State carried = carryState(*model, state, *turned);
  EXPECT_EQ(impulsesOf(*model, state), impulsesOf(*turned, carried));
  EXPECT_EQ(toHex(stateHash(carryState(*turned, carried, *model))), toHex(stateHash(state))) << "there and back";
  // The names are those that the turned model's own step gives, and friction points the same way: the step after in both.
  Stepper own(turned, {});
  own.step({}, carried);
  stepper.step({}, state);
  const State renamed = carryState(*model, state, *turned);
  std::vector<std::uint64_t> keys, ownKeys;
  Vec3 friction = Vec3::Zero(), ownFriction = Vec3::Zero();
  for (const State::Impulse& impulse : renamed.impulses) keys.push_back(impulse.key), friction += impulse.friction_W;
  for (const State::Impulse& impulse : carried.impulses) ownKeys.push_back(impulse.key), ownFriction += impulse.friction_W;
  EXPECT_EQ(keys, ownKeys);
  EXPECT_LT((friction - ownFriction).norm(), 1e-3 * (friction.norm() + 1e-6));  // N·s
}

TEST(CarryState, anotherStepKeepsTheTime) {
  const Moment& now = moment();
  Scenario scenario = now.scene.scenario;
  scenario.dt = now.scene.scenario.dt / 5;
  const auto finer = compileModel(now.scene.joint, scenario).value();
  State carried = carryState(*now.model, now.state, *finer);
  EXPECT_EQ(carried.time, now.state.time);
  Stepper stepper(finer, {});
  stepper.step({}, carried);
  EXPECT_NEAR(carried.time, now.state.time + scenario.dt, 1e-12);  // sums of steps
}

TEST(CarryState, anotherSurfaceOfARigidPartKeepsItsFrame) {
  Joint joint = scenes::figure4Joint();
  Scenario scenario = scenes::figure4Scenario();
  scenario.gravity_W = Vec3(0.3, -9.81, 0.7);
  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  for (int i = 0; i < 40; ++i) stepper.step({}, state);
  const int right = findPart(joint, "right");
  ASSERT_GT((state.q - model->start.q).segment<3>(model->objects[right].layout.qOffset).norm(), 1e-5) << "it hangs lower";
  // One corner is pulled out: volume and mass centre change, the other corners do not.
  auto surface = std::make_shared<TriMesh>(*joint.parts[right].visual);
  const std::size_t last = surface->vertices.size() - 1;
  surface->vertices[last] += 0.2 * (surface->vertices[last] - boundsOf(*surface).center());
  joint.parts[right].visual = surface;
  const auto edited = compileModel(joint, scenario).value();
  const State carried = carryState(*model, state, *edited);
  std::vector<Vec3> before(last + 1), after(last + 1), speedBefore(last + 1), speedAfter(last + 1);
  surfacePositions(model->objects[right].visual, model->objects[right].layout, state.q, before);
  surfacePositions(edited->objects[right].visual, edited->objects[right].layout, carried.q, after);
  surfaceVelocities(model->objects[right].visual, model->objects[right].layout, state.q, state.v, speedBefore);
  surfaceVelocities(edited->objects[right].visual, edited->objects[right].layout, carried.q, carried.v, speedAfter);
  for (std::size_t v = 0; v < last; ++v) {
    EXPECT_LT((after[v] - before[v]).norm(), 1e-15);  // round-off of positions below 1 m
    EXPECT_LT((speedAfter[v] - speedBefore[v]).norm(), 1e-12 * (1 + speedBefore[v].norm()));
  }
}

TEST(CarryState, partsAndToolsOfTheSameIdAreTwoThings) {
  const Moment& now = moment();
  Joint joint = now.scene.joint;
  joint.parts.insert(joint.parts.begin(), smallBone(now.scene.scenario.tools[0].id, 0));
  const auto more = compileModel(joint, now.scene.scenario).value();
  const State carried = carryState(*now.model, now.state, *more);
  const std::string& id = now.scene.scenario.tools[0].id;
  EXPECT_EQ(numbersOf(*now.model, now.state, id, true), numbersOf(*more, carried, id, true));
  EXPECT_EQ(numbersOf(*more, more->start, id, false), numbersOf(*more, carried, id, false));
}

/// Where a run of the live thread stands after some steps, with the model changed for an equal one in between.
VecX liveRun(const StudyScene& scene, int before, int after, bool change) {
  SimulationThread simulation(makeStepperStep);
  simulation.setRecording(std::make_shared<Recording>(scene.input));
  simulation.setModel(compileModel(scene.joint, scene.scenario).value(), {}, true);
  for (int i = 0; i < before; ++i) simulation.stepOnce();
  if (change) simulation.setModel(compileModel(scene.joint, scene.scenario).value(), {}, true);
  for (int i = 0; i < after; ++i) simulation.stepOnce();
  for (int i = 0; i < 60000; ++i) {
    if (simulation.takeSnapshot() && simulation.snapshot().step == before + after) return simulation.snapshot().q;
    std::this_thread::sleep_for(1ms);
  }
  return {};
}

TEST(CarryState, theLiveThreadGoesOnToTheSameBits) {
  StudyScene scene = moment().scene;
  // The recording in a hurry, so that hands are on their way, faster than they would glide back onto their path.
  for (HandTrack& track : scene.input.tracks)
    for (HandKey& key : track.keys) key.time /= 8;
  const VecX alone = liveRun(scene, 120, 50, false), changed = liveRun(scene, 120, 50, true);
  ASSERT_GT(alone.size(), 0);
  EXPECT_EQ(alone, changed);
  EXPECT_NE(liveRun(scene, 120, 49, false), alone) << "things move";
}

}  // namespace
}  // namespace glenoid
