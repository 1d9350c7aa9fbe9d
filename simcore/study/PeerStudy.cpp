// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/PeerStudy.h"

#include <algorithm>
#include <cmath>

#include "simcore/body/SurfaceBinding.h"
#include "simcore/collide/Penetration.h"
#include "simcore/spatial/TrianglePoint.h"
#include "simcore/study/PeerBlocks.h"

namespace glenoid::peers {

namespace {

constexpr double kTooFar = 0.05;  ///< m: the ridge lifts by 3 mm, the ball presses by 10 mm

Vec3 placeOf(const Model& model, int object, const VertexBinding& binding, const VecX& q) {
  SurfaceBinding one;
  one.vertices = {binding};
  Vec3 place;
  surfacePositions(one, model.objects[object].layout, q, std::span(&place, 1));
  return place;
}

/// Looks at one state after another and keeps the worst of each figure.
class Look {
 public:
  explicit Look(const Model& model)
      : m_model(model), m_ball(kBlocks + 2 + kBall), m_all(model.collisionSurfaces, model.collisionPairs),
        m_ballOnly(model.collisionSurfaces, pairsOf(model, m_ball)) {
    for (const SceneObject& object : model.objects) m_positions.emplace_back(object.collision.vertices.size());
    for (const auto& positions : m_positions) m_spans.emplace_back(positions);
  }

  void at(const State& state, const Vec3& centre, const Vec3& tip, Row& row) {
    row.finite = row.finite && state.q.allFinite() && state.v.allFinite();
    if (!row.finite) return;
    for (std::size_t i = 0; i < m_positions.size(); ++i)
      surfacePositions(m_model.objects[i].collision, m_model.objects[i].layout, state.q, m_positions[i]);
    row.ballDepth = std::max(row.ballDepth, m_ballOnly.deepest(m_spans).depth);
    row.anyDepth = std::max(row.anyDepth, m_all.deepest(m_spans).depth);
    const SceneObject& ball = m_model.objects[m_ball];
    const Vec3 isTip = poseAt(state.q, ball.layout.qOffset) * (ball.collision.vertices[0].r_B);
    row.ballLag = std::max(row.ballLag, (isTip - tip).norm());
    for (int block = 0; block < kBlocks; ++block) {
      const SceneObject& object = m_model.objects[block];
      const auto node = [&](int i) -> Vec3 { return state.q.segment<3>(object.layout.qOffset + 3 * i); };
      for (const auto& t : object.volume->tets) {
        const auto six = [&](auto&& x) { return (x(t[1]) - x(t[0])).dot((x(t[2]) - x(t[0])).cross(x(t[3]) - x(t[0]))); };
        const auto rest = [&](int i) -> Vec3 { return object.volume->nodes[i]; };
        row.volumeRatioMin = std::min(row.volumeRatioMin, six(node) / six(rest));
      }
      for (std::size_t i = 0; i < object.volume->nodes.size(); ++i)
        m_furthest = std::max(m_furthest, (node(static_cast<int>(i)) - object.volume->nodes[i]).norm());
      const auto& x = m_positions[block];
      for (const auto& [i, j, k] : object.collision.mesh->triangles) {
        const Vec3 w = nearestBarycentric(centre, x[i], x[j], x[k]);
        const double distance = (w[0] * x[i] + w[1] * x[j] + w[2] * x[k] - centre).norm();
        row.sphereDepth = std::max(row.sphereDepth, kBallRadius - distance);
      }
    }
    for (const SpringView& spring : m_model.springs)
      row.bindingGap = std::max(row.bindingGap, (placeOf(m_model, spring.objectA, spring.a, state.q) -
                                                 placeOf(m_model, spring.objectB, spring.b, state.q)).norm());
  }

  double furthest() const { return m_furthest; }

 private:
  static std::vector<CollisionPair> pairsOf(const Model& model, int object) {
    std::vector<CollisionPair> pairs;
    for (const CollisionPair& pair : model.collisionPairs)
      if (pair.surfaceA == object || pair.surfaceB == object) pairs.push_back(pair);
    return pairs;
  }

  const Model& m_model;
  int m_ball;
  PenetrationCheck m_all, m_ballOnly;
  std::vector<std::vector<Vec3>> m_positions;
  std::vector<std::span<const Vec3>> m_spans;
  double m_furthest = 0;
};

/// Nearest rank.
double quantile(const std::vector<double>& sorted, double q) {
  if (sorted.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

}  // namespace

Result<Row> measure(Stiffness stiffness, double dt, const MeasureOptions& options) {
  const auto compiled = compileModel(makeJoint(stiffness), makeScenario(dt));
  if (!compiled) return compiled.error();
  const Model& model = **compiled;
  Stepper stepper(*compiled, options.stepper);
  Look look(model);
  State state = model.start;
  Inputs inputs;
  Row row;
  row.simulator = "glenoid";
  row.stiffness = stiffnessName(stiffness);
  row.dt = dt;
  row.finite = true;
  std::vector<double> ms;
  const long steps = std::lround(std::min(options.seconds, kSeconds) / dt);
  for (long i = 1; i <= steps && row.finite; ++i) {
    handsAt(static_cast<double>(i) * dt, inputs.hands);
    const StepReport& report = stepper.step(inputs, state);
    ms.push_back(report.stepCpuMs);
    row.simulated = state.time;
    row.finite = report.taken;
    row.contactsMean += static_cast<double>(report.contacts) / static_cast<double>(steps);
    row.contactsMax = std::max(row.contactsMax, report.contacts);
    row.complementarity = std::max(row.complementarity, report.complementarity);
    row.contactFallbacks += report.pivotsExhausted;
    look.at(state, ballCentre(state.time), inputs.hands[kBall].p_WB, row);
    if (options.eachStep) options.eachStep(state, report);
  }
  row.contactConverged = row.finite && row.complementarity < kComplementarity;
  row.stable = row.finite && look.furthest() < kTooFar && row.volumeRatioMin > 0;
  std::sort(ms.begin(), ms.end());
  row.msMedian = quantile(ms, 0.5);
  row.msP95 = quantile(ms, 0.95);
  row.msP99 = quantile(ms, 0.99);
  return row;
}

JsonValue toJson(const Row& row) {
  JsonValue json = JsonValue::object();
  json.set("simulator", row.simulator);
  json.set("stiffness", row.stiffness);
  json.set("dt", row.dt);
  json.set("simulated", row.simulated);
  json.set("msMedian", row.msMedian);
  json.set("msP95", row.msP95);
  json.set("msP99", row.msP99);
  json.set("finite", row.finite);
  json.set("stable", row.stable);
  json.set("ballDepth", row.ballDepth);
  json.set("sphereDepth", row.sphereDepth);
  json.set("anyDepth", row.anyDepth);
  json.set("ballLag", row.ballLag);
  json.set("volumeRatioMin", row.volumeRatioMin);
  json.set("bindingGap", row.bindingGap);
  json.set("contactsMean", row.contactsMean);
  json.set("contactsMax", row.contactsMax);
  json.set("contactConverged", row.contactConverged);
  json.set("complementarity", row.complementarity);
  json.set("contactFallbacks", row.contactFallbacks);
  return json;
}

Row toRow(const JsonValue& json) {
  Row row;
  row.simulator = json["simulator"].text();
  row.stiffness = json["stiffness"].text();
  row.dt = json["dt"].number();
  row.simulated = json["simulated"].number();
  row.msMedian = json["msMedian"].number();
  row.msP95 = json["msP95"].number();
  row.msP99 = json["msP99"].number();
  row.finite = json["finite"].boolean();
  row.stable = json["stable"].boolean();
  row.ballDepth = json["ballDepth"].number();
  row.sphereDepth = json["sphereDepth"].number();
  row.anyDepth = json["anyDepth"].number();
  row.ballLag = json["ballLag"].number();
  row.volumeRatioMin = json["volumeRatioMin"].number(1);
  row.bindingGap = json["bindingGap"].number();
  row.contactsMean = json["contactsMean"].number();
  row.contactsMax = static_cast<int>(json["contactsMax"].integer());
  row.contactConverged = json["contactConverged"].boolean();
  row.complementarity = json["complementarity"].number();
  row.contactFallbacks = static_cast<int>(json["contactFallbacks"].integer());
  return row;
}

}  // namespace glenoid::peers
