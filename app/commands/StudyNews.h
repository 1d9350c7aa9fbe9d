// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include "simcore/base/Error.h"
#include "simcore/file/JsonValue.h"
#include "simcore/study/StudyTable.h"

namespace glenoid {

/// What a study that is under way says to whoever watches: progress.jsonl in its folder, a line of JSON for each thing, written whole
/// and at once. The first says what is studied, those that follow one of
///   {"fraction": 0.25, "what": "cells=2"}            how far it is, at most five times a second
///   {"table": "settings", "row": {…}}                a row as it will stand in that table, or what is known of it by now
///   {"ended": "done" | "failed", "document": true, "error": {…}}  the last, with a Fault by its word, Place and Arguments; document: the
///                                                    study's JSON in the folder is of this run
/// A file that cannot be written stops no study.
class StudyNews {
 public:
  StudyNews(const std::string& folder, JsonValue what);
  ~StudyNews();
  StudyNews(const StudyNews&) = delete;
  StudyNews& operator=(const StudyNews&) = delete;

  void progress(const std::string& what, double fraction);
  /// A row of a table by its place; `more`: members beside its columns.
  void row(const StudyTable& table, std::size_t row, const JsonValue& more = {});
  void table(const StudyTable& table);
  /// The document with all tables is written.
  void documentIsThere() { m_document = true; }
  /// `done` is what the command answers.
  void end(const Result<Done>& done);

 private:
  using Clock = std::chrono::steady_clock;
  void say(const JsonValue& line);

  std::FILE* m_file;
  Clock::time_point m_last{};
  bool m_document = false;
};

/// The file's name in a study's folder.
inline constexpr const char* kStudyNews = "progress.jsonl";

}  // namespace glenoid
