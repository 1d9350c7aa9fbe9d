// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>

#include "editor/core/FieldView.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace glenoid {

/// Which quantity colours the parts, and on which scale.
class FieldPanel : public QWidget {
  Q_OBJECT
 public:
  explicit FieldPanel(FieldView& field, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void refresh();
  void takeRange();

  FieldView& m_field;
  QLabel *m_title, *m_unit;
  QComboBox* m_quantity;
  QCheckBox* m_automatic;
  QDoubleSpinBox *m_low, *m_high;
  double m_si = 1;  ///< of the unit in which the fields are
};

}  // namespace glenoid
