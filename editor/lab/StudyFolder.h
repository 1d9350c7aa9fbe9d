// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/file/JsonValue.h"

namespace glenoid {

/// A study as the files of its folder tell it: while it runs by progress.jsonl, which grows line by line, afterwards by its whole
/// document (accuracy.json, stability.json and their like). What is read is data: nothing here knows what a table means.
class StudyFolder {
 public:
  StudyFolder() = default;
  explicit StudyFolder(std::string path) : m_path(std::move(path)) {}

  /// Reads what is there. Fails with FileMissing where the folder holds no study, and as reading JSON does.
  static Result<StudyFolder> open(const std::string& path);

  /// Takes what has come since the last look; true when something has. A line that is not whole yet waits.
  bool look();

  const std::string& path() const { return m_path; }
  const std::string& kind() const { return m_head["study"].text(); }  ///< "accuracy", "stability", …; empty: nothing was read
  const JsonValue& head() const { return m_head; }                    ///< scenario, machine, quick …
  const std::vector<JsonValue>& rows(const std::string& table) const;
  const std::map<std::string, JsonValue>& documents() const { return m_documents; }  ///< whole tables by id: facts, columns, rows
  double fraction() const { return m_fraction; }
  const std::string& what() const { return m_what; }  ///< is done now; empty: not said
  bool hasEnded() const { return m_ended; }
  bool isWhole() const { return m_whole; }            ///< its document was read: all rows are there
  const std::optional<Error>& error() const { return m_error; }  ///< with which it ended

 private:
  void take(const JsonValue& line);
  void putRow(const std::string& table, JsonValue row);
  bool readDocument(const std::string& leaf);

  std::string m_path;
  JsonValue m_head;
  std::map<std::string, std::vector<JsonValue>> m_rows;
  std::map<std::string, JsonValue> m_documents;
  std::uint64_t m_read = 0;  ///< bytes of progress.jsonl
  double m_fraction = 0;
  bool m_ended = false, m_whole = false;
  bool m_document = false;  ///< the study that ended wrote its document
  std::string m_what;
  std::optional<Error> m_error;
};

/// A figure of a row; NaN where it has none.
double figureOf(const JsonValue& row, const std::string& column);

}  // namespace glenoid
