// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QScrollArea>

#include "editor/core/PlayLink.h"
#include "editor/core/Selection.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace glenoid {

/// What is known about the selected part or tool, in millimetres and kilopascals; name, number and
/// colour of a part, stiffnesses, loads, how it moves and whether it touches itself can be edited, each edit is one undo step. Without a selection: the joint's name,
/// description, licence, author and side, which can be edited too; the scene as a whole, all its loads, whether its run is at rest, and its effects.
class PropertiesPanel : public QScrollArea {
  Q_OBJECT
 public:
  PropertiesPanel(Document& document, Selection& selection, PlayLink& link, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void showScene(QVBoxLayout& layout);
  void showJoint(QVBoxLayout& layout);
  QComboBox* sideBox();
  void showPart(QVBoxLayout& layout, const Part& part);
  void showTool(QVBoxLayout& layout, const Tool& tool);
  QLabel* restLabel();
  QLineEdit* nameField(const Part& part);
  QSpinBox* numberField(const Part& part);
  QPushButton* colorButton(const Part& part);
  QComboBox* movementBox(const Part& part);
  QComboBox* elementsBox(const Part& part);
  QCheckBox* foldsBox(const Part& part);
  void showMaterials(QVBoxLayout& layout, const Part& part);
  void showCouplings(QVBoxLayout& layout, const Part& part);

  Document& m_document;
  Selection& m_selection;
  PlayLink& m_link;
  bool m_editing = false;  ///< one of our own fields caused the change
};

}  // namespace glenoid
