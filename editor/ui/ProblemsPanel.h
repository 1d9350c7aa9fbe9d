// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>
#include <set>
#include <string>

#include "editor/core/PlayLink.h"
#include "editor/core/ProblemWatch.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace glenoid {

/// The problem list: an icon and a sentence for each, the worst first, and after them what must be said about the run.
/// Activating one (double click, Enter) asks for its parts to be shown; the button does its quick fix as one undo step. Shows
/// and forwards; what is wrong comes from ProblemWatch and PlayLink.
class ProblemsPanel : public QWidget {
  Q_OBJECT
 public:
  ProblemsPanel(Document& document, ProblemWatch& watch, const PlayLink& link, QWidget* parent = nullptr);

 signals:
  void showWanted(const std::set<std::string>& parts);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  const Problem* current() const;
  const Notice* currentNotice() const;
  std::set<std::string> objectsOf(const Notice& notice) const;
  void rebuild();
  void refresh();

  Document& m_document;
  ProblemWatch& m_watch;
  const PlayLink& m_link;
  std::vector<Notice> m_notices;  ///< those in the list: without what is a problem of the scene already
  QLabel* m_summary;
  QListWidget* m_list;
  QLabel* m_advice = nullptr;
  QPushButton* m_fix;
};

}  // namespace glenoid
