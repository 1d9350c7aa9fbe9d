// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/device/HaplyWords.h"

#include <array>
#include <cstdio>
#include <limits>

#include "simcore/file/Json.h"

namespace glenoid {

namespace {

const Quat kTurn(std::sqrt(0.5), -std::sqrt(0.5), 0, 0);  // a quarter about X: (x, y, z) becomes (x, z, −y)
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double numberOf(const JsonValue& json, const char* key) {
  const JsonValue* found = json.find(key);
  return found && found->isNumber() ? found->number() : kNone;
}

Vec3 vectorOf(const JsonValue& json) { return {numberOf(json, "x"), numberOf(json, "y"), numberOf(json, "z")}; }

/// Both kinds of grip, each with names of buttons of its own.
void readGrip(const JsonValue& grip, HaplyWord& word) {
  static constexpr std::array kButtons{std::array{"a", "b", "c", "d"}, std::array{"button_0", "button_1", "button_2", "button_3"}};
  const JsonValue& state = grip["state"];
  if (const JsonValue* turn = state.find("orientation"); turn && turn->isObject())
    word.pose.q_WB = kTurn * Quat(numberOf(*turn, "w"), numberOf(*turn, "x"), numberOf(*turn, "y"), numberOf(*turn, "z")) * kTurn.conjugate();
  for (const auto& names : kButtons)
    for (std::size_t i = 0; i < names.size(); ++i)
      if (state["buttons"][names[i]].boolean()) word.buttons |= 1u << i;
}

}  // namespace

Vec3 haplyToDevice(const Vec3& v) { return {v.x(), v.z(), -v.y()}; }
Vec3 deviceToHaply(const Vec3& v) { return {v.x(), -v.z(), v.y()}; }

std::optional<HaplyWord> haplyWord(std::string_view text, const std::string& wanted) {
  const Result<JsonValue> json = parseJson(text, "Inverse Service", {32, 1 << 20});
  if (!json || !json->isObject()) return {};
  HaplyWord word;
  const JsonValue& list = (*json)["inverse3"];
  word.isState = list.isArray();
  for (const JsonValue& device : list.items()) {
    const std::string& id = device["device_id"].text();
    if (id.empty() || (!wanted.empty() && id != wanted)) continue;
    word.device = id;
    const JsonValue& state = device["state"];
    if (const JsonValue* at = state.find("cursor_position")) {
      word.hasPose = true;
      word.pose.p_WB = haplyToDevice(vectorOf(*at));
    }
    if (const JsonValue* force = state.find("current_cursor_force"); force && force->isObject()) word.force = haplyToDevice(vectorOf(*force));
    break;
  }
  for (const char* kind : {"verse_grip", "wireless_verse_grip"})
    if (!(*json)[kind].items().empty()) readGrip((*json)[kind][0], word);
  return word;
}

std::string haplyCommand(const std::string& device, const Vec3& force_D, HaplyDialect dialect, bool first) {
  const Vec3 force = deviceToHaply(force_D);
  JsonValue values = JsonValue::object(), set = JsonValue::object(), commands = JsonValue::object(), one = JsonValue::object(), list = JsonValue::array();
  for (const auto& [key, value] : {std::pair{"x", force.x()}, {"y", force.y()}, {"z", force.z()}}) values.set(key, std::isfinite(value) ? value : 0.0);
  set.set(dialect == HaplyDialect::Values ? "values" : "vector", std::move(values));
  commands.set("set_cursor_force", std::move(set));
  one.set("device_id", device);
  one.set("commands", std::move(commands));
  if (!device.empty()) list.append(std::move(one));
  JsonValue message = JsonValue::object();
  if (first) {
    JsonValue name = JsonValue::object(), profile = JsonValue::object(), configure = JsonValue::object();
    name.set("name", "glenoid");
    profile.set("profile", std::move(name));
    configure.set("configure", std::move(profile));
    message.set("session", std::move(configure));
  }
  message.set("inverse3", std::move(list));
  return toText(message);
}

}  // namespace glenoid
