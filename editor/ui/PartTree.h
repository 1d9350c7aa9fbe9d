// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>
#include <map>
#include <string>

#include "editor/core/DisplayState.h"
#include "editor/core/Document.h"

class QLabel;
class QPushButton;
class QSlider;
class QTreeWidget;
class QTreeWidgetItem;

namespace glenoid {

/// Rigid parts, soft parts and tools of the scene, each with a check box for being seen; below, the opacity of the
/// selected ones, solo, and show all. Shows and forwards; what is seen lives in DisplayState.
class PartTree : public QWidget {
  Q_OBJECT
 public:
  PartTree(Document& document, DisplayState& display, Selection& selection, QWidget* parent = nullptr);

  QTreeWidgetItem* itemOf(const std::string& id) const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void retranslate();
  void showDisplay();
  void showSelection();
  QTreeWidgetItem* group(const QString& key, const char* icon);

  Document& m_document;
  DisplayState& m_display;
  Selection& m_selection;
  QTreeWidget* m_tree;
  QSlider* m_opacity;
  QLabel* m_opacityLabel;
  QPushButton *m_solo, *m_showAll;
  std::map<std::string, QTreeWidgetItem*> m_items;
  bool m_showing = false;  ///< the tree is being set by us, not by a person
};

}  // namespace glenoid
