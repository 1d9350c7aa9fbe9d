// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/accuracy/AccuracyShards.h"

#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

Error unusable(const std::string& what) { return {Fault::Unusable, {}, {what}, "shards of a study"}; }

JsonValue toJson(const Timing& timing) {
  JsonValue json = JsonValue::array();
  for (const double value : {timing.median, timing.p95, timing.p99, timing.p999, timing.max}) json.append(value);
  return json;
}

Timing timingFrom(const JsonValue& json) { return {json[0].number(), json[1].number(), json[2].number(), json[3].number(), json[4].number()}; }

JsonValue toJson(const std::optional<AccuracyErrors>& errors) {
  if (!errors) return {};
  JsonValue json = JsonValue::array();
  for (const AccuracyError& error : errors->by) {
    JsonValue one = JsonValue::array();
    // A number that is not finite has no place in JSON; null comes back as one.
    one.append(std::isfinite(error.value) ? JsonValue(error.value) : JsonValue());
    one.append(std::isfinite(error.most) ? JsonValue(error.most) : JsonValue());
    one.append(error.where);
    json.append(std::move(one));
  }
  return json;
}

std::optional<AccuracyErrors> errorsFrom(const JsonValue& json) {
  if (json.isNull()) return std::nullopt;
  AccuracyErrors errors;
  for (std::size_t q = 0; q < errors.by.size(); ++q) errors.by[q] = {json[q][0].number(NAN), json[q][1].number(NAN), json[q][2].text()};
  return errors;
}

JsonValue toJson(const Error& error) {
  JsonValue json = JsonValue::object(), arguments = JsonValue::array();
  for (const std::string& argument : error.arguments) arguments.append(argument);
  json.set("fault", faultName(error.fault));
  json.set("part", error.place.part);
  json.set("arguments", std::move(arguments));
  json.set("detail", error.detail);
  return json;
}

Error errorFrom(const JsonValue& json) {
  Error error;
  for (int fault = 0; fault < kFaultCount; ++fault)
    if (json["fault"].text() == faultName(static_cast<Fault>(fault))) error.fault = static_cast<Fault>(fault);
  error.place.part = json["part"].text();
  for (const JsonValue& argument : json["arguments"].items()) error.arguments.push_back(argument.text());
  error.detail = json["detail"].text();
  return error;
}

JsonValue toJson(const AccuracyRow& row) {
  JsonValue json = JsonValue::object();
  json.set("index", static_cast<long>(row.index));
  json.set("setting", row.setting.id);
  json.set("machine", row.machine);
  json.set("failure", row.failure.reason);
  if (row.failure.reason == "not-built") json.set("error", toJson(row.failure.error));
  json.set("failedSteps", row.failure.count);
  json.set("ofSteps", row.failure.of);
  json.set("ownCells", row.ownCells);
  json.set("windows", row.windows);
  json.set("finerCellsErrors", toJson(row.errors[0]));
  json.set("ownCellsErrors", toJson(row.errors[1]));
  json.set("tetrahedra", row.tetrahedra);
  json.set("cappedSteps", row.cappedSteps);
  json.set("unsolvedIslands", row.unsolvedIslands);
  json.set("steps", row.steps);
  json.set("contacts", row.contacts);
  json.set("deepest", row.deepest);
  json.set("deepestWhere", row.deepestWhere);
  json.set("cpu", toJson(row.cpu));
  json.set("wall", toJson(row.wall));
  json.set("work", toJson(row.work));
  json.set("timed", row.timed);
  return json;
}

AccuracyRow rowFrom(const JsonValue& json, const AccuracySetting& setting) {
  AccuracyRow row;
  row.setting = setting;
  row.index = static_cast<std::size_t>(json["index"].integer());
  row.machine = json["machine"].text();
  row.failure = {json["failure"].text(), {}, json["failedSteps"].integer(), json["ofSteps"].integer()};
  if (const JsonValue* error = json.find("error")) row.failure.error = errorFrom(*error);
  row.ownCells = json["ownCells"].boolean();
  row.windows = static_cast<int>(json["windows"].integer());
  row.errors = {errorsFrom(json["finerCellsErrors"]), errorsFrom(json["ownCellsErrors"])};
  row.tetrahedra = json["tetrahedra"].integer();
  row.cappedSteps = json["cappedSteps"].integer();
  row.unsolvedIslands = json["unsolvedIslands"].integer();
  row.steps = json["steps"].integer();
  row.contacts = json["contacts"].number();
  row.deepest = json["deepest"].number();
  row.deepestWhere = json["deepestWhere"].text();
  row.cpu = timingFrom(json["cpu"]);
  row.wall = timingFrom(json["wall"]);
  row.work = timingFrom(json["work"]);
  row.timed = json["timed"].integer();
  return row;
}

JsonValue toJson(const AccuracyReference& reference) {
  JsonValue json = JsonValue::object();
  if (reference.missing) json.set("missing", toJson(*reference.missing));
  for (const auto& [key, setting] : {std::pair("finest", &reference.finest), std::pair("coarser", &reference.coarser)}) {
    JsonValue one = JsonValue::object();
    one.set("setting", setting->id);
    one.set("cells", setting->cells);
    one.set("dt", setting->dt);
    json.set(key, std::move(one));
  }
  json.set("tetrahedra", reference.tetrahedra);
  json.set("floor", toJson(std::optional(reference.floor)));
  json.set("check", toJson(reference.check));
  return json;
}

AccuracyReference referenceFrom(const JsonValue& json, const AccuracySetting& scene) {
  AccuracyReference reference;
  if (const JsonValue* missing = json.find("missing")) reference.missing = errorFrom(*missing);
  for (const auto& [key, setting] : {std::pair("finest", &reference.finest), std::pair("coarser", &reference.coarser)}) {
    *setting = scene;
    setting->family = "reference";
    setting->profile = Profile::Direct;
    setting->id = json[key]["setting"].text();
    setting->cells = json[key]["cells"].number();
    setting->dt = json[key]["dt"].number();
  }
  reference.tetrahedra = json["tetrahedra"].integer();
  reference.floor = errorsFrom(json["floor"]).value_or(AccuracyErrors());
  reference.check = errorsFrom(json["check"]);
  return reference;
}

/// What all shards must have alike, bit for bit.
JsonValue commonOf(const AccuracyResult& result) {
  JsonValue json = JsonValue::object(), windows = JsonValue::array();
  json.set("finerCells", toJson(result.references[0]));
  json.set("ownCells", toJson(result.references[1]));
  for (const AccuracyWindow& window : result.windows) {
    JsonValue one = JsonValue::object();
    one.set("time", window.time);
    one.set("loaded", window.loaded);
    one.set("mark", window.mark);
    one.set("speed", window.speed);
    one.set("force", window.force);
    one.set("stateHash", window.stateHash);
    windows.append(std::move(one));
  }
  json.set("windows", std::move(windows));
  json.set("seconds", result.wishes.seconds);
  json.set("grid", result.wishes.grid);
  json.set("friction", result.friction);
  json.set("hands", result.hands);
  json.set("repeats", result.repeats);
  return json;
}

}  // namespace

JsonValue toJson(const AccuracyResult& result) {
  JsonValue json = commonOf(result), rows = JsonValue::array();
  for (const AccuracyRow& row : result.rows) rows.append(toJson(row));
  json.set("rows", std::move(rows));
  return json;
}

Result<AccuracyResult> accuracyResult(const JsonValue& json, const AccuracySetting& scene, const std::vector<AccuracySetting>& settings) {
  if (!json["rows"].isArray() || !json["windows"].isArray()) return unusable("a file that is no shard of a study");
  AccuracyResult result;
  result.scene = scene;
  result.references = {referenceFrom(json["finerCells"], scene), referenceFrom(json["ownCells"], scene)};
  for (const JsonValue& one : json["windows"].items()) {
    AccuracyWindow& window = result.windows.emplace_back();
    window.time = one["time"].number();
    window.loaded = one["loaded"].boolean();
    window.mark = one["mark"].text();
    window.speed = one["speed"].number();
    window.force = one["force"].number();
    window.stateHash = one["stateHash"].text();
  }
  result.wishes.count = static_cast<int>(result.windows.size());
  result.wishes.seconds = json["seconds"].number();
  result.wishes.grid = json["grid"].number();
  result.friction = json["friction"].boolean();
  result.hands = json["hands"].boolean();
  result.repeats = static_cast<int>(json["repeats"].integer());
  for (const JsonValue& one : json["rows"].items()) {
    const auto setting = std::find_if(settings.begin(), settings.end(), [&](const AccuracySetting& s) { return s.id == one["setting"].text(); });
    if (setting == settings.end()) return unusable("a shard with the setting “" + one["setting"].text() + "”, which this study of the scene does not have");
    result.rows.push_back(rowFrom(one, *setting));
  }
  return result;
}

bool sameGround(const AccuracyResult& a, const AccuracyResult& b) {
  return commonOf(a) == commonOf(b);
}

Result<AccuracyResult> mergedShards(std::span<const AccuracyResult> shards, std::size_t settings) {
  if (shards.empty()) return unusable("a study without shards");
  AccuracyResult merged = shards.front();
  merged.rows.clear();
  for (const AccuracyResult& shard : shards) {
    if (!sameGround(shard, shards.front()))
      return unusable(
          "shards whose windows or references differ: measure all with one build, on one instruction set, "
          "with the same scene and options");
    merged.rows.insert(merged.rows.end(), shard.rows.begin(), shard.rows.end());
  }
  std::sort(merged.rows.begin(), merged.rows.end(), [](const AccuracyRow& a, const AccuracyRow& b) { return a.index < b.index; });
  for (std::size_t k = 0; k < std::max(settings, merged.rows.size()); ++k)
    if (k >= merged.rows.size() || merged.rows[k].index != k)
      return unusable("a study of " + std::to_string(settings) + " settings of which " + std::to_string(merged.rows.size()) + " are there, or some twice");
  return merged;
}

}  // namespace glenoid
