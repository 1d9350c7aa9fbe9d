// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/StudyFolder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

#include "simcore/file/Json.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNews = "progress.jsonl";
/// Members of a study's document that are not tables are its head.
constexpr const char* kTables = "tables";

/// By what a row of a table is known, where it is told again: its first column.
const std::string& nameOf(const JsonValue& row) {
  static const std::string kNone;
  return row.members().empty() ? kNone : row.members().front().second.text();
}

/// Rows that are told again are of one thing: two profiles may run one trial.
bool isSame(const JsonValue& a, const JsonValue& b) { return nameOf(a) == nameOf(b) && a["profile"].text() == b["profile"].text(); }

/// What app/commands/StudyNews.cpp wrote.
Error errorOf(const JsonValue& json) {
  Error error;
  for (int k = 0; k < kFaultCount; ++k)
    if (json["fault"].text() == faultName(static_cast<Fault>(k))) error.fault = static_cast<Fault>(k);
  error.place = {json["file"].text(), json["pointer"].text(), json["part"].text(), {}};
  if (json["element"].isInteger()) error.place.element = static_cast<long>(json["element"].integer());
  for (const JsonValue& argument : json["arguments"].items()) error.arguments.push_back(argument.text());
  return error;
}

}  // namespace

double figureOf(const JsonValue& row, const std::string& column) {
  const JsonValue* value = row.find(column);
  return value && value->isNumber() ? value->number() : std::numeric_limits<double>::quiet_NaN();
}

Result<StudyFolder> StudyFolder::open(const std::string& path) {
  StudyFolder folder(path);
  folder.look();
  if (folder.kind().empty()) {  // one that left its document alone, such as a study put together from shards
    std::vector<std::string> leaves;
    std::error_code failed;
    for (fs::directory_iterator it(path, failed), end; !failed && it != end; it.increment(failed))
      if (it->path().extension() == ".json") leaves.push_back(it->path().filename().string());
    std::sort(leaves.begin(), leaves.end());
    for (const std::string& leaf : leaves)
      if (folder.readDocument(leaf)) break;
  }
  if (folder.kind().empty()) return Error{Fault::FileMissing, {(fs::path(path) / "accuracy.json").string(), "", "", {}}, {}, "study"};
  return folder;
}

bool StudyFolder::look() {
  if (m_ended || m_path.empty()) return false;
  std::ifstream file(fs::path(m_path) / kNews, std::ios::binary);
  if (!file) return false;
  file.seekg(static_cast<std::streamoff>(m_read));
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t whole = text.rfind('\n');
  if (whole == std::string::npos) return false;
  m_read += whole + 1;
  std::size_t begin = 0;
  while (begin <= whole) {
    const std::size_t end = text.find('\n', begin);
    if (const auto line = parseJson(std::string_view(text).substr(begin, end - begin), kNews)) take(*line);
    begin = end + 1;
  }
  if (m_ended && m_document) readDocument(kind() + ".json");  // without, what lies there is of a study before
  return true;
}

void StudyFolder::take(const JsonValue& line) {
  if (line.find("study")) {
    m_head = line;
  } else if (line.find("ended")) {
    m_ended = true;
    m_document = line["document"].boolean();
    if (line.find("error")) m_error = errorOf(line["error"]);
    if (line["ended"].text() == "done") m_fraction = 1;
  } else if (line.find("table")) {
    putRow(line["table"].text(), line["row"]);
  } else if (line.find("fraction")) {
    m_fraction = line["fraction"].number();
    m_what = line["what"].text();
  }
}

void StudyFolder::putRow(const std::string& table, JsonValue row) {
  std::vector<JsonValue>& rows = m_rows[table];
  const auto known = std::find_if(rows.begin(), rows.end(), [&](const JsonValue& other) { return isSame(row, other); });
  if (known == rows.end()) rows.push_back(std::move(row));
  else *known = std::move(row);
}

bool StudyFolder::readDocument(const std::string& leaf) {
  const Result<JsonValue> json = readJson((fs::path(m_path) / leaf).string());
  if (!json || !(*json)[kTables].isArray()) return false;
  const std::string stem = fs::path(leaf).stem().string();
  JsonValue head = JsonValue::object();
  head.set("study", stem);
  for (const auto& [key, value] : json->members())
    if (key != kTables) head.set(key == "scene" ? "scenario" : key, value);
  if (m_head.isNull()) m_head = head;
  for (const auto& [key, value] : head.members())
    if (!m_head.find(key)) m_head.set(key, value);
  for (const JsonValue& table : (*json)[kTables].items()) {
    m_documents[table["id"].text()] = table;
    m_rows[table["id"].text()] = table["rows"].items();
  }
  m_fraction = 1;
  m_ended = m_whole = true;
  return true;
}

const std::vector<JsonValue>& StudyFolder::rows(const std::string& table) const {
  static const std::vector<JsonValue> kNone;
  const auto found = m_rows.find(table);
  return found == m_rows.end() ? kNone : found->second;
}

}  // namespace glenoid
