// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/RecordingFile.h"

#include <set>

#include "simcore/file/Schema.h"
#include "simcore/scene/SceneJson.h"

namespace glenoid {
namespace {

using namespace scene_json;

void setText(JsonValue& json, const char* key, const std::string& text) {
  if (!text.empty()) json.set(key, text);
}

JsonValue fromKey(const HandKey& key) {
  JsonValue json = JsonValue::object();
  json.set("time", key.time);
  const JsonValue pose = fromPose(key.hand);  // named: a loop over a temporary's members would dangle
  for (const auto& [name, value] : pose.members()) json.set(name, value);
  return json;
}

HandKey toKey(const JsonValue& json) {
  return {json["time"].number(), toPose(json)};
}

JsonValue fromTrack(const HandTrack& track) {
  JsonValue json = JsonValue::object();
  json.set("tool", track.tool);
  json.set("keys", listOf(track.keys, fromKey));
  return json;
}

HandTrack toTrack(const JsonValue& json) {
  return {json["tool"].text(), vectorOf(json["keys"], toKey)};
}

JsonValue fromMark(const RecordingMark& mark) {
  JsonValue json = JsonValue::object();
  json.set("name", mark.name);
  json.set("begin", mark.begin);
  json.set("end", mark.end);
  setText(json, "tool", mark.tool);
  setText(json, "part", mark.part);
  return json;
}

RecordingMark toMark(const JsonValue& json) {
  return {json["name"].text(), json["begin"].number(), json["end"].number(), json["tool"].text(),
          json["part"].text()};
}

JsonValue fromRecording(const Recording& recording) {
  JsonValue json = JsonValue::object();
  json.set("schemaVersion", schemaVersion(Schema::Recording));
  json.set("scenario", recording.scenario);
  json.set("dt", recording.dt);
  setText(json, "profile", recording.profile);
  json.set("seed", recording.seed);
  json.set("steps", recording.steps);
  setText(json, "jointHash", recording.jointHash);
  setText(json, "build", recording.build);
  setText(json, "isa", recording.isa);
  setText(json, "stateHash", recording.stateHash);
  json.set("marks", listOf(recording.marks, fromMark));
  json.set("tracks", listOf(recording.tracks, fromTrack));
  return json;
}

Recording toRecording(const JsonValue& json) {
  Recording recording;
  recording.scenario = json["scenario"].text();
  recording.dt = json["dt"].number(recording.dt);
  recording.profile = json["profile"].text();
  recording.seed = static_cast<unsigned>(json["seed"].integer(recording.seed));
  recording.steps = static_cast<long>(json["steps"].integer(recording.steps));
  recording.tracks = vectorOf(json["tracks"], toTrack);
  recording.marks = vectorOf(json["marks"], toMark);
  recording.jointHash = json["jointHash"].text();
  recording.build = json["build"].text();
  recording.isa = json["isa"].text();
  recording.stateHash = json["stateHash"].text();
  return recording;
}

std::string numberText(double value) {
  std::string text = toText(JsonValue(value));
  text.pop_back();
  return text;
}

Result<Done> checkTrack(const HandTrack& track, const std::string& pointer, const std::string& file) {
  for (std::size_t i = 0; i < track.keys.size(); ++i) {
    const std::string at = pointerTo(pointerTo(pointer, "keys"), i);
    if (i > 0 && !(track.keys[i].time > track.keys[i - 1].time))
      return Error{Fault::OutOfRange,
                   {file, at + "/time", track.tool, {}},
                   {numberText(track.keys[i].time), numberText(track.keys[i - 1].time), ""},
                   "times must ascend"};
    if (!isUnit(track.keys[i].hand.q_WB))
      return Error{Fault::OutOfRange,
                   {file, at + "/rotation", track.tool, {}},
                   {numberText(track.keys[i].hand.q_WB.norm()), "1", "1"},
                   "length of the quaternion"};
  }
  return Done{};
}

Result<Done> checkOwnValues(const Recording& recording, const std::string& file) {
  std::set<std::string> tools;
  for (std::size_t t = 0; t < recording.tracks.size(); ++t) {
    const std::string pointer = pointerTo("/tracks", t);
    if (!tools.insert(recording.tracks[t].tool).second)
      return Error{Fault::DuplicateId, {file, pointer + "/tool", {}, {}}, {recording.tracks[t].tool}, {}};
    if (const auto good = checkTrack(recording.tracks[t], pointer, file); !good) return good;
  }
  for (std::size_t i = 0; i < recording.marks.size(); ++i) {
    const RecordingMark& mark = recording.marks[i];
    if (mark.end < mark.begin)
      return Error{Fault::OutOfRange,
                   {file, pointerTo("/marks", i) + "/end", {}, {}},
                   {numberText(mark.end), numberText(mark.begin), ""},
                   "a mark ends before it begins"};
  }
  return Done{};
}

Result<Done> checkDocument(const Recording& recording, const JsonValue& json, const std::string& file) {
  if (const auto pointer = notFiniteIn(json))
    return Error{Fault::NotFinite, {file, *pointer, {}, {}}, {}, {}};
  if (const auto valid = validate(json, Schema::Recording, file); !valid) return valid;
  return checkOwnValues(recording, file);
}

}  // namespace

Result<Recording> loadRecording(const std::string& path) {
  const Result<JsonValue> json = readDocument(path, Schema::Recording);
  if (!json) return json.error();
  Recording recording = toRecording(*json);
  if (const auto good = checkOwnValues(recording, path); !good) return good.error();
  return recording;
}

Result<Done> saveRecording(const Recording& recording, const std::string& path) {
  const JsonValue json = fromRecording(recording);
  if (const auto good = checkDocument(recording, json, path); !good) return good;
  return writeJson(path, json);
}

Result<Done> checkRecording(const Recording& recording, const std::string& file) {
  return checkDocument(recording, fromRecording(recording), file);
}

}  // namespace glenoid
