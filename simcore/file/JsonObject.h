// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <initializer_list>
#include <utility>
#include <vector>

#include "simcore/file/Json.h"

namespace glenoid {

/// A JSON object from its members, in this order.
inline JsonValue jsonObject(std::initializer_list<std::pair<const char*, JsonValue>> members) {
  JsonValue json = JsonValue::object();
  for (const auto& [key, value] : members) json.set(key, value);
  return json;
}

inline JsonValue jsonArray(const std::vector<int>& numbers) {
  JsonValue json = JsonValue::array();
  for (const int number : numbers) json.append(number);
  return json;
}

}  // namespace glenoid
