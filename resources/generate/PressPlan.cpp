// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/PressPlan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "simcore/spatial/TriangleTree.h"

namespace glenoid::generate {

namespace {

constexpr double kRetreat = 0.06;       ///< m: how far out the tip goes between two targets
constexpr double kEnoughRoom = 4e-3;    ///< m: more room than this makes no approach better
constexpr double kReach = 0.012;        ///< m: how far the room is looked for

/// Evenly spread unit directions, the same in every run.
std::vector<Vec3> directions(int count) {
  std::vector<Vec3> list;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double y = 1 - 2 * (i + 0.5) / count, r = std::sqrt(1 - y * y);
    list.push_back(Vec3(r * std::cos(golden * i), y, r * std::sin(golden * i)));
  }
  return list;
}

/// Turn with +Z along `axis` and the hook (+X) rolled by `angle` about it.
Quat rolled(const Vec3& axis, double angle) {
  return Quat(Eigen::AngleAxisd(angle, axis)) * Quat::FromTwoVectors(Vec3::UnitZ(), axis);
}

struct Obstacle {
  TriangleTree tree;
  bool isTarget;
};

/// Least room around a tool whose tip touches the target; the target itself counts only away from the tip.
double roomOf(const std::vector<Obstacle>& obstacles, const Tool& tool, const Vec3& tip, const Quat& q, double enough) {
  double room = kReach;
  const auto look = [&](const Vec3& p, double along) {
    for (const Obstacle& obstacle : obstacles) {
      if (obstacle.isTarget && along < 5e-3) continue;
      const double signedDistance = obstacle.tree.inside(p) ? -1e-3 : obstacle.tree.closest(p, kReach + tool.radius).distance;
      room = std::min(room, signedDistance - tool.radius);
    }
  };
  if (tool.kind == ToolKind::Probe)
    for (const double x : {3e-3, 7e-3}) look(tip + q * Vec3(x, 0, 2 * tool.radius), 6e-3);
  for (double t = 2e-3; t <= tool.length && room > enough; t += t < 0.03 ? 2e-3 : 6e-3)
    look(tip + q * Vec3(0, 0, t + tool.radius), t);
  return room;
}

/// Triangles of the collision surface that may be pressed: all, or those near the region.
std::vector<int> candidates(const Part& part, const std::string& regionId) {
  std::vector<int> list;
  const Region* region = regionId.empty() ? nullptr : findRegion(part, regionId);
  std::optional<TriangleTree> near;
  if (region) {
    TriMesh mesh;
    for (const int t : trianglesOf(*region)) {
      const int first = static_cast<int>(mesh.vertices.size());
      for (const int v : part.visual->triangles[t]) mesh.vertices.push_back(part.visual->vertices[v]);
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    near.emplace(mesh);
  }
  for (std::size_t t = 0; t < part.collision->triangles.size(); ++t) {
    Vec3 centroid = Vec3::Zero();
    for (const int v : part.collision->triangles[t]) centroid += part.collision->vertices[v] / 3;
    if (!near || near->closest(centroid).distance < 2.5e-3) list.push_back(static_cast<int>(t));
  }
  return list;
}

}  // namespace

Approach findApproach(const Joint& joint, const Tool& tool, const PressTarget& target, const Vec3& preferred_W) {
  std::vector<Obstacle> obstacles;
  for (const Part& part : joint.parts)
    if (std::find(tool.perforates.begin(), tool.perforates.end(), part.id) == tool.perforates.end())
      obstacles.push_back({TriangleTree(*part.collision), part.id == target.part});
  const Part& part = joint.parts[findPart(joint, target.part)];
  const std::vector<Vec3> all = directions(160);
  Approach best;
  double bestScore = -1e300;
  for (const int t : candidates(part, target.region)) {
    const auto& tri = part.collision->triangles[t];
    const Vec3 &a = part.collision->vertices[tri[0]], &b = part.collision->vertices[tri[1]], &c = part.collision->vertices[tri[2]];
    const Vec3 normal = (b - a).cross(c - a).normalized(), tip = (a + b + c) / 3;
    for (const Vec3& outward : all) {
      if (outward.dot(normal) < 0.55 || outward.dot(preferred_W) < 0.2) continue;
      for (int roll = 0; roll < 6; ++roll) {
        const Quat q = rolled(outward, roll * std::numbers::pi / 3);
        // A straight press slides least; room beyond enough adds nothing.
        const double straight = 2e-3 * outward.dot(normal) + 1e-3 * outward.dot(preferred_W);
        const double room = roomOf(obstacles, tool, tip, q, bestScore - straight);
        const double score = std::min(room, kEnoughRoom) + straight;
        if (score > bestScore) {
          bestScore = score;
          best = {tip, outward, q, room};
        }
      }
    }
  }
  return best;
}

Recording planPresses(const Joint& joint, const Scenario& scenario, const std::string& toolId,
                      const std::vector<PressTarget>& targets, const Vec3& preferred_W, double begin) {
  const Tool& tool = scenario.tools[findTool(scenario, toolId)];
  Recording recording;
  recording.dt = scenario.dt;
  HandTrack track;
  track.tool = toolId;
  const auto key = [&track](double time, const Vec3& p, const Quat& q) { track.keys.push_back({time, {p, q.normalized()}}); };
  key(begin, tool.home.p_WB, tool.home.q_WB);
  Vec3 from = tool.home.p_WB;
  Quat turn = tool.home.q_WB;
  double time = begin;
  for (const PressTarget& target : targets) {
    const Approach way = findApproach(joint, tool, target, preferred_W);
    const Vec3 away = way.tip_W + kRetreat * way.outward_W, near = way.tip_W + 3e-3 * way.outward_W;
    const Vec3 deep = way.tip_W - target.depth * way.outward_W;
    // Around, not through: the middle of the way is lifted to the preferred side.
    const Vec3 middle = 0.5 * (from + away) + 0.02 * preferred_W.normalized();
    key(time + 0.20, middle, turn.slerp(0.5, way.q_WT));
    key(time + 0.40, away, way.q_WT);
    key(time + 0.75, near, way.q_WT);
    key(time + 0.95, deep, way.q_WT);
    key(time + 1.75, deep, way.q_WT);
    key(time + 2.00, away, way.q_WT);
    recording.marks.push_back({target.mark, time + 0.95, time + 1.75, toolId, target.part});
    from = away;
    turn = way.q_WT;
    time += 2;
  }
  key(time + 0.4, tool.home.p_WB, tool.home.q_WB);
  recording.tracks.push_back(std::move(track));
  return recording;
}

}  // namespace glenoid::generate
