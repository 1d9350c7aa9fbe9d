// SPDX-License-Identifier: GPL-3.0-or-later
// A ball that lies on an elastic block by its own weight, against Hertz: F = 4/3 E* √R d^(3/2) with E* = E/(1
// − ν²), d the depth and a = √(R d) the radius of contact. Contact, friction-free, of a rigid and an embedded
// surface, at rest.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/scenes/LadderScenes.h"
#include "tests/simcore/step/Measures.h"

namespace glenoid {
namespace {

struct Press {
  double ball = 0.02;   ///< radius, m
  double touch = 4e-3;  ///< radius of contact that Hertz gives, m
  double young = 5e4;   ///< Pa
  double cell = 1;      ///< of the block under the ball, over `touch`
  double growth = 2;    ///< of cells outwards
};

/// Depth that is found over Hertz's. The block ends 16 radii of contact away.
double depthOverHertz(const Press& press) {
  const double depth = press.touch * press.touch / press.ball, reduced = press.young / (1 - 0.3 * 0.3);
  const double force = 4.0 / 3 * reduced * std::sqrt(press.ball) * std::pow(depth, 1.5);
  scenes::LadderScene scene = scenes::ballOnBlock(press.ball, force / 9.81, press.young,
                                                  press.cell * press.touch, press.growth, 16 * press.touch);
  scene.scenario.dt = 0.05;
  const auto model = compileModel(scene.joint, scene.scenario).value();
  State state = model->start;
  Stepper stepper(model, {});
  const ObjectLayout& ball = model->objects[0].layout;
  const double start = state.q[ball.qOffset + 1];
  double support = 0, speed = 1;
  // Until it sinks by less than a thousandth of the depth in a step. Nothing keeps the ball from turning
  // where it lies, and its facets then lift it by some of that.
  for (int i = 0; i < 40 && (i < 4 || speed * scene.scenario.dt > 1e-3 * depth); ++i) {
    const StepReport& report = stepper.step({}, state);
    EXPECT_TRUE(report.taken);
    support = 0;
    for (const ContactView& contact : report.contactViews) support += contact.normal_W.y() * contact.force;
    speed = std::abs(state.v[ball.vOffset + 1]);
  }
  EXPECT_NEAR(support, force, 5e-3 * force) << "the contacts carry its weight";
  return (start - state.q[ball.qOffset + 1]) / depth;
}

TEST(Hertz, depthApproachesThatOfHertzUnderRefinement) {
  // Each level has cells of 0.7 of the last one's, near and far. What is missing is the stiffness of five
  // tetrahedra in a brick, which falls with the cell; a block of 16 radii, not a half-space, keeps the last
  // five per cent (a glued layer of thickness H is stiffer by 1.1 a/H; Dimitriadis et al., Biophysical
  // Journal 82, 2002); facets and contact distance are far below. So the tolerance at the finest level is 15
  // %, and what counts is that it shrinks.
  const char* wish = std::getenv("GLENOID_LONG");
  std::vector<Press> levels{
      {.cell = 1, .growth = 2}, {.cell = 0.7, .growth = 1.63}, {.cell = 0.5, .growth = 1.41}};
  if (wish && std::string(wish) == "1") levels.push_back({.cell = 0.35, .growth = 1.28});
  std::vector<double> found;
  for (const Press& level : levels) {
    found.push_back(depthOverHertz(level));
    std::printf("cells of %.2f radii of contact: depth %.3f of Hertz\n", level.cell, found.back());
  }
  for (std::size_t i = 0; i + 1 < found.size(); ++i) {
    EXPECT_LT(found[i], found[i + 1]);
    const double order =
        std::log((1 - found[i]) / (1 - found[i + 1])) / std::log(levels[i].cell / levels[i + 1].cell);
    EXPECT_GT(order, 0.7) << "between levels " << i << " and " << i + 1;
  }
  EXPECT_NEAR(found[2], 1, 0.15);
  EXPECT_NEAR(found.back(), 1, found.size() > 3 ? 0.10 : 0.15);
}

TEST(Hertz, loadGrowsWithTheThreeHalvesOfDepthAndWithStiffness) {
  // Another load, another tissue, another ball, the mesh scaled with the contact: the share that the mesh
  // takes stays the same. Hertz takes the ball for a paraboloid, which is off by (a/R)², from 4 % here to 1.4
  // %: that is the tolerance.
  const double base = depthOverHertz({.cell = 0.7, .growth = 1.63});
  EXPECT_NEAR(depthOverHertz({.touch = 2.5e-3, .cell = 0.7, .growth = 1.63}) / base, 1, 0.04)
      << "a quarter of the load";
  EXPECT_NEAR(depthOverHertz({.ball = 0.05, .touch = 6e-3, .cell = 0.7, .growth = 1.63}) / base, 1, 0.04);
  // Stiffness alone changes nothing but forces.
  EXPECT_NEAR(depthOverHertz({.young = 1e6, .cell = 0.7, .growth = 1.63}) / base, 1, 5e-3);
}

}  // namespace
}  // namespace glenoid
