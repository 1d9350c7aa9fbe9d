// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/training/TrainingJson.h"

#include "simcore/scene/SceneJson.h"
#include "simcore/scene/SceneWords.h"
#include "simcore/scene/training/TrainingWords.h"

namespace glenoid::scene_json {
namespace {

using namespace scene_words;

void setText(JsonValue& json, const char* key, const std::string& text) {
  if (!text.empty()) json.set(key, text);
}

/// Only what differs from the default, so that files hold what somebody wrote.
template <class T>
void setUnless(JsonValue& json, const char* key, const T& value, const T& usual) {
  if (value != usual) json.set(key, value);
}

template <class T, class From>
void setList(JsonValue& json, const char* key, const std::vector<T>& values, From&& from) {
  if (!values.empty()) json.set(key, listOf(values, from));
}

JsonValue fromPlace(const TaskPlace& place) {
  JsonValue json = JsonValue::object();
  setText(json, "part", place.part);
  setText(json, "landmark", place.landmark);
  setText(json, "region", place.region);
  if (place.point_W) json.set("point", fromVec3(*place.point_W));
  if (place.normal_W) json.set("normal", fromVec3(*place.normal_W));
  return json;
}

TaskPlace toPlace(const JsonValue& json) {
  TaskPlace place{json["part"].text(), json["landmark"].text(), json["region"].text(), {}, {}};
  if (json.find("point")) place.point_W = toVec3(json["point"]);
  if (json.find("normal")) place.normal_W = toVec3(json["normal"]);
  return place;
}

JsonValue fromKey(const FollowKey& key) {
  JsonValue json = JsonValue::object();
  json.set("time", key.time);
  json.set("displacement", fromVec3(key.displacement_W));
  return json;
}

FollowKey toKey(const JsonValue& json) { return {json["time"].number(), toVec3(json["displacement"])}; }

/// Every number of a task with its word.
struct TaskNumber {
  const char* word;
  double Task::*number;
};
constexpr TaskNumber kNumbers[] = {{"tolerance", &Task::tolerance}, {"hold", &Task::hold},         {"forceMin", &Task::forceMin},
                                   {"angle", &Task::angle},         {"range", &Task::range},       {"share", &Task::share},
                                   {"timeGood", &Task::timeGood},   {"timeMax", &Task::timeMax},   {"errorCost", &Task::errorCost},
                                   {"weight", &Task::weight}};

JsonValue fromTask(const Task& task) {
  const Task usual;
  JsonValue json = JsonValue::object();
  json.set("id", task.id);
  setText(json, "name", task.name);
  setText(json, "text", task.text);
  setText(json, "hint", task.hint);
  json.set("kind", wordOf(kTaskKinds, task.kind));
  setText(json, "tool", task.tool);
  json.set("places", listOf(task.places, fromPlace));
  setList(json, "keys", task.keys, fromKey);
  for (const TaskNumber& entry : kNumbers) setUnless(json, entry.word, task.*entry.number, usual.*entry.number);
  if (task.forceMax) json.set("forceMax", *task.forceMax);
  setUnless(json, "hidden", task.hidden, usual.hidden);
  return json;
}

Task toTask(const JsonValue& json) {
  Task task;
  task.id = json["id"].text();
  task.name = json["name"].text();
  task.text = json["text"].text();
  task.hint = json["hint"].text();
  task.kind = valueOf(kTaskKinds, json["kind"].text(), task.kind);
  task.tool = json["tool"].text();
  task.places = vectorOf(json["places"], toPlace);
  task.keys = vectorOf(json["keys"], toKey);
  for (const TaskNumber& entry : kNumbers) task.*entry.number = json[entry.word].number(task.*entry.number);
  if (json.find("forceMax")) task.forceMax = json["forceMax"].number();
  task.hidden = json["hidden"].boolean(task.hidden);
  return task;
}

JsonValue fromLimit(const ForceLimit& limit) {
  JsonValue json = JsonValue::object();
  json.set("id", limit.id);
  setText(json, "name", limit.name);
  json.set("part", limit.part);
  setText(json, "region", limit.region);
  json.set("forceMax", limit.forceMax);
  return json;
}

ForceLimit toLimit(const JsonValue& json) {
  return {json["id"].text(), json["name"].text(), json["part"].text(), json["region"].text(), json["forceMax"].number(1)};
}

JsonValue fromRow(const FormRow& row) {
  JsonValue json = JsonValue::object();
  json.set("metric", row.metric);
  json.set("points", row.points);
  json.set("best", row.best);
  json.set("worst", row.worst);
  return json;
}

FormRow toRow(const JsonValue& json) {
  return {json["metric"].text(), json["points"].number(), json["best"].number(), json["worst"].number(1)};
}

JsonValue fromReference(const ReferenceFigure& figure) {
  JsonValue json = JsonValue::object();
  json.set("metric", figure.metric);
  json.set("mean", figure.mean);
  json.set("sd", figure.sd);
  json.set("count", figure.count);
  setText(json, "source", figure.source);
  return json;
}

ReferenceFigure toReference(const JsonValue& json) {
  return {json["metric"].text(), json["mean"].number(), json["sd"].number(1), static_cast<int>(json["count"].integer()), json["source"].text()};
}

JsonValue fromBenchmark(const Benchmark& benchmark) {
  JsonValue json = JsonValue::object();
  json.set("metric", benchmark.metric);
  json.set("limit", benchmark.limit);
  setText(json, "name", benchmark.name);
  setText(json, "source", benchmark.source);
  return json;
}

Benchmark toBenchmark(const JsonValue& json) {
  return {json["metric"].text(), json["limit"].number(), json["name"].text(), json["source"].text()};
}

}  // namespace

JsonValue fromTraining(const Training& training) {
  const Training usual;
  JsonValue json = JsonValue::object();
  setText(json, "text", training.text);
  setUnless(json, "ordered", training.ordered, usual.ordered);
  json.set("tasks", listOf(training.tasks, fromTask));
  setList(json, "limits", training.limits, fromLimit);
  setList(json, "form", training.form, fromRow);
  setUnless(json, "passScore", training.passScore, usual.passScore);
  setList(json, "references", training.references, fromReference);
  setList(json, "benchmarks", training.benchmarks, fromBenchmark);
  return json;
}

Training toTraining(const JsonValue& json) {
  Training training;
  training.text = json["text"].text();
  training.ordered = json["ordered"].boolean(training.ordered);
  training.tasks = vectorOf(json["tasks"], toTask);
  training.limits = vectorOf(json["limits"], toLimit);
  training.form = vectorOf(json["form"], toRow);
  training.passScore = json["passScore"].number(training.passScore);
  training.references = vectorOf(json["references"], toReference);
  training.benchmarks = vectorOf(json["benchmarks"], toBenchmark);
  return training;
}

}  // namespace glenoid::scene_json
