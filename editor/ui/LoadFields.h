// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QGroupBox>

#include "editor/core/LoadEdits.h"

class QDoubleSpinBox;
class QFormLayout;

namespace glenoid {

/// The loads of a scenario, or those on one part: force (N), torque (N·m), point (mm), and the time in which all rise (s). Every
/// edit is an undo step; what the document refuses is put back. Shows the scenario as it is when made; whoever holds it makes
/// another one when the document changes, but for changes while `editing` is true, which are its own.
class LoadFields : public QGroupBox {
  Q_OBJECT
 public:
  /// `part`: id; empty: of the whole scenario. `document` and `editing` must outlive it.
  LoadFields(Document& document, const std::string& part, bool& editing, QWidget* parent = nullptr);

 private:
  enum class Vector { Force, Torque, Point };
  void showRise(QFormLayout& form);
  void showLoad(QFormLayout& form, int index);
  QWidget* vectorRow(int index, Vector which);
  QDoubleSpinBox* component(int index, Vector which, int axis);

  Document& m_document;
  const std::string m_part;
  bool& m_editing;
};

}  // namespace glenoid
