// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/TableText.h"

#include <cmath>

#include "app/commands/Console.h"

namespace glenoid {
namespace {

JsonValue jsonOf(const StudyCell& cell) {
  return std::visit([](const auto& value) -> JsonValue {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) return {};
    else return JsonValue(value);
  }, cell);
}

/// As many digits as say something; very small numbers with a power of ten.
std::string numberText(double value) {
  const double size = std::abs(value);
  if (value == 0 || std::isnan(value)) return value == 0 ? "0" : "nan";
  if (size < 1e-3 || size >= 1e6) return text("%.1e", value);
  if (size < 10) return text("%.3f", value);
  return text(size < 1000 ? "%.1f" : "%.0f", value);
}

std::string cellText(const StudyCell& cell) {
  if (const auto* yes = std::get_if<bool>(&cell)) return *yes ? "yes" : "no";
  if (const auto* count = std::get_if<long>(&cell)) return text("%ld", *count);
  if (const auto* number = std::get_if<double>(&cell)) return numberText(*number);
  if (const auto* words = std::get_if<std::string>(&cell)) return words->empty() ? "–" : *words;
  return "–";
}

/// Places on the terminal: bytes that begin a character.
int widthOf(const std::string& words) {
  int width = 0;
  for (const char c : words) width += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return width;
}

std::string padded(const std::string& words, int width, bool left) {
  const std::string gap(static_cast<std::size_t>(std::max(0, width - widthOf(words))), ' ');
  return left ? words + gap : gap + words;
}

}  // namespace

std::string tableText(const StudyTable& table, const std::string& title) {
  std::string out = title + "\n";
  for (const auto& [key, value] : table.facts) out += "  " + keyWords(key) + ": " + cellText(value) + "\n";
  std::vector<std::vector<std::string>> lines(1);
  for (const std::string& column : table.columns) lines[0].push_back(keyWords(column));
  for (const auto& row : table.rows) {
    auto& line = lines.emplace_back();
    for (const StudyCell& cell : row) line.push_back(cellText(cell));
  }
  std::vector<int> width(table.columns.size(), 0);
  std::vector<bool> left(table.columns.size(), false);
  for (const auto& line : lines)
    for (std::size_t c = 0; c < line.size(); ++c) width[c] = std::max(width[c], widthOf(line[c]));
  for (const auto& row : table.rows)
    for (std::size_t c = 0; c < row.size(); ++c) left[c] = left[c] || std::holds_alternative<std::string>(row[c]);
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) out += "  " + padded(line[c], width[c], left[c]);
    out += "\n";
  }
  return out;
}

JsonValue tableJson(const StudyTable& table) {
  JsonValue facts = JsonValue::object(), columns = JsonValue::array(), rows = JsonValue::array();
  for (const auto& [key, value] : table.facts) facts.set(key, jsonOf(value));
  for (const std::string& column : table.columns) columns.append(column);
  for (const auto& row : table.rows) {
    JsonValue entry = JsonValue::object();
    for (std::size_t c = 0; c < row.size(); ++c) entry.set(table.columns[c], jsonOf(row[c]));
    rows.append(std::move(entry));
  }
  JsonValue json = JsonValue::object();
  json.set("id", table.id);
  json.set("facts", std::move(facts));
  json.set("columns", std::move(columns));
  json.set("rows", std::move(rows));
  return json;
}

}  // namespace glenoid
