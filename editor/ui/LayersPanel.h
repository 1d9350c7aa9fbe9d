// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>
#include <vector>

#include "editor/core/DisplayState.h"

class QToolButton;

namespace glenoid {

/// Switches for what is drawn: each representation for itself, as in the paper's Figure 1. The switches are
/// actions, so that the View menu shows the same ones.
class LayersPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LayersPanel(DisplayState& display, QWidget* parent = nullptr);
  const std::vector<QAction*>& layerActions() const { return m_actions; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();

  DisplayState& m_display;
  std::vector<QAction*> m_actions;  ///< by DisplayState::kLayers
  std::vector<QToolButton*> m_buttons;
};

}  // namespace glenoid
