// SPDX-License-Identifier: GPL-3.0-or-later
// A bar of tissue hung up by one face, pulled to many times its length by a dead load at the other: it keeps to E (s − 1) and no
// element turns inside out, for tetrahedra and cells. The linear law alone, which `paper` has as published, does not stand it.
#include <gtest/gtest.h>

#include <cmath>

#include "simcore/body/SoftObject.h"
#include "simcore/fem/StretchLaw.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/step/Measures.h"

namespace glenoid {
namespace {

constexpr double kE = 5e4, kWidth = 0.01, kLength = 0.06;  // Pa, m, m

/// Ceiling, bar (cells of 5 mm) and a weight of bone below it, along Y; no gravity. `stretch`: that the load gives by the linear law.
std::shared_ptr<const Model> hungBar(double poisson, double stretch, Elements elements, Profile profile = Profile::Direct) {
  Joint joint;
  joint.id = joint.name = "hung-bar";
  scenes::addMaterials(joint);
  joint.materials[1].youngsModulus = kE;
  joint.materials[1].poissonRatio = poisson;
  joint.parts.push_back(scenes::boxPart("ceiling", 1, PartKind::Rigid, {0, 0, 0}, {kWidth, 0.01, kWidth}));
  Part bar = scenes::boxPart("bar", 2, PartKind::Soft, {0, -kLength, 0}, {kWidth, 0, kWidth});
  bar.volume = std::make_shared<TetMesh>(scenes::boxVolume({0, -kLength, 0}, {kWidth, 0, kWidth}, 2, 12, 2));
  bar.cellSize = kWidth / 2;
  bar.regions.push_back(scenes::regionIn(bar, "top", Box3(Vec3(-1, -1e-4, -1), Vec3(1, 1e-4, 1))));
  bar.regions.push_back(scenes::regionIn(bar, "foot", Box3(Vec3(-1, -kLength - 1e-4, -1), Vec3(1, -kLength + 1e-4, 1))));
  joint.parts.push_back(bar);
  joint.parts.push_back(scenes::boxPart("weight", 3, PartKind::Rigid, {0, -kLength - 0.01, 0}, {kWidth, -kLength, kWidth}));
  joint.couplings.push_back({"hang", "bar", "ceiling", "top", 1e9, 1e-3});
  joint.couplings.push_back({"load", "bar", "weight", "foot", 1e9, 1e-3});
  Scenario scenario;
  scenario.id = scenario.name = "hung-bar";
  scenario.elements = elements;
  scenario.profile = profile;
  scenario.gravity_W.setZero();
  scenario.fixedParts = {"ceiling"};
  scenario.loadRise = 0.5;
  scenario.effects.contact = Wish::Off;
  Load load;
  load.part = "weight";
  load.force_W = Vec3(0, -kE * kWidth * kWidth * (stretch - 1), 0);
  load.point_W = Vec3(kWidth / 2, -kLength, kWidth / 2);  // where it is bonded, so that the two turn it nowhere
  scenario.loads.push_back(load);
  return compileModel(joint, scenario).value();
}

State settled(const std::shared_ptr<const Model>& model, Profile profile = Profile::Direct) {
  StepperOptions options;
  options.profile = profile;
  Stepper stepper(model, options);
  State state = model->start;
  for (int i = 0; i < 300; ++i) stepper.step({}, state);
  return state;
}

const SoftObject& barOf(const Model& model) { return static_cast<const SoftObject&>(*model.inside->objects[1]); }

/// Least volume of an element over that at rest.
double leastVolume(const Model& model, const State& state) {
  double least = 1e9;
  for (int tet = 0; tet < barOf(model).elementCount(); ++tet) {
    const ElementReading read = barOf(model).readElement(tet, state);
    least = std::min(least, (read.strain_W + Mat3::Identity()).determinant());
  }
  return least;
}

/// Stretch of the middle third, between the mean heights of two layers of nodes.
double middleStretch(const Model& model, const State& state) {
  const ObjectLayout& layout = model.objects[1].layout;
  double heights[2] = {0, 0};
  int counts[2] = {0, 0};
  for (int node = 0; node < layout.nodeCount; ++node) {
    const double y = model.objects[1].volume->nodes[node].y();
    for (int k = 0; k < 2; ++k)
      if (std::abs(y + kLength * (k + 1) / 3) < 1e-6) heights[k] += state.q[layout.qOffset + 3 * node + 1], ++counts[k];
  }
  return (heights[0] / counts[0] - heights[1] / counts[1]) / (kLength / 3);
}

TEST(Overstretch, aBarUnderADeadLoadKeepsToTheLinearForceAndInsideIn) {
  for (const Elements elements : {Elements::Tetrahedra, Elements::Cells})
    for (const double nu : {0.0, 0.3, 0.45, 0.49})
      for (const double stretch : {1.1, 1.2, 2.0, 3.0, 4.0}) {
        const auto model = hungBar(nu, stretch, elements);
        const State state = settled(model);
        const double least = leastVolume(*model, state), middle = middleStretch(*model, state);
        std::printf("%s nu %.2f stretch %.1f: middle %.4f, least J %.3f, speed %.1e\n", elements == Elements::Cells ? "cells" : "tets ", nu,
                    stretch, middle, least, state.v.cwiseAbs().maxCoeff());
        EXPECT_NEAR(middle - 1, stretch - 1, 0.01 * (stretch - 1)) << nu;
        EXPECT_GE(least, 0.3) << nu << " " << stretch;
        const TissueTrouble trouble = barOf(*model).troubleOf(state.q, true);
        EXPECT_EQ(trouble.insideOut + trouble.pressed, 0) << nu << " " << stretch;
      }
}

TEST(Overstretch, paperTurnsItInsideOutAsPublished) {
  const auto model = hungBar(0.45, 4, Elements::Tetrahedra, Profile::Paper);
  const State state = settled(model, Profile::Paper);
  EXPECT_GT(barOf(*model).troubleOf(state.q, false).insideOut, 0);
  StepperOptions options;
  options.profile = Profile::Paper;
  options.paper.stretchLaw = options.paper.tension = true;
  Stepper stepper(model, options);
  State with = model->start;
  for (int i = 0; i < 300; ++i) stepper.step({}, with);
  EXPECT_EQ(barOf(*model).troubleOf(with.q, true).insideOut, 0);
}

/// Largest rise of the energy in a step, over that at the start, of a bar that is let go from an even stretch along Y.
double riseWhenLetGo(double nu, double stretch, Elements elements, double dt) {
  Joint joint;
  joint.id = joint.name = "bar";
  scenes::addMaterials(joint);
  joint.materials[1].youngsModulus = kE;
  joint.materials[1].poissonRatio = nu;
  Part bar = scenes::boxPart("bar", 1, PartKind::Soft, {0, -kLength, 0}, {kWidth, 0, kWidth});
  bar.volume = std::make_shared<TetMesh>(scenes::boxVolume({0, -kLength, 0}, {kWidth, 0, kWidth}, 2, 12, 2));
  bar.cellSize = kWidth / 2;
  joint.parts.push_back(bar);
  Scenario scenario;
  scenario.id = scenario.name = "bar";
  scenario.elements = elements;
  scenario.gravity_W.setZero();
  scenario.dt = dt;
  scenario.effects.contact = Wish::Off;
  const auto model = compileModel(joint, scenario).value();
  // The sides as they are where nothing holds them: h = −ν h(s), found by halving.
  const Lame lame = lameFrom(kE, nu);
  double low = 0.05, high = 1.6;
  for (int i = 0; i < 60; ++i) {
    const double side = 0.5 * (low + high);
    (principalStress(lame, {side, stretch, side})[0] < 0 ? low : high) = side;
  }
  State state = model->start;
  for (int i = 0; i < state.q.size(); ++i) state.q[i] *= i % 3 == 1 ? stretch : low;
  Stepper stepper(model, {});
  const double start = test::energyOf(*model, state);
  double last = start, rise = 0;
  for (int i = 0; i < 300; ++i) {
    stepper.step({}, state);
    const double now = test::energyOf(*model, state);
    rise = std::max(rise, (now - last) / start);
    last = now;
  }
  EXPECT_TRUE(isFinite(state));
  EXPECT_LT(last, 0.5 * start);
  return rise;
}

TEST(Overstretch, letGoItGainsNoEnergy) {
  for (const Elements elements : {Elements::Tetrahedra, Elements::Cells})
    for (const double nu : {0.0, 0.3, 0.45, 0.49})
      for (const double stretch : {0.2, 1.5, 2.0, 4.0})
        for (const double dt : {1e-3, 5e-3, 2e-2}) {
          const double rise = riseWhenLetGo(nu, stretch, elements, dt);
          if (rise > 1e-10)
            std::printf("%s nu %.2f from %.1f at %g s: rise %.1e\n", elements == Elements::Cells ? "cells" : "tets ", nu, stretch, dt, rise);
          // Sums over some hundred terms. From four times its length it may snap together beyond 3 E, where the law ends: measured
          // 0.0093 in one step, at ν 0 and 1 ms with cells.
          EXPECT_LT(rise, stretch < 4 ? 1e-10 : 0.01) << nu << " " << stretch << " " << dt;
        }
}

}  // namespace
}  // namespace glenoid
