// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/StudyNews.h"

#include "app/commands/TableText.h"
#include "simcore/file/JsonObject.h"

namespace glenoid {
namespace {

/// On one line: a text inside holds no line break, since JSON escapes it.
std::string lineOf(const JsonValue& json) {
  std::string line;
  bool indent = false;
  for (const char c : toText(json)) {
    indent = c == '\n' || (indent && c == ' ');
    if (!indent) line += c;
  }
  return line + "\n";
}

/// For who says it in the language of a window.
JsonValue jsonOf(const Error& error) {
  JsonValue arguments = JsonValue::array();
  for (const std::string& argument : error.arguments) arguments.append(argument);
  JsonValue json = jsonObject({{"fault", faultName(error.fault)}, {"file", error.place.file}, {"pointer", error.place.pointer}, {"part", error.place.part}});
  if (error.place.element) json.set("element", *error.place.element);
  json.set("arguments", std::move(arguments));
  return json;
}

}  // namespace

StudyNews::StudyNews(const std::string& folder, JsonValue what) : m_file(std::fopen((folder + "/" + kStudyNews).c_str(), "wb")) { say(what); }

StudyNews::~StudyNews() {
  if (m_file) std::fclose(m_file);
}

void StudyNews::say(const JsonValue& line) {
  if (!m_file) return;
  const std::string text = lineOf(line);
  std::fwrite(text.data(), 1, text.size(), m_file);
  std::fflush(m_file);
}

void StudyNews::progress(const std::string& what, double fraction) {
  const auto now = Clock::now();
  if (now - m_last < std::chrono::milliseconds(200)) return;
  m_last = now;
  say(jsonObject({{"fraction", fraction}, {"what", what}}));
}

void StudyNews::row(const StudyTable& table, std::size_t row, const JsonValue& more) {
  StudyTable one{table.id, {}, table.columns, {table.rows[row]}};
  JsonValue entry = tableJson(one)["rows"][0];
  for (const auto& [key, value] : more.members()) entry.set(key, value);
  say(jsonObject({{"table", table.id}, {"row", std::move(entry)}}));
}

void StudyNews::table(const StudyTable& table) {
  for (std::size_t k = 0; k < table.rows.size(); ++k) row(table, k);
}

void StudyNews::end(const Result<Done>& done) {
  if (done) say(jsonObject({{"ended", "done"}, {"document", m_document}}));
  else say(jsonObject({{"ended", done.error().fault == Fault::CheckFailed ? "done" : "failed"}, {"document", m_document}, {"error", jsonOf(done.error())}}));
}

}  // namespace glenoid
