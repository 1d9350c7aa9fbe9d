// SPDX-License-Identifier: GPL-3.0-or-later
// What slides over a flat surface must not feel how the surface is cut into triangles: the speed is that of a point on an
// incline, v = (g sin α − μ g cos α) t, which backward Euler has exactly.
#include <gtest/gtest.h>

#include <cstdio>

#include "simcore/step/Stepper.h"
#include "tests/scenes/SlideScenes.h"

namespace glenoid {
namespace {

using scenes::Slide;

/// Share of the closed form's speed after `seconds`; of a soft block the mean of its nodes.
double shareOfSpeed(const Slide& slide, double seconds) {
  const auto model = compileModel(scenes::slideJoint(slide), scenes::slideScenario(slide)).value();
  Stepper stepper(model, {});
  State state = model->start;
  const long steps = std::lround(seconds / slide.dt);
  for (long i = 0; i < steps; ++i) EXPECT_TRUE(stepper.step({}, state).taken);
  const ObjectLayout& layout = model->objects[1].layout;
  double sum = 0;
  for (int i = 0; i < std::max(1, layout.nodeCount); ++i) sum += state.v[layout.vOffset + 3 * i];
  return sum / std::max(1, layout.nodeCount) / slideSpeed(slide, seconds);
}

struct Case {
  const char* name;
  Slide slide;
  double seconds = 0.5;
};

void PrintTo(const Case& slide, std::ostream* out) { *out << slide.name; }

class FlatMesh : public testing::TestWithParam<Case> {};

TEST_P(FlatMesh, doesNotBrake) {
  const double share = shareOfSpeed(GetParam().slide, GetParam().seconds);
  std::printf("%-44s %.4f of the exact speed\n", GetParam().name, share);
  EXPECT_NEAR(share, 1, 0.01);
}

constexpr PartKind kRigid = PartKind::Rigid, kSoft = PartKind::Soft;

INSTANTIATE_TEST_SUITE_P(
    Sliding, FlatMesh,
    testing::Values(Case{"rigid, meshes aligned", {}},
                    Case{"rigid, turned", {.turn = 0.3}},
                    Case{"rigid, scattered", {.scatter = 0.3}},
                    Case{"rigid, turned and scattered", {.turn = -0.2, .scatter = 0.3}},
                    Case{"rigid, 5 cells across", {.cells = 5, .turn = 0.3}},
                    Case{"rigid, 20 cells across", {.cells = 20, .turn = 0.3}},
                    Case{"rigid, 40 cells across", {.cells = 40, .turn = 0.3}},
                    Case{"rigid, heights of a micron", {.turn = 0.3, .heights = 1e-6}},
                    Case{"rigid, bevelled", {.turn = 0.3, .bevel = 1e-3}},
                    Case{"rigid, 1 ms", {.turn = 0.3, .dt = 0.001}},
                    Case{"rigid, 20 ms", {.turn = 0.3, .dt = 0.02}},
                    Case{"rigid, friction 0.1", {.turn = 0.3, .scatter = 0.3, .friction = 0.1}},
                    Case{"rigid, friction 0.1, bevelled", {.turn = 0.3, .bevel = 1e-3, .friction = 0.1}},
                    Case{"rigid, bevelled, 20 ms", {.turn = 0.3, .bevel = 1e-3, .dt = 0.02}},
                    Case{"rigid, fiftieth of the size", {.turn = 0.3, .scatter = 0.3, .scale = 0.02}},
                    Case{"rigid, fifty times the size", {.turn = 0.3, .scatter = 0.3, .scale = 50}},
                    Case{"soft on rigid, turned", {.block = kSoft, .turn = 0.3}},
                    Case{"soft on rigid, scattered", {.block = kSoft, .scatter = 0.3}},
                    Case{"soft on rigid, bevelled, 20 ms", {.block = kSoft, .turn = 0.3, .bevel = 1e-3, .dt = 0.02}},
                    Case{"soft on rigid, bevelled, 5 ms", {.block = kSoft, .turn = 0.3, .bevel = 1e-3}},
                    Case{"soft on rigid, bevelled, 1 ms", {.block = kSoft, .turn = 0.3, .bevel = 1e-3, .dt = 0.001}},
                    Case{"soft on rigid, friction 0.1, bevelled", {.block = kSoft, .turn = 0.3, .bevel = 1e-3, .friction = 0.1}},
                    Case{"rigid on soft, scattered", {.plate = kSoft, .scatter = 0.3}, 0.4},
                    Case{"soft on soft, scattered", {.block = kSoft, .plate = kSoft, .scatter = 0.3}, 0.4},
                    Case{"soft on soft, bevelled", {.block = kSoft, .plate = kSoft, .scatter = 0.3, .bevel = 1e-3}, 0.4}));

TEST(Sliding, bumpsOfATenthOfAMillimetreTakeLittle) {
  for (const unsigned seed : {3u, 4u, 5u})
    for (const PartKind kind : {kRigid, kSoft}) {
      Slide slide{.block = kind, .turn = 0.3, .heights = 1e-4};
      slide.seed = seed;
      const double share = shareOfSpeed(slide, 0.5);
      slide.dt /= 4;
      const double fine = shareOfSpeed(slide, 0.5);
      std::printf("bumps, %s, seed %u: %.4f, at a quarter of the step %.4f\n", kind == kSoft ? "soft" : "rigid", seed, share, fine);
      EXPECT_GE(share, 0.9);
      EXPECT_NEAR(share, fine, 0.03 * fine);
    }
}

// A scene that leaves its contact distance and recovery speed open runs alike at every size.
TEST(Sliding, whatAScenarioLeavesOpenFollowsTheJoint) {
  std::vector<VecX> places;
  std::vector<int> near;
  for (const double scale : {1.0, 0.02, 50.0}) {
    const Slide slide{.turn = 0.3, .scatter = 0.3, .bevel = 1e-3 * scale, .friction = 0.1, .scale = scale};
    Scenario scenario = scenes::slideScenario(slide);
    scenario.contactDistance = scenario.recoverySpeedMax = 0;
    const auto model = compileModel(scenes::slideJoint(slide), scenario).value();
    EXPECT_NEAR(model->scenario.contactDistance, 0.02 * 0.04 * scale, 1e-12 * scale) << "the block is 40 mm long";
    EXPECT_NEAR(model->scenario.recoverySpeedMax, 0.02 * 0.04 / 0.015 * scale, 1e-12 * scale);
    Stepper stepper(model, {});
    State state = model->start;
    int rows = 0;
    for (int i = 0; i < 100; ++i) rows += stepper.step({}, state).contacts;
    places.emplace_back(state.q.segment<3>(model->objects[1].layout.qOffset) / scale);
    near.push_back(rows);
  }
  for (const int k : {1, 2}) {
    EXPECT_LT((places[k] - places[0]).norm(), 1e-7) << "of metres";
    EXPECT_EQ(near[k], near[0]);
  }
  EXPECT_GT(near[0], 400);
}

}  // namespace
}  // namespace glenoid
