// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen through an arthroscope, against the geometry written down once more: small balls at known directions.
#include <cmath>
#include <numbers>

#include "editor/render/ScopeView.h"
#include "simcore/author/MirrorJoint.h"
#include "simcore/tool/ScopeOptics.h"
#include "tests/editor/render/PictureCheck.h"
#include "tests/editor/render/TestScene.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kWidth = 480, kHeight = 360;

Tool scope(double lens, double turn) {
  Tool tool;
  tool.id = tool.name = "scope";
  tool.kind = ToolKind::Arthroscope;
  tool.radius = 0.002;
  tool.lens = lens * kDegree;
  tool.lensTurn = turn * kDegree;
  tool.home.p_WB = Vec3(0.1, -0.05, 0.2);
  tool.home.q_WB = Quat(Eigen::AngleAxisd(1.1, Vec3(0.3, -0.5, 0.8).normalized()));
  return tool;
}

/// Rigid balls, one a part, in sight of nothing but the tool.
Result<std::shared_ptr<const Model>> balls(const std::vector<Vec3>& places_W, double radius, const Tool& tool) {
  Joint joint;
  joint.id = joint.name = "balls";
  scenes::addMaterials(joint);
  for (std::size_t i = 0; i < places_W.size(); ++i) {
    Part part = scenes::boxPart("ball" + std::to_string(i), static_cast<int>(i) + 1, PartKind::Rigid, {0, 0, 0}, {1e-3, 1e-3, 1e-3});
    part.visual = part.collision = std::make_shared<const TriMesh>(sphereMesh(places_W[i], radius, 12));
    joint.parts.push_back(part);
  }
  Scenario scenario;
  scenario.id = scenario.name = "looks";
  scenario.effects.gravity = scenario.effects.contact = Wish::Off;
  for (const Part& part : joint.parts) scenario.fixedParts.push_back(part.id);
  scenario.tools = {tool};
  return compileModel(joint, scenario);
}

/// Middle of what is not dark within the field, pixels; nothing where all is dark.
std::optional<Vec2> brightMiddle(const Image& image) {
  double weight = 0;
  Vec2 sum = Vec2::Zero();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto p = image.at(x, y);
      const double light = std::max(0.0, (p[0] + p[1] + p[2]) / 3.0 - 60);
      weight += light;
      sum += light * Vec2(x + 0.5, y + 0.5);
    }
  if (!(weight > 0)) return std::nullopt;
  return Vec2(sum / weight);
}

TEST(ScopeOptics, lensAndLightPostTurnTheViewAndLeaveTheHorizonToTheHead) {
  EXPECT_LT((scopeAxes(scope(0, 40)).forward_B + Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((scopeAxes(scope(0, 40)).up_B - Vec3::UnitX()).norm(), 1e-15);
  for (const double lens : {30.0, 70.0})
    for (const double turn : {0.0, 65.0, 90.0, -130.0}) {
      const ScopeAxes axes = scopeAxes(scope(lens, turn));
      const Vec3 aside(std::cos(turn * kDegree), std::sin(turn * kDegree), 0);
      EXPECT_LT((axes.forward_B - (std::sin(lens * kDegree) * aside - std::cos(lens * kDegree) * Vec3::UnitZ())).norm(), 1e-12);
      EXPECT_NEAR(axes.up_B.norm(), 1, 1e-12);
      EXPECT_NEAR(axes.up_B.dot(axes.forward_B), 0, 1e-12);
      // The least turn leaves what is across both directions where it was.
      const Vec3 across = aside.cross(Vec3::UnitZ());
      EXPECT_NEAR(axes.up_B.dot(across), Vec3::UnitX().dot(across), 1e-12);
    }
  const ScopeAxes sideways = scopeAxes(scope(30, 90));
  EXPECT_LT((sideways.up_B - Vec3::UnitX()).norm(), 1e-12);
}

TEST(ScopeOptics, airWidensTheField) {
  Tool tool = scope(30, 0);
  tool.fieldOfView = 70 * kDegree;
  EXPECT_NEAR(halfFieldOf(tool), 35 * kDegree, 1e-15);
  tool.inAir = true;
  EXPECT_NEAR(halfFieldOf(tool), 49.9 * kDegree, 0.1 * kDegree);  // asin(1.333 · 0.5736)
  tool.fieldOfView = 110 * kDegree;
  EXPECT_EQ(halfFieldOf(tool), 1.5) << "no ray leaves water flatter than its surface";
}

TEST(ScopeOptics, aMirroredScopeLooksAtTheMirrorImage) {
  Scenario scenario;
  scenario.tools = {scope(30, 65)};
  const Tool &here = scenario.tools[0], there = mirroredScenario(scenario).tools[0];
  const auto mirrored = [](const Vec3& v) { return Vec3(v.x(), v.y(), -v.z()); };
  EXPECT_LT((there.home.q_WB * scopeAxes(there).forward_B - mirrored(here.home.q_WB * scopeAxes(here).forward_B)).norm(), 1e-12);
  EXPECT_LT((there.home.q_WB * scopeAxes(there).up_B - mirrored(here.home.q_WB * scopeAxes(here).up_B)).norm(), 1e-12);
}

class ScopePictures : public Drawing {
 protected:
  Image draw(const Model& model, int visible, const ScopeSight& sight, int width = kWidth, int height = kHeight) {
    Layers layers;
    layers.objects.assign(model.objects.size(), ObjectLook{});
    for (std::size_t i = 0; i < model.objects.size(); ++i)
      layers.objects[i].visible = !model.objects[i].tool && (visible < 0 || visible == static_cast<int>(i));
    Look look;
    look.samples = 1;
    look.supersample = 2;
    look.ambientOcclusion = false;
    look.scope = sight.look;
    auto image = m_renderer->picture(sight.view, model.start.q, layers, {}, look, width, height);
    EXPECT_TRUE(image.ok());
    return image.ok() ? *image : Image{};
  }
};

// The division model solved here by halving, the camera's axes by what the header says of lens and light post.
TEST_F(ScopePictures, ballsAreSeenWhereTheOpticsPutThem) {
  constexpr double kAway = 0.02;
  for (const double lens : {0.0, 30.0, 70.0})
    for (const double turn : {0.0, 100.0}) {
      SCOPED_TRACE("lens " + std::to_string(lens) + "°, light post " + std::to_string(turn) + "°");
      const Tool tool = scope(lens, turn);
      const double t = turn * kDegree, l = lens * kDegree;
      const Vec3 forward(std::sin(l) * std::cos(t), std::sin(l) * std::sin(t), -std::cos(l));
      const Quat least = Quat::FromTwoVectors(-Vec3::UnitZ(), forward);
      const Vec3 up = least * Vec3::UnitX(), right = forward.cross(up);
      struct Place { double theta, around; };  // from the middle; from up, clockwise
      const std::vector<Place> places{{0, 0}, {12, 0}, {20, 90}, {28, 200}, {31, 300}, {40, 45}};
      std::vector<Vec3> at;
      for (const Place& p : places) {
        const double theta = p.theta * kDegree, around = p.around * kDegree;
        at.push_back(tool.home.p_WB + kAway * (tool.home.q_WB * (std::cos(theta) * forward + std::sin(theta) * (std::cos(around) * up + std::sin(around) * right))));
      }
      const auto model = balls(at, 4e-4, tool);
      ASSERT_TRUE(model.ok()) << toLogLine(model.error());
      ASSERT_TRUE(m_renderer->setScene(**model).ok());
      const int object = *findScope(**model, "scope");
      const ScopeSight sight = scopeSight(**model, (*model)->start.q, object, kWidth, kHeight);
      EXPECT_LT((sight.view.eye_W - tool.home.p_WB).norm(), 1e-12) << "the eye is at the tip";
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double theta = places[i].theta * kDegree, around = places[i].around * kDegree, share = std::tan(theta) / std::tan(sight.look.halfField);
        const auto seen = brightMiddle(draw(**model, static_cast<int>(i), sight));
        ASSERT_EQ(seen.has_value(), share < 1) << places[i].theta << "°";
        ASSERT_EQ(seenThrough(sight, at[i], kWidth, kHeight).has_value(), share < 1);
        if (!seen) continue;
        double low = 0, high = 1;
        for (int k = 0; k < 60; ++k) {
          const double r = 0.5 * (low + high);
          (r * (1 + sight.look.distortion) / (1 + sight.look.distortion * r * r) < share ? low : high) = r;
        }
        const Vec2 expected(kWidth / 2.0 + low * scopeRadius(kWidth, kHeight) * std::sin(around), kHeight / 2.0 - low * scopeRadius(kWidth, kHeight) * std::cos(around));
        EXPECT_LT((*seen - expected).norm(), 1.5) << places[i].theta << "° at " << places[i].around << "°: " << seen->transpose() << ", not " << expected.transpose();
        EXPECT_LT((*seenThrough(sight, at[i], kWidth, kHeight) - expected).norm(), 1e-6);
      }
    }
}

/// A wall across the field, at this distance before the lens.
std::shared_ptr<const Model> wall(const Tool& tool, double away) {
  Joint joint;
  joint.id = joint.name = "wall";
  scenes::addMaterials(joint);
  Part part = scenes::boxPart("wall", 1, PartKind::Rigid, {0, 0, 0}, {1e-3, 1e-3, 1e-3});
  TriMesh box = boxMesh(Vec3(0.3, 0.3, 0.005));
  for (Vec3& x : box.vertices) x = tool.home.p_WB + tool.home.q_WB * Vec3(x - Vec3(0, 0, away + 0.005));
  part.visual = part.collision = std::make_shared<const TriMesh>(box);
  joint.parts.push_back(part);
  Scenario scenario;
  scenario.id = scenario.name = "wall";
  scenario.effects.gravity = scenario.effects.contact = Wish::Off;
  scenario.fixedParts = {"wall"};
  scenario.tools = {tool};
  return compileModel(joint, scenario).value();
}

double lightAt(const Image& image, double fromMiddle, double around, int width = kWidth, int height = kHeight) {
  const double radius = scopeRadius(width, height);
  const auto p = image.at(static_cast<int>(width / 2.0 + fromMiddle * radius * std::sin(around)), static_cast<int>(height / 2.0 - fromMiddle * radius * std::cos(around)));
  return (p[0] + p[1] + p[2]) / 3.0;
}

TEST_F(ScopePictures, theFieldIsRoundAndItsMarkStandsWhereTheLensLooks) {
  for (const double turn : {0.0, 90.0, -45.0}) {
    const Tool tool = scope(30, turn);
    const auto model = wall(tool, 0.012);
    ASSERT_TRUE(m_renderer->setScene(*model).ok());
    const ScopeSight sight = scopeSight(*model, model->start.q, *findScope(*model), kWidth, kHeight);
    const Image image = draw(*model, -1, sight);
    for (int k = 0; k < 16; ++k) {
      EXPECT_EQ(lightAt(image, 1.02, k * std::numbers::pi / 8), 0);
      const double around = (k + 0.5) * std::numbers::pi / 8;  // the mark is narrower than what lies between
      EXPECT_GT(lightAt(image, 0.96, around), 15) << k;
    }
    EXPECT_LT(lightAt(image, 0.97, -turn * kDegree), 5) << "the mark: clockwise from up, where +Y is left";
    EXPECT_GT(lightAt(image, 0.97, -turn * kDegree + std::numbers::pi), 15);
  }
  const Tool straight = scope(0, 0);
  const auto model = wall(straight, 0.012);
  ASSERT_TRUE(m_renderer->setScene(*model).ok());
  const Image image = draw(*model, -1, scopeSight(*model, model->start.q, *findScope(*model), kWidth, kHeight));
  EXPECT_GT(lightAt(image, 0.97, 0), 15) << "a straight lens looks to no side";
}

TEST_F(ScopePictures, theLampStandsAtTheLens) {
  double last = 1e9;
  for (const double away : {0.006, 0.012, 0.024, 0.048, 0.1}) {
    const Tool tool = scope(0, 0);
    const auto model = wall(tool, away);
    ASSERT_TRUE(m_renderer->setScene(*model).ok());
    const Image image = draw(*model, -1, scopeSight(*model, model->start.q, *findScope(*model), kWidth, kHeight));
    const double middle = lightAt(image, 0.05, 0.3);
    EXPECT_LT(middle, last) << "nearer is brighter";
    last = middle;
    for (const double around : {0.0, 1.5, 3.0, 4.5}) EXPECT_LT(lightAt(image, 0.8, around), middle) << "the rim of a wall is farther and seen from the side";
  }
  EXPECT_LT(last, 40) << "ten centimetres away it is dark";
}

TEST_F(ScopePictures, hazeTakesContrastAndBloodReddens) {
  const Tool tool = scope(30, 0);
  const auto model = wall(tool, 0.015);
  ASSERT_TRUE(m_renderer->setScene(*model).ok());
  ScopeSight sight = scopeSight(*model, model->start.q, *findScope(*model), kWidth, kHeight);
  const Image clear = draw(*model, -1, sight);
  const auto redness = [](const Image& image) {
    double red = 0, all = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) red += image.at(x, y)[0], all += image.at(x, y)[0] + image.at(x, y)[1] + image.at(x, y)[2];
    return red / all;
  };
  double last = redness(clear);
  for (const double bleeding : {0.3, 0.6, 1.0}) {
    sight.look.bleeding = bleeding;
    const double red = redness(draw(*model, -1, sight));
    EXPECT_GT(red, last);
    last = red;
  }
  sight.look.bleeding = 0;
  sight.look.haze = 1;
  const Image veiled = draw(*model, -1, sight);
  const auto a = clear.at(kWidth / 2, kHeight / 2), b = veiled.at(kWidth / 2, kHeight / 2);
  EXPECT_NE(a, b);
  EXPECT_EQ(draw(*model, -1, sight).rgba, veiled.rgba) << "no chance in it";
}

TEST_F(ScopePictures, anyShapeOfPictureHoldsTheWholeField) {
  const Tool tool = scope(30, 0);
  const auto model = wall(tool, 0.012);
  ASSERT_TRUE(m_renderer->setScene(*model).ok());
  for (const auto& [width, height] : {std::pair{200, 400}, {500, 200}, {64, 64}}) {
    const Image image = draw(*model, -1, scopeSight(*model, model->start.q, *findScope(*model), width, height), width, height);
    for (const double around : {0.7, 2.2, 3.8, 5.4}) {
      EXPECT_GT(lightAt(image, 0.93, around, width, height), 15) << width;
      EXPECT_EQ(lightAt(image, 1.06, around, width, height), 0) << width;
    }
  }
}

}  // namespace
}  // namespace glenoid::test
