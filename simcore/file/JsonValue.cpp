// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/file/JsonValue.h"

#include <charconv>

namespace glenoid {
namespace {

const JsonValue kNull;
const std::string kNoText;
const JsonValue::Items kNoItems;
const JsonValue::Members kNoMembers;

}  // namespace

bool JsonValue::boolean(bool otherwise) const {
  const bool* value = std::get_if<bool>(&m_content);
  return value ? *value : otherwise;
}

double JsonValue::number(double otherwise) const {
  if (const double* value = std::get_if<double>(&m_content)) return *value;
  if (const std::int64_t* value = std::get_if<std::int64_t>(&m_content)) return static_cast<double>(*value);
  return otherwise;
}

std::int64_t JsonValue::integer(std::int64_t otherwise) const {
  const std::int64_t* value = std::get_if<std::int64_t>(&m_content);
  return value ? *value : otherwise;
}

const std::string& JsonValue::text() const {
  const std::string* value = std::get_if<std::string>(&m_content);
  return value ? *value : kNoText;
}

const JsonValue::Items& JsonValue::items() const {
  const Items* value = std::get_if<Items>(&m_content);
  return value ? *value : kNoItems;
}

const JsonValue::Members& JsonValue::members() const {
  const Members* value = std::get_if<Members>(&m_content);
  return value ? *value : kNoMembers;
}

const JsonValue* JsonValue::find(std::string_view key) const {
  for (const auto& [name, value] : members())
    if (name == key) return &value;
  return nullptr;
}

const JsonValue& JsonValue::operator[](std::string_view key) const {
  const JsonValue* value = find(key);
  return value ? *value : kNull;
}

const JsonValue& JsonValue::operator[](std::size_t index) const {
  return index < items().size() ? items()[index] : kNull;
}

void JsonValue::set(std::string key, JsonValue value) {
  if (!isObject()) m_content = Members{};
  Members& members = std::get<Members>(m_content);
  for (auto& member : members)
    if (member.first == key) {
      member.second = std::move(value);
      return;
    }
  members.emplace_back(std::move(key), std::move(value));
}

void JsonValue::append(JsonValue value) {
  if (!isArray()) m_content = Items{};
  std::get<Items>(m_content).push_back(std::move(value));
}

void JsonValue::append(std::string key, JsonValue value) {
  if (!isObject()) m_content = Members{};
  std::get<Members>(m_content).emplace_back(std::move(key), std::move(value));
}

bool JsonValue::erase(std::string_view key) {
  Members* members = std::get_if<Members>(&m_content);
  if (!members) return false;
  return std::erase_if(*members, [&](const auto& member) { return member.first == key; }) > 0;
}

std::string pointerTo(const std::string& pointer, std::string_view token) {
  std::string longer = pointer + "/";
  for (const char c : token) {
    if (c == '~')
      longer += "~0";
    else if (c == '/')
      longer += "~1";
    else
      longer += c;
  }
  return longer;
}

std::string pointerTo(const std::string& pointer, std::size_t index) {
  return pointer + "/" + std::to_string(index);
}

std::string unescapedToken(std::string_view token) {
  std::string plain;
  for (std::size_t i = 0; i < token.size(); ++i) {
    if (token[i] == '~' && i + 1 < token.size() && (token[i + 1] == '0' || token[i + 1] == '1'))
      plain += token[++i] == '0' ? '~' : '/';
    else
      plain += token[i];
  }
  return plain;
}

const JsonValue* valueAt(const JsonValue& json, std::string_view pointer) {
  const JsonValue* at = &json;
  while (!pointer.empty()) {
    if (pointer[0] != '/') return nullptr;
    pointer.remove_prefix(1);
    const std::string_view token = pointer.substr(0, pointer.find('/'));
    pointer.remove_prefix(token.size());
    if (at->isArray()) {
      std::size_t index = 0;
      const auto [end, failed] = std::from_chars(token.data(), token.data() + token.size(), index);
      if (failed != std::errc() || end != token.data() + token.size() || index >= at->items().size())
        return nullptr;
      at = &at->items()[index];
    } else {
      at = at->find(unescapedToken(token));
      if (!at) return nullptr;
    }
  }
  return at;
}

}  // namespace glenoid
