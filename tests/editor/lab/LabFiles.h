// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QFile>
#include <QTemporaryDir>
#include <string>

#include "editor/lab/StudyFolder.h"

namespace glenoid::labtest {

/// A folder of a study that a test writes line by line.
class LabFolder {
 public:
  std::string path() const { return m_folder.path().toStdString(); }
  void append(const std::string& text, const char* leaf = "progress.jsonl") const {
    QFile file(m_folder.filePath(QLatin1String(leaf)));
    if (file.open(QIODevice::Append)) file.write(text.data(), static_cast<qint64>(text.size()));
  }

 private:
  QTemporaryDir m_folder;
};

/// A row of "settings" as the study writes it; null: no figure.
inline std::string settingRow(const std::string& id, const std::string& ms, const std::string& p95, const std::string& error, const std::string& more = "\"inScenario\":true") {
  return R"({"table":"settings","row":{"setting":")" + id + R"(","family":"time-step","failure":"","failureDetail":"","windows":4,"workMedianMs":)" + ms + R"(,"workP95Ms":)" + p95 +
         R"(,"displacementOwnCellsMm":)" + error + R"(,"displacementWhereOwnCells":"block",)" + more + "}}\n";
}

}  // namespace glenoid::labtest
