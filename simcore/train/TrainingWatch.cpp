// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/train/TrainingWatch.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "simcore/train/Sight.h"

namespace glenoid {
namespace {

bool isOver(const TaskJudge& judge) {
  return judge.record().outcome == TaskOutcome::Done || judge.record().outcome == TaskOutcome::Missed;
}

}  // namespace

Result<TrainingWatch> TrainingWatch::make(const Model& model, bool raw) {
  TrainingWatch watch(model);
  watch.m_raw = raw;
  const Training& training = model.scenario.training;
  for (const Task& task : training.tasks) {
    Result<TaskJudge> judge = TaskJudge::make(model, task);
    if (!judge) return judge.error();
    watch.m_judges.push_back(std::move(*judge));
  }
  for (const ForceLimit& limit : training.limits) {
    Result<BoundPlace> place = BoundPlace::bind(model, {limit.part, {}, limit.region, {}, {}});
    if (!place) return place.error();
    watch.m_limits.push_back({std::move(*place)});
  }
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const SceneObject& object = model.objects[i];
    if (!object.tool || !model.scenario.tools[object.toolIndex].link.empty()) continue;
    ToolTrail trail;
    trail.object = static_cast<int>(i);
    trail.tip = CarriedPoint(model, trail.object, Vec3::Zero());
    trail.scope = model.scenario.tools[object.toolIndex].kind == ToolKind::Arthroscope;
    trail.from_W = trail.tip.at(model, model.start.q);
    trail.tips.push_back(trail.from_W);
    if (trail.scope) trail.axes.push_back(scopeView(model, model.start.q, trail.object).axis_W);
    watch.m_trails.push_back(std::move(trail));
  }
  const std::vector<Metric> metrics = watch.metrics();
  const auto known = [&](const auto& entries, const char* list) -> Result<Done> {
    for (std::size_t i = 0; i < entries.size(); ++i)
      if (std::none_of(metrics.begin(), metrics.end(), [&](const Metric& metric) { return metric.name == entries[i].metric; }))
        return Error{Fault::UnknownId, {"", pointerTo(std::string("/training/") + list, i) + "/metric", {}, {}}, {entries[i].metric, "metric"}, {}};
    return Done{};
  };
  if (const auto good = known(training.form, "form"); !good) return good.error();
  if (const auto good = known(training.references, "references"); !good) return good.error();
  if (const auto good = known(training.benchmarks, "benchmarks"); !good) return good.error();
  watch.m_early.assign(watch.m_judges.size(), 0);
  watch.m_pressed.assign(watch.m_judges.size(), 0);
  watch.m_begin = watch.m_end = model.start.time;
  watch.openTasks(model.start.time);
  if (raw) watch.addRow(model.start.time, nullptr);
  return watch;
}

/// In order, the first that is not over; else all.
void TrainingWatch::openTasks(double time) {
  // An answer is one to one question: of several places to find one is open at a time.
  bool asked = std::any_of(m_judges.begin(), m_judges.end(), [](const TaskJudge& judge) { return judge.task().kind == TaskKind::Find && judge.record().outcome == TaskOutcome::Open; });
  for (TaskJudge& judge : m_judges) {
    const bool find = judge.task().kind == TaskKind::Find;
    if (judge.record().outcome == TaskOutcome::Waiting && !(find && asked)) {
      judge.open(time);
      asked = asked || find;
    }
    if (m_model->scenario.training.ordered && !isOver(judge)) break;
  }
  m_finished = std::all_of(m_judges.begin(), m_judges.end(), isOver);
}

void TrainingWatch::add(const StepReport& step, const State& state) {
  if (m_finished || m_judges.empty()) return;
  const StepSeen seen{*m_model, step, state, m_model->scenario.dt};
  if (m_end == m_begin && state.time > m_begin + 1.5 * seen.dt) takeUp(seen);
  m_end = state.time;
  addTrails(seen);
  watchLimits(seen);
  if (m_model->scenario.training.ordered) watchOrder(seen);
  for (std::size_t t = 0; t < m_judges.size(); ++t) {
    if (m_judges[t].record().outcome != TaskOutcome::Open) continue;
    m_judges[t].look(seen);
    if (m_judges[t].record().outcome != TaskOutcome::Done) continue;
    m_doneOrder.push_back(static_cast<int>(t));
    for (ToolTrail& trail : m_trails)
      if (trail.object == m_judges[t].record().tool) {
        trail.straight += (trail.tips.back() - trail.from_W).norm();
        trail.from_W = trail.tips.back();
      }
  }
  if (m_raw) addRow(state.time, &seen);
  openTasks(state.time);
}

/// Of a run that is under way already, whose model or recording was changed: clocks and trails begin where it is now.
void TrainingWatch::takeUp(const StepSeen& seen) {
  m_begin = seen.state.time - seen.dt;
  for (TaskJudge& judge : m_judges)
    if (judge.record().outcome == TaskOutcome::Open) judge.open(m_begin);
  for (ToolTrail& trail : m_trails) {
    trail.from_W = trail.tip.at(*m_model, seen.state.q);
    trail.tips = {trail.from_W};
    if (trail.scope) trail.axes = {scopeView(*m_model, seen.state.q, trail.object).axis_W};
  }
}

/// What is pressed before its turn, once a task, unless the task whose turn it is has its place there too.
void TrainingWatch::watchOrder(const StepSeen& seen) {
  const bool now = std::any_of(m_judges.begin(), m_judges.end(),
                               [&](const TaskJudge& judge) { return judge.record().outcome == TaskOutcome::Open && judge.presses(seen); });
  for (std::size_t t = 0; t < m_judges.size(); ++t) {
    if (m_judges[t].record().outcome != TaskOutcome::Waiting || m_early[t]) continue;
    // A press that began for another task, which is done now, is none for this one.
    const bool pressed = m_judges[t].presses(seen), fresh = pressed && !m_pressed[t];
    m_pressed[t] = pressed;
    if (!fresh || now) continue;
    m_early[t] = 1;
    ++m_orderErrors;
  }
}

void TrainingWatch::watchLimits(const StepSeen& seen) {
  for (std::size_t l = 0; l < m_limits.size(); ++l) {
    LimitWatch& watch = m_limits[l];
    watch.force = 0;
    for (std::size_t i = 0; i < seen.model.objects.size(); ++i) {
      if (!seen.model.objects[i].tool) continue;
      const ToolTouch touch = toolTouch(seen.model, seen.step, static_cast<int>(i), watch.place.object(),
                                        [&](const Vec3& point_W) { return watch.place.distanceTo(point_W, seen.state.q) <= kOnRegion; });
      watch.force = std::max(watch.force, touch.force);
    }
    watch.forceMax = std::max(watch.forceMax, watch.force);
    if (watch.force > kTouch) watch.touchSeconds += seen.dt;
    if (watch.force <= seen.model.scenario.training.limits[l].forceMax) {
      watch.below += seen.dt;
      continue;
    }
    watch.tooHardSeconds += seen.dt;
    if (watch.below >= TaskJudge::kBelow - seen.dt / 2) ++watch.tooHard;
    watch.below = 0;
  }
}

void TrainingWatch::addTrails(const StepSeen& seen) {
  for (ToolTrail& trail : m_trails) {
    trail.tips.push_back(trail.tip.at(seen.model, seen.state.q));
    if (trail.scope) trail.axes.push_back(scopeView(seen.model, seen.state.q, trail.object).axis_W);
    const double force = toolTouch(seen.model, seen.step, trail.object, -1).force;
    trail.forceMax = std::max(trail.forceMax, force);
    if (force > kTouch) trail.touchSeconds += seen.dt, trail.forceSum += force * seen.dt;
  }
}

std::vector<Metric> TrainingWatch::metrics() const {
  const double dt = m_model->scenario.dt;
  std::vector<Metric> list;
  double weights = 0, scores = 0, lookTime = 0, seenTime = 0, distance = 0, depth = 0;
  int errors = m_orderErrors, inversions = 0, found = 0;
  for (const TaskJudge& judge : m_judges) {
    const TaskRecord& record = judge.record();
    weights += judge.task().weight;
    scores += judge.task().weight * taskScore(judge.task(), record);
    errors += record.errors;
    if (judge.task().kind == TaskKind::Look && record.opened) {
      lookTime += record.ended.value_or(m_end) - *record.opened;
      seenTime += record.seenSeconds;
    }
    if (judge.task().kind == TaskKind::Find && record.outcome == TaskOutcome::Done) {
      distance += *record.distance;
      depth += record.depth.value_or(0);
      ++found;
    }
  }
  for (const LimitWatch& limit : m_limits) errors += limit.tooHard;
  for (std::size_t a = 0; a < m_doneOrder.size(); ++a)
    for (std::size_t b = a + 1; b < m_doneOrder.size(); ++b) inversions += m_doneOrder[a] > m_doneOrder[b];
  const auto mean = [](double sum, double over) { return over > 0 ? std::optional(sum / over) : std::nullopt; };
  list.push_back({"tasks", mean(scores, weights)});
  list.push_back({"errors", static_cast<double>(errors)});
  list.push_back({"order", static_cast<double>(inversions)});
  list.push_back({"time", m_end - m_begin});
  for (const ToolTrail& trail : m_trails) {
    const std::string tool = m_model->objects[trail.object].id + ".";
    const double path = pathLength(trail.tips);
    list.push_back({tool + "path", path});
    list.push_back({tool + "economy", path > 0 && trail.straight > 0 ? std::optional(trail.straight / path) : std::nullopt});
    list.push_back({tool + "jerk", logJerk(trail.tips, dt)});
    list.push_back({tool + "speed", mean(path, m_end - m_begin)});
    list.push_back({tool + "forceMax", trail.forceMax});
    list.push_back({tool + "forceMean", mean(trail.forceSum, trail.touchSeconds)});
    list.push_back({tool + "touchSeconds", trail.touchSeconds});
    if (!trail.scope) continue;
    double turned = 0;
    for (std::size_t i = 1; i < trail.axes.size(); ++i) turned += (trail.axes[i] - trail.axes[i - 1]).squaredNorm();
    const double steps = static_cast<double>(trail.axes.size()) - 1;
    list.push_back({tool + "steadiness", steps > 0 ? std::optional(std::sqrt(turned / steps) / dt) : std::nullopt});
  }
  for (std::size_t l = 0; l < m_limits.size(); ++l) {
    const LimitWatch& limit = m_limits[l];
    const std::string id = m_model->scenario.training.limits[l].id + ".";
    list.push_back({id + "forceMax", limit.forceMax});
    list.push_back({id + "touchSeconds", limit.touchSeconds});
    list.push_back({id + "tooHardSeconds", limit.tooHardSeconds});
    list.push_back({id + "tooHard", static_cast<double>(limit.tooHard)});
  }
  const auto has = [&](TaskKind kind) {
    return std::any_of(m_judges.begin(), m_judges.end(), [&](const TaskJudge& judge) { return judge.task().kind == kind; });
  };
  if (has(TaskKind::Look)) list.push_back({"inView", mean(seenTime, lookTime)});
  if (has(TaskKind::Find)) list.push_back({"distance", mean(distance, found)}), list.push_back({"depth", mean(depth, found)});
  return list;
}

TrainingReport TrainingWatch::tasksSoFar() const {
  TrainingReport report;
  for (const TaskJudge& judge : m_judges) {
    const int tool = judge.record().tool;
    report.tasks.push_back({judge.task().id, judge.task().name, judge.task().kind, judge.record(),
                            tool < 0 ? std::string() : m_model->objects[tool].id, taskScore(judge.task(), judge.record())});
  }
  report.finished = m_finished;
  return report;
}

TrainingReport TrainingWatch::report() const {
  TrainingReport report = tasksSoFar();
  report.metrics = metrics();
  scoreTraining(m_model->scenario.training, report);
  return report;
}

void TrainingWatch::addRow(double time, const StepSeen* seen) {
  const std::size_t before = m_rows.size();
  const auto add = [&](const Vec3& x) { m_rows.insert(m_rows.end(), {x.x(), x.y(), x.z()}); };
  m_rows.push_back(time);
  for (const ToolTrail& trail : m_trails) {
    add(trail.tips.back());
    if (trail.scope) add(trail.axes.back());
    add(seen ? toolTouch(seen->model, seen->step, trail.object, -1).force_W : Vec3::Zero());
  }
  for (const LimitWatch& limit : m_limits) m_rows.push_back(limit.force);
  for (const TaskJudge& judge : m_judges)
    m_rows.insert(m_rows.end(), {static_cast<double>(judge.record().outcome), static_cast<double>(judge.record().errors), judge.record().seenSeconds});
  m_columns = static_cast<int>(m_rows.size() - before);
}

std::string TrainingWatch::csv() const {
  std::string text = "time";
  const auto head = [&](const std::string& id, std::initializer_list<const char*> columns) {
    for (const char* column : columns) text += "," + id + "." + column;
  };
  for (const ToolTrail& trail : m_trails) {
    const std::string& id = m_model->objects[trail.object].id;
    head(id, {"x", "y", "z"});
    if (trail.scope) head(id, {"ax", "ay", "az"});
    head(id, {"fx", "fy", "fz"});
  }
  for (const ForceLimit& limit : m_model->scenario.training.limits) head(limit.id, {"force"});
  for (const TaskJudge& judge : m_judges) head(judge.task().id, {"outcome", "errors", "seen"});
  text += "\n";
  char number[40];
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    text.append(number, std::to_chars(number, number + sizeof number, m_rows[i]).ptr);
    text += (i + 1) % static_cast<std::size_t>(m_columns) == 0 ? '\n' : ',';
  }
  return text;
}

}  // namespace glenoid
