// SPDX-License-Identifier: GPL-3.0-or-later
// A finger pressed hard into the skin, at several places and angles: what is shown of the layers below stays below. Measured on the
// skin's two sheets as the generator numbers them, which UnderSkin does not know.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "resources/generate/Superficial.h"
#include "simcore/body/SurfaceBinding.h"
#include "simcore/reading/UnderSkin.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/spatial/TriangleTree.h"
#include "simcore/step/Stepper.h"

namespace glenoid {
namespace {

const std::string kResources = GLENOID_SOURCE_DIR "/resources";

/// Where a finger presses: moved along the skin (m, to the front and up) and tilted about the same axes (rad).
struct Press {
  Eigen::Vector2d moved, tilted;
};

std::shared_ptr<const Model> palpationAt(const Press& press) {
  static const Joint joint = loadJoint(kResources + "/joints/shoulder-superficial.joint").value();
  Scenario scenario = loadScenario(kResources + "/scenarios/palpation.scenario.json").value();
  const Pose home = scenario.tools[0].home;
  const Vec3 out = home.q_WB * Vec3::UnitZ(), up = (Vec3::UnitY() - out.y() * out).normalized(), front = up.cross(out);
  const Quat turn = Quat(Eigen::AngleAxisd(press.tilted.x(), front)) * Quat(Eigen::AngleAxisd(press.tilted.y(), up));
  for (Tool& tool : scenario.tools) {
    tool.home.p_WB = home.p_WB + press.moved.x() * front + press.moved.y() * up + turn * (tool.home.p_WB - home.p_WB);
    tool.home.q_WB = (turn * tool.home.q_WB).normalized();
    tool.forceMax = 25;  // the shipped 15 N would be shared by the finger and the one inside
  }
  return compileModel(joint, scenario).value();
}

struct Pressed {
  State state;
  std::vector<DentView> dents;
  double force = 0;  ///< N, on the finger
};

/// The hand goes in at 0.1 m/s until the finger bears the force, and holds there.
Pressed pressed(const std::shared_ptr<const Model>& model, double force, int steps) {
  Stepper stepper(model, {});
  Pressed end;
  end.state = model->start;
  const Pose home = model->scenario.tools[0].home;
  const Vec3 out = home.q_WB * Vec3::UnitZ();
  double depth = 0;
  for (int i = 0; i < steps; ++i) {
    const StepReport& report = stepper.step({{{home.p_WB - depth * out, home.q_WB}}}, end.state);
    end.force = report.toolForces[0].norm();
    end.dents = report.dents;
    if (end.force < force) depth = std::min(depth + 5e-4, 0.09);
  }
  return end;
}

/// As a picture has them: dents sink what they are pressed into.
std::vector<Vec3> visualAt(const Model& model, int object, const Pressed& at) {
  const SceneObject& it = model.objects[object];
  std::vector<Vec3> points(it.visual.vertices.size());
  surfacePositions(it.visual, it.layout, at.state.q, points);
  for (const DentView& dent : at.dents)
    if (dent.object == object)
      for (Vec3& p : points) p -= dent.depth * std::exp(-(p - dent.point_W).squaredNorm() / (2 * dent.radius * dent.radius)) * dent.normal_W;
  return points;
}

/// How far anything of the layers below lies beyond the inner sheet of the skin: vertices, middles of edges and of triangles.
struct Through {
  double depth = 0;  ///< m
  int beyond = 0;    ///< places that have come out of the outer sheet: seen
  std::string what;
};

Through throughSkin(const Model& model, const Pressed& end, const UnderSkin* kept) {
  int skin = 0;
  while (model.objects[skin].id != "skin") ++skin;
  TriMesh whole = *model.objects[skin].visual.mesh;
  whole.vertices = visualAt(model, skin, end);
  const int sheet = (generate::kSkinAcross + 1) * (generate::kSkinAlong + 1);
  TriMesh inner = whole;
  std::erase_if(inner.triangles, [&](const auto& t) { return std::max({t[0], t[1], t[2]}) >= sheet; });
  const TriangleTree wholeTree(whole), innerTree(inner);
  Through worst;
  for (int i = 0; i < static_cast<int>(model.objects.size()); ++i) {
    const SceneObject& part = model.objects[i];
    if (part.tool || i == skin) continue;
    std::vector<Vec3> places = visualAt(model, i, end);
    if (kept)
      if (const std::span<const Vec3> shifts = kept->shifts(i); !shifts.empty())
        for (std::size_t v = 0; v < shifts.size(); ++v) places[v] += shifts[v];
    for (const auto& t : part.visual.mesh->triangles) {
      const Vec3 a = places[t[0]], b = places[t[1]], c = places[t[2]];
      for (const Vec3& p : {Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3((a + b + c) / 3)}) places.push_back(p);
    }
    for (const Vec3& p : places) {
      const TriangleTree::Closest nearest = wholeTree.closest(p, 0.02);
      if (nearest.triangle < 0) continue;
      const bool inside = wholeTree.inside(p);
      const auto& t = whole.triangles[nearest.triangle];
      const Vec3 outward = (whole.vertices[t[1]] - whole.vertices[t[0]]).cross(whole.vertices[t[2]] - whole.vertices[t[0]]).normalized();
      // At the rim: beside the skin's border, not through it.
      if (std::min({t[0], t[1], t[2]}) < sheet && std::max({t[0], t[1], t[2]}) >= sheet) continue;
      const bool beyond = !inside && std::min({t[0], t[1], t[2]}) >= sheet && outward.dot(p - nearest.point) > 0.7 * nearest.distance;
      worst.beyond += beyond;
      if (!inside && !beyond) continue;
      if (const double depth = innerTree.closest(p).distance; depth > worst.depth) worst.depth = depth, worst.what = part.id;
    }
  }
  return worst;
}

TEST(UnderSkin, nothingIsShownThroughTheSkinUnderAFingerPressedHard) {
  std::vector<Press> presses{{{0, 0}, {0, 0}}};
  if (std::getenv("GLENOID_LONG"))  // 15 s of CPU
    presses = {{{0, 0}, {0, 0}}, {{-0.015, 0.01}, {0, 0.5}}, {{0.012, -0.02}, {-0.4, 0}}, {{0, 0.02}, {0.3, -0.3}}, {{0.02, 0.01}, {0, 0}}, {{-0.02, -0.02}, {0.3, 0.3}}};
  double most = 0;
  for (const Press& press : presses) {
    const auto model = palpationAt(press);
    UnderSkin kept(*model);
    ASSERT_FALSE(kept.empty());
    const Pressed end = pressed(model, 20, 200);
    const Through bare = throughSkin(*model, end, nullptr);
    kept.look(end.state.q, end.dents);
    const Through shown = throughSkin(*model, end, &kept);
    std::printf("%5.1f N: %5.2f mm through the skin (%s; %d places seen), shown %.2f mm (%s; %d)\n", end.force, 1e3 * bare.depth, bare.what.c_str(), bare.beyond,
                1e3 * shown.depth, shown.what.c_str(), shown.beyond);
    EXPECT_LT(shown.depth, 5e-4) << shown.what;
    EXPECT_EQ(shown.beyond, 0);
    most = std::max(most, bare.depth);
  }
  EXPECT_GT(most, 2e-3) << "nothing would have come through: press harder";
}

TEST(UnderSkin, nothingIsShiftedAtTheStart) {
  const auto model = palpationAt({{0, 0}, {0, 0}});
  UnderSkin kept(*model);
  kept.look(model->start.q, {});
  for (int i = 0; i < static_cast<int>(model->objects.size()); ++i) EXPECT_TRUE(kept.shifts(i).empty()) << model->objects[i].id;
}

/// A state in which the muscles below the finger have swollen into the skin by so much, m, along it.
Pressed swollen(const Model& model, double by) {
  Pressed at;
  at.state = model.start;
  const Pose home = model.scenario.tools[0].home;
  const Vec3 out = home.q_WB * Vec3::UnitZ();
  constexpr double kWide = 0.03;  // m
  for (const SceneObject& object : model.objects)
    if (object.id.starts_with("deltoid"))
      for (int n = 0; n < object.layout.nodeCount; ++n) {
        auto node = at.state.q.segment<3>(object.layout.qOffset + 3 * n);
        node += by * std::exp(-(node - home.p_WB).squaredNorm() / (2 * kWide * kWide)) * out;
      }
  return at;
}

TEST(UnderSkin, holdsWhateverMovesTheMuscle) {
  const auto model = palpationAt({{0, 0}, {0, 0}});
  UnderSkin kept(*model);
  const Pressed end = swollen(*model, 0.012);
  EXPECT_GT(throughSkin(*model, end, nullptr).depth, 5e-3);
  kept.look(end.state.q, {});
  EXPECT_LT(throughSkin(*model, end, &kept).depth, 5e-4);
  // What is shown does not depend on what was shown before.
  const int muscle = findPart(model->joint, "deltoid-acromial");
  const std::vector<Vec3> first(kept.shifts(muscle).begin(), kept.shifts(muscle).end());
  kept.look(model->start.q, {});
  kept.look(end.state.q, {});
  EXPECT_TRUE(std::ranges::equal(first, kept.shifts(muscle)));
}

TEST(UnderSkin, aSkinThatIsNotShownCoversNothing) {
  const auto model = palpationAt({{0, 0}, {0, 0}});
  UnderSkin kept(*model);
  std::vector<char> shown(model->objects.size(), 1);
  shown[findPart(model->joint, "skin")] = 0;
  kept.look(swollen(*model, 0.012).state.q, {}, shown);
  for (int i = 0; i < static_cast<int>(model->objects.size()); ++i) EXPECT_TRUE(kept.shifts(i).empty());
}

TEST(UnderSkin, aSceneWithoutSkinHasNothingToDo) {
  const Joint joint = loadJoint(kResources + "/joints/shoulder.joint").value();
  const auto model = compileModel(joint, loadScenario(kResources + "/scenarios/arthroscopy.scenario.json").value()).value();
  EXPECT_TRUE(UnderSkin(*model).empty());
}

}  // namespace
}  // namespace glenoid
