// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/train/TaskJudge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simcore/train/Sight.h"

namespace glenoid {

Result<TaskJudge> TaskJudge::make(const Model& model, const Task& task) {
  TaskJudge judge(model, task);
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const SceneObject& object = model.objects[i];
    if (!object.tool) continue;
    const Tool& tool = model.scenario.tools[object.toolIndex];
    const bool fits = task.tool.empty() ? tool.link.empty() && (task.kind != TaskKind::Look || tool.kind == ToolKind::Arthroscope) : tool.id == task.tool;
    if (!fits) continue;
    judge.m_tools.push_back(static_cast<int>(i));
    judge.m_tips.emplace_back(model, static_cast<int>(i), Vec3::Zero());
  }
  if (judge.m_tools.empty()) return Error{Fault::UnknownId, {"", "/training/tasks", task.id, {}}, {task.tool, "tool"}, "task"};
  for (const TaskPlace& place : task.places) {
    Result<BoundPlace> bound = BoundPlace::bind(model, place);
    if (!bound) return bound.error();
    judge.m_places.push_back(std::move(*bound));
  }
  return judge;
}

void TaskJudge::open(double time) {
  m_record.outcome = TaskOutcome::Open;
  m_record.opened = time;
  m_before_W.clear();
}

void TaskJudge::look(const StepSeen& seen) {
  if (m_record.outcome != TaskOutcome::Open) return;
  switch (m_task->kind) {
    case TaskKind::Touch:
    case TaskKind::Press: touch(seen); break;
    case TaskKind::Look: lookAt(seen); break;
    case TaskKind::Trace: trace(seen); break;
    case TaskKind::Follow: follow(seen); break;
    case TaskKind::Find: find(seen); break;
    case TaskKind::Pass: pass(seen); break;
  }
  // Half a step of slack: times are sums of steps and carry their round-off.
  if (m_record.outcome == TaskOutcome::Open && m_task->timeMax > 0 && seen.state.time >= *m_record.opened + m_task->timeMax - seen.dt / 2) {
    m_record.outcome = TaskOutcome::Missed;
    m_record.ended = seen.state.time;
  }
}

bool TaskJudge::presses(const StepSeen& seen) const {
  if (m_task->kind != TaskKind::Touch && m_task->kind != TaskKind::Press) return false;
  ToolTouch touch;
  double distance = 0;
  return touchingTool(seen, touch, distance) >= 0 && touch.force >= m_task->forceMin;
}

/// Of the tools that may do it and touch at its place the one that presses hardest; −1 where none does.
int TaskJudge::touchingTool(const StepSeen& seen, ToolTouch& most, double& distance) const {
  int tool = -1;
  for (const int candidate : m_tools) {
    const ToolTouch touch = toolTouch(seen.model, seen.step, candidate, m_places[0].object());
    if (!(touch.force > most.force)) continue;
    const double away = m_places[0].distanceTo(touch.point_W, seen.state.q);
    if (away <= m_task->tolerance) most = touch, tool = candidate, distance = away;
  }
  return tool;
}

/// Of the tools that may do it the one that presses hardest on the part (−1: on anything); −1 where none does.
int TaskJudge::pressingTool(const StepSeen& seen, int part, ToolTouch& most) const {
  int tool = -1;
  for (const int candidate : m_tools) {
    const ToolTouch touch = toolTouch(seen.model, seen.step, candidate, part);
    if (touch.force > most.force) most = touch, tool = candidate;
  }
  return tool;
}

Vec3 TaskJudge::tip(const StepSeen& seen, int tool) const {
  const auto found = std::find(m_tools.begin(), m_tools.end(), tool);
  return m_tips[static_cast<std::size_t>(found - m_tools.begin())].at(seen.model, seen.state.q);
}

/// An error each time the force passes its limit, after a while below it: a tool that knocks once counts once.
void TaskJudge::tooHard(double force, double dt) {
  m_hard = m_task->forceMax && force > *m_task->forceMax;
  if (m_hard && m_below >= kBelow - dt / 2) ++m_record.errors;
  m_below = m_hard ? 0 : m_below + dt;
}

void TaskJudge::done(double time, std::optional<double> distance) {
  m_record.outcome = TaskOutcome::Done;
  m_record.ended = time;
  m_record.progress = 1;
  m_record.distance = distance;
}

void TaskJudge::touch(const StepSeen& seen) {
  ToolTouch touch;
  double distance = 0;
  const int tool = touchingTool(seen, touch, distance);
  const bool here = tool >= 0;
  if (here) {
    m_record.tool = tool;
    m_record.forceMax = std::max(m_record.forceMax, touch.force);
    m_record.forceSum += touch.force * seen.dt;
    m_record.touchSeconds += seen.dt;
  }
  tooHard(here ? touch.force : 0, seen.dt);
  const bool counts = here && touch.force >= m_task->forceMin && !(m_task->kind == TaskKind::Press && m_hard);
  m_held = counts ? m_held + seen.dt : 0;
  m_record.progress = m_task->hold > 0 ? std::min(1.0, m_held / m_task->hold) : 0;
  if (counts && m_held >= m_task->hold - seen.dt / 2) done(seen.state.time, distance);
}

void TaskJudge::lookAt(const StepSeen& seen) {
  const Vec3 place = m_places[0].point(seen.state.q);
  bool counts = false;
  double off = 0;
  for (const int tool : m_tools) {
    const ScopeView view = scopeView(seen.model, seen.state.q, tool);
    const Vec3 way = place - view.lens_W;
    const double distance = way.norm();
    if (!(distance > 0) || distance > m_task->range) continue;
    const double angle = std::atan2(way.cross(view.axis_W).norm(), way.dot(view.axis_W));
    if (angle > m_task->angle || !inSight(seen.model, seen.state.q, tool, view.lens_W, place, m_task->tolerance)) continue;
    counts = true;
    off = distance * std::sin(angle);
    m_record.tool = tool;
    break;
  }
  if (counts) m_record.seenSeconds += seen.dt;
  m_held = counts ? m_held + seen.dt : 0;
  m_record.progress = m_task->hold > 0 ? std::min(1.0, m_held / m_task->hold) : 0;
  if (counts && m_held >= m_task->hold - seen.dt / 2) done(seen.state.time, off);
}

void TaskJudge::trace(const StepSeen& seen) {
  ToolTouch touch;
  const int tool = pressingTool(seen, m_places[0].object(), touch);
  if (tool >= 0) {
    m_record.tool = tool;
    m_record.forceMax = std::max(m_record.forceMax, touch.force);
    m_record.forceSum += touch.force * seen.dt;
    m_record.touchSeconds += seen.dt;
  }
  const bool pressed = tool >= 0 && touch.force >= m_task->forceMin;
  tooHard(pressed ? touch.force : 0, seen.dt);
  // The nearest place of the path that lies no farther on than the tolerance: no short cut counts.
  double begin = 0, nearest = std::numeric_limits<double>::infinity(), along = m_along;
  Vec3 a = m_places[0].point(seen.state.q);
  for (std::size_t i = 1; i < m_places.size(); ++i) {
    const Vec3 b = m_places[i].point(seen.state.q), edge = b - a;
    const double length = edge.norm();
    if (pressed && begin <= m_along + m_task->tolerance) {
      const double s = length > 0 ? std::clamp((touch.point_W - a).dot(edge) / (length * length), 0.0, 1.0) : 0;
      const double there = std::min(begin + s * length, m_along + m_task->tolerance), distance = (a + (there - begin) / std::max(length, 1e-12) * edge - touch.point_W).norm();
      if (distance < nearest) nearest = distance, along = there;
    }
    begin += length;
    a = b;
  }
  const bool on = pressed && nearest <= m_task->tolerance;
  // Letting go or leaving the path once begun, before its end, is an error.
  if (m_drawing && !on) ++m_record.errors;
  m_drawing = on;
  if (!on) return;
  m_along = std::max(m_along, along);
  m_record.progress = begin > 0 ? m_along / begin : 1;
  if (m_along >= begin - m_task->tolerance) done(seen.state.time, nearest);
}

void TaskJudge::follow(const StepSeen& seen) {
  Vec3 moved = Vec3::Zero();
  if (!m_task->keys.empty()) {
    const auto& keys = m_task->keys;
    const auto after = std::upper_bound(keys.begin(), keys.end(), m_followed, [](double t, const FollowKey& key) { return t < key.time; });
    if (after == keys.begin()) moved = after->displacement_W;
    else if (after == keys.end()) moved = keys.back().displacement_W;
    else {
      const FollowKey& from = *(after - 1);
      moved = from.displacement_W + (m_followed - from.time) / (after->time - from.time) * (after->displacement_W - from.displacement_W);
    }
  }
  const Vec3 place = m_places[0].point(seen.state.q) + moved;
  double nearest = std::numeric_limits<double>::infinity();
  int tool = -1;
  for (const int candidate : m_tools) {
    const double distance = (tip(seen, candidate) - place).norm();
    if (distance < nearest) nearest = distance, tool = candidate;
  }
  const bool near = nearest <= m_task->tolerance;
  if (!m_following && !near) return;  // it waits where it begins until a tip comes
  m_following = true;
  m_record.tool = tool;
  m_followed += seen.dt;
  if (near) m_near += seen.dt;
  const double length = m_task->keys.empty() ? m_task->hold : m_task->keys.back().time;
  m_record.progress = length > 0 ? std::min(1.0, m_followed / length) : 1;
  if (m_followed < length - seen.dt / 2) return;
  if (m_near >= m_task->share * m_followed) return done(seen.state.time, nearest);
  ++m_record.errors;  // too far for too long: from the beginning once more
  m_following = false;
  m_followed = m_near = m_record.progress = 0;
}

void TaskJudge::find(const StepSeen& seen) {
  ToolTouch touch;
  const int tool = pressingTool(seen, -1, touch);
  // What stands somewhere when the question is put, from the one before, is no answer to it.
  if (!std::exchange(m_asked, true) && tool >= 0 && touch.force >= m_task->forceMin) m_answered_W = tip(seen, tool);
  if (tool < 0 || touch.force < m_task->forceMin) {
    m_still_W.reset();
    m_held = m_record.progress = 0;
    if (m_answered_W && std::none_of(m_tips.begin(), m_tips.end(), [&](const CarriedPoint& each) { return (each.at(seen.model, seen.state.q) - *m_answered_W).norm() < kLeft; }))
      m_answered_W.reset();  // lifted off and away: the next press may be anywhere
    return;
  }
  m_record.forceMax = std::max(m_record.forceMax, touch.force);
  m_record.forceSum += touch.force * seen.dt;
  m_record.touchSeconds += seen.dt;
  const Vec3 here = tip(seen, tool);
  if (m_answered_W && (here - *m_answered_W).norm() < kLeft) return;
  m_answered_W.reset();
  if (!m_still_W || (here - *m_still_W).norm() > kStill) {
    m_still_W = here;
    m_held = 0;
  }
  m_held += seen.dt;
  m_record.progress = m_task->hold > 0 ? std::min(1.0, m_held / m_task->hold) : 0;
  if (m_held < m_task->hold - seen.dt / 2) return;
  // Beside the line of the push, since what is sought lies below the surface.
  const Vec3 push = -touch.force_W.normalized(), way = m_places[0].point(seen.state.q) - touch.point_W;
  const double distance = way.cross(push).norm();
  m_record.tool = tool;
  m_record.depth = way.dot(push);
  if (distance <= m_task->tolerance) return done(seen.state.time, distance);
  ++m_record.errors;
  m_record.distance = distance;
  m_answered_W = here;
  m_still_W.reset();
  m_held = m_record.progress = 0;
}

void TaskJudge::pass(const StepSeen& seen) {
  const Vec3 centre = m_places[m_ring].point(seen.state.q), normal = m_places[m_ring].normal(seen.state.q);
  std::vector<Vec3> now(m_tools.size());
  for (std::size_t i = 0; i < m_tools.size(); ++i) now[i] = m_tips[i].at(seen.model, seen.state.q);
  for (std::size_t i = 0; i < m_before_W.size(); ++i) {
    const double from = (m_before_W[i] - centre).dot(normal), to = (now[i] - centre).dot(normal);
    if (!(from < 0 && to >= 0)) continue;
    const double off = (m_before_W[i] + from / (from - to) * (now[i] - m_before_W[i]) - centre).norm();
    if (off > m_task->tolerance) {
      if (off <= kNearRing * m_task->tolerance) ++m_record.errors;
      continue;
    }
    m_record.tool = m_tools[i];
    ++m_ring;
    m_record.progress = static_cast<double>(m_ring) / static_cast<double>(m_places.size());
    if (m_ring == m_places.size()) done(seen.state.time, off);
    break;
  }
  m_before_W = std::move(now);
}

double taskScore(const Task& task, const TaskRecord& record) {
  if (record.outcome != TaskOutcome::Done) return 0;
  const double time = *record.ended - *record.opened;
  const double speed = task.timeGood > 0 && time > task.timeGood ? task.timeGood / time : 1;
  return std::max(0.0, 1 - task.errorCost * record.errors) * speed;
}

}  // namespace glenoid
