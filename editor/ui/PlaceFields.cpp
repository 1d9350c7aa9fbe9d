// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/PlaceFields.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "editor/core/PartEdits.h"
#include "editor/ui/PanelParts.h"

namespace glenoid {
namespace {

QWidget* rowOf(std::array<QDoubleSpinBox*, 3>& boxes, const QString& name, double most, int decimals, const QStringList& called) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  for (int axis = 0; axis < 3; ++axis) {
    boxes[static_cast<std::size_t>(axis)] = panel::field(name + QLatin1Char('.') + QLatin1Char("xyz"[axis]), -most, most, decimals);
    boxes[static_cast<std::size_t>(axis)]->setMinimumWidth(55);
    boxes[static_cast<std::size_t>(axis)]->setAccessibleName(called.value(axis));
    layout->addWidget(boxes[static_cast<std::size_t>(axis)]);
  }
  return row;
}

}  // namespace

PlaceFields::PlaceFields(Document& document, const std::string& part, QWidget* parent) : QGroupBox(parent), m_document(document), m_part(part) {
  setTitle(tr("Place"));
  auto* form = new QFormLayout(this);
  form->setLabelAlignment(Qt::AlignLeft);
  form->addRow(tr("Shift, mm:"), rowOf(m_shift, QStringLiteral("place.shift"), 1e4, 2, {tr("Shift along X"), tr("Shift along Y"), tr("Shift along Z")}));
  form->addRow(tr("Turn, °:"), rowOf(m_turn, QStringLiteral("place.turn"), 360, 1, {tr("Turn about X"), tr("Turn about Y"), tr("Turn about Z")}));
  m_scale = panel::field(QStringLiteral("place.scale"), 1e-3, 1e3, 4);
  m_scale->setValue(1);
  form->addRow(tr("Scale:"), m_scale);
  auto* button = panel::button("place.apply");
  button->setText(tr("Put it there"));
  button->setToolTip(tr("Turn and scale about the middle of the part, about X, then Y, then Z, then shift it. Regions stay; its cage goes"));
  form->addRow(button);
  m_why = panel::words("place.why", "hint");
  m_why->hide();
  form->addRow(m_why);
  connect(button, &QPushButton::clicked, this, &PlaceFields::apply);
}

void PlaceFields::apply() {
  PartMove move;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    move.shift_W[static_cast<Eigen::Index>(axis)] = 1e-3 * m_shift[axis]->value();
    move.turn_deg[static_cast<Eigen::Index>(axis)] = m_turn[axis]->value();
  }
  move.scale = m_scale->value();
  QString why;
  movePart(m_document, m_part, move, &why);  // the panel is made anew when it was done
  m_why->setText(why);
  m_why->setVisible(!why.isEmpty());
}

}  // namespace glenoid
