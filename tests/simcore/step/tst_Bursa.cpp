// SPDX-License-Identifier: GPL-3.0-or-later
// The film of a bursa against what its law says: how far it is pressed, how it moves, that it lets slide.
#include <gtest/gtest.h>

#include "simcore/step/Stepper.h"
#include "tests/scenes/LadderScenes.h"

namespace glenoid {
namespace {

constexpr double kThickness = 2e-3, kModulus = 5e3, kSide = 0.02, kWeight = 2000 * kSide * kSide * kSide * 9.81;
constexpr double kStiffness = kModulus * kSide * kSide / kThickness;  // N/m of the whole film

/// A rigid cube over a wide plate, `gap` apart, with a bursa between the two.
scenes::LadderScene cubeOverPlate(double gap, bool plateFixed = true) {
  scenes::LadderScene scene;
  scene.joint.id = "cube-over-plate";
  scenes::addMaterials(scene.joint);
  scene.joint.parts = {
      scenes::boxPart("plate", 1, PartKind::Rigid, Vec3(-0.1, -0.02, -0.1), Vec3(0.1, 0, 0.1)),
      scenes::boxPart("cube", 2, PartKind::Rigid, Vec3(-kSide / 2, gap, -kSide / 2), Vec3(kSide / 2, gap + kSide, kSide / 2))};
  Bursa bursa;
  bursa.id = "bursa";
  bursa.floor = {{"cube", ""}};
  bursa.roof = {{"plate", ""}};
  bursa.thickness = kThickness;
  bursa.youngsModulus = kModulus;
  bursa.damping = 1e-3;
  scene.joint.bursae = {bursa};
  scene.scenario.dt = 5e-3;
  if (plateFixed) scene.scenario.fixedParts = {"plate"};
  return scene;
}

double heightOf(const Model& model, const State& state) { return poseAt(state.q, model.objects[1].layout.qOffset).p_WB.y() - kSide / 2; }

TEST(Bursa, aCubeSinksIntoTheFilmAsTheDampedSpringDoes) {
  for (const auto& [profile, tolerance] : {std::pair{Profile::Direct, 1e-10}, {Profile::Reference, 1e-10}, {Profile::Paper, 1e-7}}) {
    const scenes::LadderScene scene = cubeOverPlate(1.9e-3);
    const auto model = compileModel(scene.joint, scene.scenario).value();
    ASSERT_TRUE(model->effectOn("bursa"));
    State state = model->start;
    StepperOptions options;
    options.profile = profile;
    Stepper stepper(model, options);
    // Backward Euler of m g̈ = k (h − g) − d ġ − weight, which stays inside the film.
    const double dt = scene.scenario.dt, k = kStiffness, d = 1e-3 * k, m = kWeight / 9.81;
    double gap = 1.9e-3, speed = 0;
    for (int n = 0; n < 400; ++n) {
      const StepReport& report = stepper.step({}, state);
      ASSERT_EQ(report.filmContacts, 9);
      speed = (m * speed + dt * (k * (kThickness - gap) - kWeight)) / (m + dt * d + dt * dt * k);
      gap += dt * speed;
      ASSERT_LT(gap, kThickness);
      // Nine rows for three directions: the answer is unique, its parts are shared by round-off.
      ASSERT_NEAR(heightOf(*model, state), gap, tolerance) << "step " << n;
    }
    EXPECT_NEAR(gap, kThickness - kWeight / k, 1e-9);
    double force = 0;
    for (const ContactView& view : stepper.step({}, state).contactViews)
      if (view.film) force += view.force;
    EXPECT_NEAR(force, kWeight, 1e-6 * kWeight);
  }
}

TEST(Bursa, whatIsOffLeavesNoTrace) {
  scenes::LadderScene scene = cubeOverPlate(1.0e-3);
  scene.scenario.effects.bursa = Wish::Off;
  scenes::LadderScene without = scene;
  without.joint.bursae.clear();
  std::vector<State> ends;
  for (const auto* s : {&scene, &without}) {
    const auto model = compileModel(s->joint, s->scenario).value();
    EXPECT_FALSE(model->effectOn("bursa"));
    State& state = ends.emplace_back(model->start);
    Stepper stepper(model, {});
    for (int n = 0; n < 100; ++n) EXPECT_EQ(stepper.step({}, state).filmContacts, 0);
  }
  EXPECT_EQ(stateHash(ends[0]), stateHash(ends[1]));
}

TEST(Bursa, insideItTissueSlidesWithoutItsOwnFriction) {
  // Pressed through the film by twice what it carries, on materials that are rough.
  for (const Wish wish : {Wish::On, Wish::Off}) {
    scenes::LadderScene scene = cubeOverPlate(0.1e-3);
    for (Material& material : scene.joint.materials) material.friction = 0.5;
    scene.scenario.effects.bursa = wish;
    scene.scenario.loads = {{"cube", Vec3(0, -2 * kModulus * kSide * kSide, 0), Vec3::Zero()}};
    const auto model = compileModel(scene.joint, scene.scenario).value();
    ASSERT_TRUE(model->effectOn("friction"));
    State state = model->start;
    Stepper stepper(model, {});
    for (int n = 0; n < 40; ++n) stepper.step({}, state);
    ASSERT_GT(stepper.step({}, state).active, 0) << "the surfaces touch";
    const int v = model->objects[1].layout.vOffset;
    state.v[v] = 0.05;
    for (int n = 0; n < 20; ++n) stepper.step({}, state);
    if (wish == Wish::On)
      EXPECT_NEAR(state.v[v], 0.05, 2e-3) << "nothing but the torque of the load point holds it";
    else
      EXPECT_NEAR(state.v[v], 0, 1e-4);
    // The film carries its full pressure beneath the hard contact.
    double film = 0;
    for (const ContactView& view : stepper.step({}, state).contactViews)
      if (view.film) film += view.force;
    EXPECT_NEAR(film, wish == Wish::On ? kModulus * kSide * kSide : 0.0, 0.02 * kModulus * kSide * kSide);
  }
}

TEST(Bursa, pushesBothSidesAlike) {
  scenes::LadderScene scene = cubeOverPlate(0.5e-3, false);
  scene.scenario.effects.gravity = Wish::Off;
  const auto model = compileModel(scene.joint, scene.scenario).value();
  State state = model->start;
  Stepper stepper(model, {});
  for (int n = 0; n < 50; ++n) stepper.step({}, state);
  Vec3 momentum = Vec3::Zero();
  for (const SceneObject& object : model->objects) momentum += object.mass * state.v.segment<3>(object.layout.vOffset);
  const double pushed = model->objects[1].mass * state.v[model->objects[1].layout.vOffset + 1];
  EXPECT_GT(pushed, 1e-4);
  EXPECT_LT(momentum.norm(), 1e-10 * pushed);
}

}  // namespace
}  // namespace glenoid
