// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/training/TrainingCheck.h"

#include <algorithm>
#include <set>

#include "simcore/file/JsonValue.h"

namespace glenoid {
namespace {

Error unusable(const std::string& file, const std::string& pointer, const std::string& id, std::string what) {
  return {Fault::Unusable, {file, pointer, id, {}}, {std::move(what)}, {}};
}

Result<Done> checkPlace(const TaskPlace& place, TaskKind kind, const std::string& task, const std::string& file, const std::string& pointer) {
  const int named = !place.landmark.empty() + !place.region.empty() + place.point_W.has_value();
  if (named > 1) return unusable(file, pointer, task, "a place that is more than one of landmark, region and point");
  if (place.part.empty() && !place.point_W) return unusable(file, pointer, task, "a place without a part that is no point of the room");
  const bool isPoint = !place.landmark.empty() || place.point_W;
  const bool wantsPoint = kind != TaskKind::Touch && kind != TaskKind::Press;  // the middle of a part lies hidden in it
  if (wantsPoint && !isPoint) return unusable(file, pointer, task, "a place that is no landmark or point, which this kind of task needs");
  if (place.part.empty() && kind != TaskKind::Look && kind != TaskKind::Follow && kind != TaskKind::Pass)
    return unusable(file, pointer, task, "a place in the room, where nothing can be pressed");
  if (kind == TaskKind::Pass && !(place.normal_W && place.normal_W->norm() > 1e-9))
    return unusable(file, pointer, task, "a ring without a normal, along which the tip goes through it");
  if (kind != TaskKind::Pass && place.normal_W) return unusable(file, pointer, task, "a normal, which only a ring has");
  return Done{};
}

Result<Done> checkTask(const Scenario& scenario, const Task& task, const std::string& file, const std::string& pointer) {
  const std::size_t most = task.kind == TaskKind::Trace || task.kind == TaskKind::Pass ? 1000 : 1, least = task.kind == TaskKind::Trace ? 2 : 1;
  if (task.places.size() < least || task.places.size() > most)
    return unusable(file, pointer + "/places", task.id,
                    std::to_string(task.places.size()) + " places, where this kind of task has " + (most == 1 ? "one" : least == 2 ? "two or more" : "one or more"));
  for (std::size_t i = 0; i < task.places.size(); ++i)
    if (const auto good = checkPlace(task.places[i], task.kind, task.id, file, pointerTo(pointer + "/places", i)); !good) return good;
  if (task.kind == TaskKind::Trace)
    for (const TaskPlace& place : task.places)
      if (place.part != task.places[0].part) return unusable(file, pointer + "/places", task.id, "a path to trace over more than one part");
  if (task.kind == TaskKind::Press && !task.forceMax) return unusable(file, pointer, task.id, "a press without forceMax, so without a band");
  if (task.forceMax && !(*task.forceMax > task.forceMin)) return unusable(file, pointer + "/forceMax", task.id, "a forceMax that is not above forceMin");
  if (!task.keys.empty() && task.kind != TaskKind::Follow) return unusable(file, pointer + "/keys", task.id, "keys, which only a task to follow has");
  for (std::size_t k = 1; k < task.keys.size(); ++k)
    if (!(task.keys[k].time > task.keys[k - 1].time)) return unusable(file, pointerTo(pointer + "/keys", k), task.id, "keys that do not ascend in time");
  if (task.tool.empty()) {
    const auto fits = [&](const Tool& tool) { return tool.link.empty() && (task.kind != TaskKind::Look || tool.kind == ToolKind::Arthroscope); };
    if (std::none_of(scenario.tools.begin(), scenario.tools.end(), fits))
      return unusable(file, pointer, task.id, task.kind == TaskKind::Look ? "a task to look, and no arthroscope among the tools" : "a task, and no tool that a hand holds");
    return Done{};
  }
  const int tool = findTool(scenario, task.tool);
  if (tool < 0) return Error{Fault::UnknownId, {file, pointer + "/tool", task.id, {}}, {task.tool, "tool"}, {}};
  return Done{};
}

template <class T>
Result<Done> checkIds(const std::vector<T>& things, const char* list, const std::string& file) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < things.size(); ++i)
    if (!seen.insert(things[i].id).second)
      return Error{Fault::DuplicateId, {file, pointerTo(std::string("/training/") + list, i) + "/id", {}, {}}, {things[i].id}, {}};
  return Done{};
}

Result<Done> checkPart(const Joint& joint, const std::string& part, const Place& place, const std::string& pointer, const std::string& owner) {
  if (findPart(joint, part) >= 0) return Done{};
  return Error{Fault::UnknownId, {place.file, place.pointer + pointer + "/part", owner, {}}, {part, "part"}, {}};
}

bool hasPlace(const Joint& joint, const std::string& part, const std::string& region, const std::string& landmark) {
  if (part.empty()) return true;
  const int index = findPart(joint, part);
  if (index < 0) return false;
  const auto& landmarks = joint.parts[index].landmarks;
  if (!landmark.empty() && std::none_of(landmarks.begin(), landmarks.end(), [&](const Landmark& entry) { return entry.id == landmark; })) return false;
  return region.empty() || findRegion(joint.parts[index], region);
}

}  // namespace

void keepTrainingTo(const Joint& joint, Training& training) {
  std::erase_if(training.tasks, [&](Task& task) {
    std::erase_if(task.places, [&](const TaskPlace& place) { return !hasPlace(joint, place.part, place.region, place.landmark); });
    return task.places.size() < (task.kind == TaskKind::Trace ? 2u : 1u);
  });
  std::erase_if(training.limits, [&](const ForceLimit& limit) { return !hasPlace(joint, limit.part, limit.region, {}); });
}

Result<Done> checkTraining(const Scenario& scenario, const std::string& file) {
  const Training& training = scenario.training;
  if (const auto ids = checkIds(training.tasks, "tasks", file); !ids) return ids;
  if (const auto ids = checkIds(training.limits, "limits", file); !ids) return ids;
  for (std::size_t i = 0; i < training.limits.size(); ++i)  // metrics are named by both
    if (findTool(scenario, training.limits[i].id) >= 0)
      return Error{Fault::DuplicateId, {file, pointerTo("/training/limits", i) + "/id", {}, {}}, {training.limits[i].id}, {}};
  for (std::size_t i = 0; i < training.tasks.size(); ++i)
    if (const auto good = checkTask(scenario, training.tasks[i], file, pointerTo("/training/tasks", i)); !good) return good;
  for (std::size_t i = 0; i < training.form.size(); ++i)
    if (training.form[i].best == training.form[i].worst)
      return unusable(file, pointerTo("/training/form", i), training.form[i].metric, "a row of the form whose best and worst are the same");
  return Done{};
}

Result<Done> checkTraining(const Scenario& scenario, const Joint& joint, const Place& place) {
  const Training& training = scenario.training;
  for (std::size_t t = 0; t < training.tasks.size(); ++t)
    for (std::size_t i = 0; i < training.tasks[t].places.size(); ++i) {
      const TaskPlace& target = training.tasks[t].places[i];
      const std::string pointer = pointerTo(pointerTo("/training/tasks", t) + "/places", i);
      const std::string& task = training.tasks[t].id;
      if (target.part.empty()) continue;
      if (const auto known = checkPart(joint, target.part, place, pointer, task); !known) return known;
      const Part& part = joint.parts[findPart(joint, target.part)];
      if (!target.region.empty() && !findRegion(part, target.region))
        return Error{Fault::UnknownId, {place.file, place.pointer + pointer + "/region", task, {}}, {target.region, "region"}, {}};
      const auto named = [&](const Landmark& landmark) { return landmark.id == target.landmark; };
      if (!target.landmark.empty() && std::none_of(part.landmarks.begin(), part.landmarks.end(), named))
        return Error{Fault::UnknownId, {place.file, place.pointer + pointer + "/landmark", task, {}}, {target.landmark, "landmark"}, {}};
    }
  for (std::size_t i = 0; i < training.limits.size(); ++i) {
    const ForceLimit& limit = training.limits[i];
    const std::string pointer = pointerTo("/training/limits", i);
    if (const auto known = checkPart(joint, limit.part, place, pointer, limit.id); !known) return known;
    if (!limit.region.empty() && !findRegion(joint.parts[findPart(joint, limit.part)], limit.region))
      return Error{Fault::UnknownId, {place.file, place.pointer + pointer + "/region", limit.id, {}}, {limit.region, "region"}, {}};
  }
  return Done{};
}

}  // namespace glenoid
