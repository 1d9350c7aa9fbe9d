// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/RestWatch.h"

#include <algorithm>
#include <cmath>

#include "simcore/base/Turns.h"

namespace glenoid {
namespace {

bool samePose(const Pose& a, const Pose& b) {
  return a.p_WB == b.p_WB && a.q_WB.coeffs() == b.q_WB.coeffs();
}

double reachOf(const SceneObject& object, const Vec3& centre_W) {
  double reach2 = 0;
  if (object.visual.mesh)
    for (const Vec3& vertex : object.visual.mesh->vertices) reach2 = std::max(reach2, (vertex - centre_W).squaredNorm());
  return std::sqrt(reach2);
}

/// When the hand of a tool, or of the one that carries it, begins to move.
double motionOf(const Scenario& scenario, int tool, const Recording& input) {
  for (std::size_t links = 0; tool >= 0 && !scenario.tools[tool].link.empty() && links < scenario.tools.size(); ++links)
    tool = findTool(scenario, scenario.tools[tool].link);
  double first = HUGE_VAL;
  for (const HandTrack& track : input.tracks)
    if (tool >= 0 && track.tool == scenario.tools[tool].id) first = std::min(first, firstMotion(track).value_or(HUGE_VAL));
  return first;
}

}  // namespace

std::optional<double> firstMotion(const HandTrack& track) {
  for (std::size_t k = 1; k < track.keys.size(); ++k)
    if (!samePose(track.keys[k].hand, track.keys[k - 1].hand)) return track.keys[k - 1].time;
  return std::nullopt;
}

RestWatch::RestWatch(const Model& model, const Recording* input) : m_model(model), m_moves(model.objects.size(), HUGE_VAL) {
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const SceneObject& object = model.objects[i];
    if (object.tool && object.toolIndex >= 0 && input) m_moves[i] = motionOf(model.scenario, object.toolIndex, *input);
    if (object.tool) continue;
    Part part{static_cast<int>(i), 0};
    if (object.motion >= 0) {
      part.motion = object.motion;
      part.reach = reachOf(object, model.scenario.motions[object.motion].centre_W);
    } else if (!object.layout.free) {
      continue;
    } else if (object.layout.rigid && model.start.q.size() >= object.layout.qOffset + 3) {
      part.reach = reachOf(object, model.start.q.segment<3>(object.layout.qOffset));
    }
    m_parts.push_back(part);
  }
}

double RestWatch::fastest(double time, const VecX& v) const {
  double fastest = 0;
  for (const Part& part : m_parts) {
    const ObjectLayout& layout = m_model.objects[part.object].layout;
    if (part.motion >= 0) {
      const Motion& motion = m_model.scenario.motions[part.motion];
      const double dt = m_model.scenario.dt;
      const Pose from = motionAt(motion, time), to = motionAt(motion, time + dt);
      const double way = (to * motion.centre_W - from * motion.centre_W).norm() + turnBetween(from.q_WB, to.q_WB) * part.reach;
      fastest = std::max(fastest, way / dt);
    } else if (layout.rigid) {
      fastest = std::max(fastest, v.segment<3>(layout.vOffset).norm() + part.reach * v.segment<3>(layout.vOffset + 3).norm());
    } else {
      for (int node = 0; node < layout.nodeCount; ++node) fastest = std::max(fastest, v.segment<3>(layout.vOffset + 3 * node).norm());
    }
  }
  return fastest;
}

bool RestWatch::touches(const StepReport& step, double time) const {
  const double now = time + m_model.scenario.dt / 2;  // times are sums of steps and carry their round-off
  return std::any_of(step.contactViews.begin(), step.contactViews.end(), [&](const ContactView& c) {
    return !c.film && (m_moves[c.objectA] <= now || m_moves[c.objectB] <= now);
  });
}

void RestWatch::add(const StepReport& step, double time, const VecX& v) {
  const double dt = m_model.scenario.dt;
  const bool whole = m_model.scenario.loads.empty() || loadShareAt(m_model.scenario, time + dt / 2) >= 1;
  m_speed = fastest(time, v);
  const bool slow = whole && step.taken && m_speed <= kSlow;
  m_rise = !whole;
  m_whole = m_whole || whole;
  m_slow = slow ? m_slow + 1 : 0;
  m_slowMost = std::max(m_slowMost, m_slow);
  m_atRest = slow && !touches(step, time);
  if (m_over) return;
  if (m_atRest) {
    m_stretch.push_back({static_cast<double>(step.contacts), static_cast<double>(step.pressing)});
    if (static_cast<double>(m_stretch.size()) > std::round(kMost / dt)) m_stretch.pop_front();
  } else if (contacts()) {
    m_over = true;
  } else {
    m_stretch.clear();
  }
}

std::optional<RestWatch::Contacts> RestWatch::contacts() const {
  const double steps = static_cast<double>(m_stretch.size());
  if (steps < std::max(1.0, std::round(kLeast / m_model.scenario.dt))) return std::nullopt;
  Contacts sum;
  for (const Contacts& step : m_stretch) {
    sum.rows += step.rows;
    sum.pressing += step.pressing;
  }
  return Contacts{sum.rows / steps, sum.pressing / steps};
}

std::string RestWatch::reason() const {
  if (contacts()) return "";
  if (!m_whole) return "loads-still-rise";
  return m_slowMost < std::round(kLeast / m_model.scenario.dt) ? "parts-still-move" : "tools-touch";
}

}  // namespace glenoid
