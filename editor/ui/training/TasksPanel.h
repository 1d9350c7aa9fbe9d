// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>
#include <memory>
#include <set>
#include <string>

#include "editor/core/PlayLink.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace glenoid {

/// What is to be done in the scene, how far it is, and at the end how it went: each task with its state, the text of the one
/// chosen or open, a hint on demand; then score and metrics, with the formula of the one chosen. Shows what the run publishes.
class TasksPanel : public QWidget {
  Q_OBJECT
 public:
  TasksPanel(Document& document, PlayLink& link, QWidget* parent = nullptr);

  /// Who does the tasks, once the name is typed to its end (Return, or the focus leaves); empty: nobody says so, and nothing is kept.
  QString trainee() const;
  /// What became of keeping the run; comes from who keeps it.
  void setRecordSentence(const QString& sentence);

 signals:
  void showWanted(const std::set<std::string>& parts);  ///< a hint: where it is
  void runsWanted();      ///< their own runs are to be shown
  void tasksAppeared();  ///< a scene with tasks was opened

 protected:
  void changeEvent(QEvent* event) override;

 private:
  const Training& training() const;
  int shownTask() const;
  void rebuild();
  void refresh();
  void refreshText();
  void fillFigures(const TrainingReport& report);

  Document& m_document;
  PlayLink& m_link;
  std::shared_ptr<const TrainingReport> m_report;
  Training m_listed;      ///< what the list was made of
  bool m_hinted = false;
  int m_hintTask = -1;
  QLabel* m_intro;
  QListWidget* m_list;
  QLabel* m_text;
  QPushButton* m_hint;
  QLabel* m_sentence;
  QTableWidget* m_figures;
  QLabel* m_formula;
  QPushButton* m_again;
  QLineEdit* m_trainee;
  QString m_name;         ///< typed to its end
  QLabel* m_traineeLabel;
  QPushButton* m_runs;
  QLabel* m_kept;
};

}  // namespace glenoid
