// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>

#include "editor/core/JobSystem.h"
#include "editor/core/PlayLink.h"
#include "editor/lab/LabServices.h"
#include "editor/lab/StabilityEntries.h"
#include "editor/lab/TrialReplay.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace glenoid {

class PictureLabel;
class StudyBar;

/// What stays stable: the gauntlet of the open scene, a row for each trial as it ends, a filter, the picture of a failure; a double click or
/// Enter runs a failure again in the view.
class StabilityPanel : public QWidget {
  Q_OBJECT
 public:
  StabilityPanel(Document& document, PlayLink& link, JobSystem& jobs, const LabServices& services, QWidget* parent = nullptr);

  StudyBar& bar() { return *m_bar; }
  TrialReplay& replay() { return m_replay; }
  const std::vector<StabilityEntry>& entries() const { return m_entries; }
  /// Only these cases are run, as on the command line; empty: all.
  void setCases(const QStringList& cases) { m_cases = cases; }
  void replayEntry(std::size_t entry);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void refresh();
  void filter();
  void showCurrent();
  int currentEntry() const;

  Document& m_document;
  JobSystem& m_jobs;
  const LabServices& m_services;
  TrialReplay m_replay;
  QStringList m_cases;
  std::vector<StabilityEntry> m_entries;
  StudyBar* m_bar;
  QLabel *m_summary, *m_words, *m_shown;
  QLineEdit* m_filter;
  QCheckBox* m_failures;
  QTableWidget* m_table;
  PictureLabel* m_picture;
  QPushButton *m_play, *m_back;
};

}  // namespace glenoid
