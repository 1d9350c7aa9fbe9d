// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>
#include <vector>

#include "editor/core/PlayLink.h"

class QCheckBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace glenoid {

/// Which tool the mouse moves, how hard each one presses, and whether tools that nobody holds follow the
/// recorded input. The choice itself belongs to whoever listens to `chosen`.
class ToolPanel : public QWidget {
  Q_OBJECT
 public:
  ToolPanel(Document& document, PlayLink& link, QWidget* parent = nullptr);
  void setChosen(int tool);

 signals:
  void chosen(int tool);  ///< index in the scenario, −1: none

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void retranslate();
  void showForces();

  Document& m_document;
  PlayLink& m_link;
  QWidget* m_list;
  QVBoxLayout* m_listLayout;
  QLabel* m_hint;
  QCheckBox* m_follow;
  std::vector<QToolButton*> m_buttons;  ///< by tool
  std::vector<QLabel*> m_forces;        ///< by tool
  int m_chosen = -1;
};

}  // namespace glenoid
