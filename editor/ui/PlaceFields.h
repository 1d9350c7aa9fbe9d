// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QGroupBox>
#include <array>

#include "editor/core/Document.h"

class QDoubleSpinBox;
class QLabel;

namespace glenoid {

/// A part put elsewhere by numbers: shift (mm), turn about its middle (°), scale. Nothing is done before the button is pressed; then
/// it is one undo step, and the fields begin anew.
class PlaceFields : public QGroupBox {
  Q_OBJECT
 public:
  PlaceFields(Document& document, const std::string& part, QWidget* parent = nullptr);

 private:
  void apply();

  Document& m_document;
  const std::string m_part;
  std::array<QDoubleSpinBox*, 3> m_shift{}, m_turn{};
  QDoubleSpinBox* m_scale = nullptr;
  QLabel* m_why = nullptr;
};

}  // namespace glenoid
