// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/StabilityHands.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

constexpr double kDeepest = 0.05;    ///< m: no tool is pushed further in
constexpr double kBeyond = 0.02;     ///< m, of a dash
constexpr double kWay = 0.06;        ///< m, of a drag, from one end to the other
constexpr double kAside = 0.05;      ///< m, where a hand is after a silence
constexpr double kDragDepth = 0.01;  ///< m

TriMesh moved(const SceneObject& object, const VecX& q) {
  TriMesh mesh = *object.collision.mesh;
  surfacePositions(object.collision, object.layout, q, mesh.vertices);
  return mesh;
}

/// How far beyond `at` along a direction the first stretch inside is deepest; 0 where there is none.
double deepestAlong(const TriangleTree& tree, const Vec3& at, const Vec3& direction) {
  constexpr double kSample = 5e-4;
  double best = 0, most = 0;
  bool entered = false;
  for (int i = 1; i * kSample <= kDeepest; ++i) {
    const double depth = -tree.signedDistance(at + i * kSample * direction);
    if (depth <= 0 && entered) break;
    entered = entered || depth > 0;
    if (depth > most) most = depth, best = i * kSample;
  }
  return best;
}

Vec3 normalOf(const TriMesh& mesh, int triangle) {
  const auto& t = mesh.triangles[static_cast<std::size_t>(triangle)];
  return (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).normalized();
}

/// From 0 to 1 between two moments, evenly.
double ramp(double time, double begin, double end) { return std::clamp((time - begin) / (end - begin), 0.0, 1.0); }

/// To and fro between −1 and 1 from 0, straight; a round trip takes 4.
double zigzag(double way) {
  const double phase = way - 4 * std::floor(way / 4);
  return phase < 1 ? phase : phase < 3 ? 2 - phase : phase - 4;
}

/// Across the inward direction, whatever that is.
Vec3 sideways(const Touch& touch) {
  int axis = 0;
  touch.inward_W.cwiseAbs().minCoeff(&axis);
  return touch.inward_W.cross(Vec3::Unit(axis)).normalized();
}

/// Of the way of a dash, m.
double dashLength(const Touch& touch) { return (touch.at_W + (touch.inside + kBeyond) * touch.inward_W - touch.home_W).norm(); }

double pressShare(double time) { return ramp(time, 0, 0.3) - ramp(time, 0.6, 0.9); }

Pose playHand(const Tool& tool, const Touch& touch, HandPlay play, double amount, double time) {
  Pose hand = tool.home;
  const Vec3 deep = touch.at_W + touch.inside * touch.inward_W;
  const auto towards = [&](const Vec3& there, double share) { return Vec3(touch.home_W + share * (there - touch.home_W)); };
  const auto pressed = [&](double depth) { return Vec3(touch.at_W + std::min(depth, touch.inside) * touch.inward_W); };
  switch (play) {
    case HandPlay::Press: hand.p_WB = towards(pressed(amount), pressShare(time)); break;
    case HandPlay::Jump:
      if (time < amount) hand.p_WB = deep;
      break;
    case HandPlay::Dash: {
      const Vec3 there = deep + kBeyond * touch.inward_W;
      const double taken = dashLength(touch) / amount;
      hand.p_WB = towards(there, ramp(time, 0, taken) - ramp(time, 0.3, 0.3 + taken));
      break;
    }
    case HandPlay::Drag: {
      const double share = ramp(time, 0, 0.1) - ramp(time, 0.6, 0.7), way = std::clamp(time, 0.1, 0.6) - 0.1;
      hand.p_WB = towards(pressed(kDragDepth), share) + share * kWay / 2 * zigzag(way * amount / (kWay / 2)) * sideways(touch);
      break;
    }
    case HandPlay::Silent: {
      const double silent = 0.35;
      const Vec3 aside = time >= silent + amount ? Vec3(kAside * (1 - ramp(time, silent + amount, 0.9)) * sideways(touch)) : Vec3::Zero();
      hand.p_WB = towards(pressed(0.01), pressShare(time >= silent && time < silent + amount ? silent : time)) + aside;
      break;
    }
    case HandPlay::Wild:
      if (time >= amount) break;
      hand.p_WB = towards(pressed(0.01), ramp(time, 0, 0.3));
      hand = wildPose(hand, std::lround(time * 50) % 10);
      break;
  }
  return hand;
}

}  // namespace

std::vector<Touch> touchesOf(const Model& model, const State& state) {
  std::vector<Touch> touches;
  if (!model.effectOn("contact")) return touches;
  for (std::size_t t = 0; t < model.objects.size(); ++t) {
    const SceneObject& object = model.objects[t];
    if (!object.tool || !model.scenario.tools[static_cast<std::size_t>(object.toolIndex)].link.empty()) continue;
    const Tool& tool = model.scenario.tools[static_cast<std::size_t>(object.toolIndex)];
    std::vector<std::pair<double, Touch>> nearest;
    for (const bool rigid : {false, true}) {
      Touch best;
      double distance = HUGE_VAL;
      for (const CollisionPair& pair : model.collisionPairs) {
        const int other = pair.surfaceA == static_cast<int>(t) ? pair.surfaceB : pair.surfaceB == static_cast<int>(t) ? pair.surfaceA : -1;
        if (other < 0 || model.objects[static_cast<std::size_t>(other)].tool || model.objects[static_cast<std::size_t>(other)].layout.rigid != rigid) continue;
        const TriangleTree tree(moved(model.objects[static_cast<std::size_t>(other)], state.q));
        const TriangleTree::Closest found = tree.closest(tool.home.p_WB);
        if (!(found.distance < distance)) continue;
        distance = found.distance;
        best = {object.toolIndex, static_cast<int>(t), other, tool.home.p_WB, found.point, (found.point - tool.home.p_WB).normalized(), 0};
        best.inside = found.distance < 1e-3 ? 0 : deepestAlong(tree, best.at_W, best.inward_W);
        if (best.inside > 0) continue;
        best.inward_W = -normalOf(tree.mesh(), found.triangle);  // it starts there, or goes along the surface
        best.inside = deepestAlong(tree, best.at_W, best.inward_W);
      }
      if (best.object >= 0) nearest.push_back({distance, best});
    }
    std::stable_sort(nearest.begin(), nearest.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [distance, touch] : nearest) touches.push_back(touch);
  }
  return touches;
}

double endOf(const Touch& touch, HandPlay play, double amount) {
  switch (play) {
    case HandPlay::Jump:
    case HandPlay::Wild: return amount;
    case HandPlay::Dash: return 0.3 + dashLength(touch) / amount;
    case HandPlay::Drag: return 0.7;
    default: return 0.9;
  }
}

Pose wildPose(const Pose& from, long n) {
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  Pose hand = from;
  switch (n) {
    case 1: hand.p_WB.x() = kNan; break;
    case 2: hand.p_WB = Vec3::Constant(1e30); break;
    case 3: hand.q_WB.coeffs() = Vec4::Constant(kNan); break;
    case 4: hand.q_WB.coeffs().setZero(); break;
    case 5: hand.p_WB.y() = -kInf; break;
    case 6: hand.p_WB = Vec3(0, -1e30, 0); break;
    case 7: hand.q_WB.coeffs() *= 1e30; break;
    case 8: hand.p_WB.z() = std::numeric_limits<double>::max(); break;
    default: break;
  }
  return hand;
}

Inputs playHands(const Model& model, const Touch& touch, HandPlay play, double amount, double time) {
  Inputs inputs;
  for (const Tool& tool : model.scenario.tools) inputs.hands.push_back(tool.home);
  inputs.hands[static_cast<std::size_t>(touch.tool)] = playHand(model.scenario.tools[static_cast<std::size_t>(touch.tool)], touch, play, amount, time);
  return inputs;
}

}  // namespace glenoid
