// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/file/Json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "simcore/file/AtomicWrite.h"

namespace glenoid {
namespace {

/// Builds the value from nlohmann's events and stops at the first fault. The parser keeps no call stack of
/// its own, so depth is bounded here, before a deep value could overflow anybody's recursion.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(std::string_view text, const std::string& file, int depthMax)
      : m_text(text), m_file(file), m_depthMax(depthMax) {}

  bool null() override { return take({}); }
  bool boolean(bool value) override { return take(value); }
  bool number_integer(number_integer_t value) override { return take(static_cast<long long>(value)); }
  bool number_unsigned(number_unsigned_t value) override {
    if (value > static_cast<number_unsigned_t>(std::numeric_limits<std::int64_t>::max()))
      return take(static_cast<double>(value));
    return take(static_cast<long long>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return take(value); }
  bool string(string_t& value) override { return take(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonValue::object()); }
  bool start_array(std::size_t) override { return open(JsonValue::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = m_levels.back();
    level.key = std::move(name);
    if (!level.keys.insert(level.key).second) return fail(Fault::DuplicateId, {level.key});
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& what) override {
    constexpr int kNumberOverflow = 406;
    if (what.id == kNumberOverflow || wordIsNotANumber(position)) return fail(Fault::NotFinite, {}, position);
    if (position > m_text.size()) return fail(Fault::FileTruncated, {}, position, what.what());
    const auto [line, column] = lineAndColumn(position);
    return fail(Fault::NotJson, {std::to_string(line), std::to_string(column)}, position, what.what());
  }

  const std::optional<Error>& error() const { return m_error; }
  JsonValue takeRoot() { return std::move(m_root); }

 private:
  struct Level {
    JsonValue value;
    std::string key;             ///< of the member being read
    std::set<std::string> keys;  ///< seen so far
  };

  bool take(JsonValue value) {
    if (m_levels.empty()) {
      m_root = std::move(value);
    } else if (Level& level = m_levels.back(); level.value.isArray()) {
      level.value.append(std::move(value));
    } else {
      level.value.append(level.key, std::move(value));
    }
    return true;
  }

  bool open(JsonValue value) {
    if (static_cast<int>(m_levels.size()) >= m_depthMax)
      return fail(Fault::TooDeep, {std::to_string(m_depthMax)});
    m_levels.push_back({std::move(value), {}, {}});
    return true;
  }

  bool close() {
    JsonValue value = std::move(m_levels.back().value);
    m_levels.pop_back();
    return take(std::move(value));
  }

  std::string pointer() const {
    std::string at;
    for (const Level& level : m_levels) {
      if (level.value.isArray())
        at = pointerTo(at, level.value.items().size());
      else if (!level.key.empty() || !level.keys.empty())
        at = pointerTo(at, level.key);
    }
    return at;
  }

  /// Position counts the characters read, so the last of them is the offender.
  std::pair<long, long> lineAndColumn(std::size_t position) const {
    const std::string_view before = m_text.substr(0, std::min(position ? position - 1 : 0, m_text.size()));
    const long line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
    return {line, static_cast<long>(before.size() - lineStart) + 1};
  }

  /// NaN, inf, Infinity, -Infinity in any case: what other programs print for a number that is none.
  bool wordIsNotANumber(std::size_t position) const {
    const auto isWord = [](char c) {
      return std::isalpha(static_cast<unsigned char>(c)) || c == '-' || c == '+';
    };
    std::size_t begin = std::min(position ? position - 1 : 0, m_text.size());
    while (begin > 0 && begin + 12 > position && isWord(m_text[begin - 1])) --begin;
    std::string word;
    for (std::size_t i = begin; i < m_text.size() && word.size() < 12 && isWord(m_text[i]); ++i)
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(m_text[i])));
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.erase(0, 1);
    return word == "nan" || word == "inf" || word == "infinity";
  }

  bool fail(Fault fault, Arguments arguments, std::size_t position = 0, std::string detail = {}) {
    if (m_error) return false;
    Error error{fault, {m_file, pointer(), {}, {}}, std::move(arguments), std::move(detail)};
    if (position > 0) error.place.element = lineAndColumn(position).first;
    m_error = std::move(error);
    return false;
  }

  std::string_view m_text;
  const std::string& m_file;
  int m_depthMax;
  std::vector<Level> m_levels;
  JsonValue m_root;
  std::optional<Error> m_error;
};

}  // namespace

Result<JsonValue> parseJson(std::string_view text, const std::string& file, const JsonLimits& limits) {
  const Place place{file, {}, {}, {}};
  if (text.size() > limits.bytes)
    return Error{Fault::FileTooLarge,
                 place,
                 {std::to_string(text.size()) + " bytes", std::to_string(limits.bytes) + " bytes"},
                 {}};
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return Error{Fault::FileEmpty, place, {}, {}};
  Builder builder(text, file, limits.depth);
  const bool read = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  if (builder.error()) return *builder.error();
  if (!read) return Error{Fault::NotJson, place, {"1", "1"}, "the parser stopped without a reason"};
  return builder.takeRoot();
}

Result<JsonValue> readJson(const std::string& path, const JsonLimits& limits) {
  const Result<std::string> text = readWholeFile(path, limits.bytes);
  if (!text) return text.error();
  return parseJson(*text, path, limits);
}

}  // namespace glenoid
