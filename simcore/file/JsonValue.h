// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace glenoid {

/// A JSON document as a plain value; members keep the order of the file. Reading is forgiving: what is absent or
/// of another kind answers the given default, because documents are checked against their schema first.
class JsonValue {
 public:
  using Items = std::vector<JsonValue>;
  using Members = std::vector<std::pair<std::string, JsonValue>>;

  JsonValue() = default;  ///< null
  JsonValue(bool value) : m_content(value) {}
  JsonValue(int value) : m_content(static_cast<std::int64_t>(value)) {}
  JsonValue(unsigned value) : m_content(static_cast<std::int64_t>(value)) {}
  JsonValue(long value) : m_content(static_cast<std::int64_t>(value)) {}
  JsonValue(long long value) : m_content(static_cast<std::int64_t>(value)) {}
  JsonValue(double value) : m_content(value) {}
  JsonValue(const char* value) : m_content(std::string(value)) {}
  JsonValue(std::string value) : m_content(std::move(value)) {}
  static JsonValue array() { return JsonValue(Items{}); }
  static JsonValue object() { return JsonValue(Members{}); }

  bool isNull() const { return std::holds_alternative<std::monostate>(m_content); }
  bool isBoolean() const { return std::holds_alternative<bool>(m_content); }
  bool isInteger() const { return std::holds_alternative<std::int64_t>(m_content); }
  bool isNumber() const { return isInteger() || std::holds_alternative<double>(m_content); }
  bool isText() const { return std::holds_alternative<std::string>(m_content); }
  bool isArray() const { return std::holds_alternative<Items>(m_content); }
  bool isObject() const { return std::holds_alternative<Members>(m_content); }

  bool boolean(bool otherwise = false) const;
  double number(double otherwise = 0) const;
  std::int64_t integer(std::int64_t otherwise = 0) const;
  const std::string& text() const;      ///< empty unless text
  const Items& items() const;           ///< empty unless an array
  const Members& members() const;       ///< empty unless an object
  const JsonValue* find(std::string_view key) const;  ///< null pointer when absent
  const JsonValue& operator[](std::string_view key) const;   ///< null value when absent
  const JsonValue& operator[](std::size_t index) const;      ///< null value when beyond the end
  const JsonValue& operator[](int index) const { return (*this)[static_cast<std::size_t>(index)]; }
  const JsonValue& operator[](const char* key) const { return (*this)[std::string_view(key)]; }

  void set(std::string key, JsonValue value);  ///< replaces or appends a member; makes an object of null
  void append(JsonValue value);                ///< makes an array of null
  void append(std::string key, JsonValue value);  ///< a member whose key is known to be new
  bool erase(std::string_view key);            ///< false when there was none

  bool operator==(const JsonValue&) const = default;

 private:
  explicit JsonValue(Items items) : m_content(std::move(items)) {}
  explicit JsonValue(Members members) : m_content(std::move(members)) {}
  std::variant<std::monostate, bool, std::int64_t, double, std::string, Items, Members> m_content;
};

/// `pointer` + "/" + token, escaped as RFC 6901 asks.
std::string pointerTo(const std::string& pointer, std::string_view token);
std::string pointerTo(const std::string& pointer, std::size_t index);

/// One token of a pointer as the key it stands for.
std::string unescapedToken(std::string_view token);

/// The value a JSON pointer names, or null.
const JsonValue* valueAt(const JsonValue& json, std::string_view pointer);

}  // namespace glenoid
