// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/FieldPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "editor/core/FieldText.h"
#include "editor/ui/PanelParts.h"

namespace glenoid {
namespace {
constexpr double kMost = 1e9;  // in the unit shown
}  // namespace

FieldPanel::FieldPanel(FieldView& field, QWidget* parent) : QWidget(parent), m_field(field) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 0, 8, 8);
  grid->setSpacing(4);
  m_title = new QLabel;
  m_quantity = new QComboBox;
  m_quantity->setObjectName(QStringLiteral("field.quantity"));
  m_quantity->addItem(QString());
  for (std::size_t i = 0; i < std::size(kQuantities); ++i) m_quantity->addItem(QString());
  m_title->setBuddy(m_quantity);
  m_automatic = new QCheckBox;
  m_automatic->setObjectName(QStringLiteral("field.automatic"));
  m_low = panel::field(QStringLiteral("field.low"), -kMost, kMost, 2);
  m_high = panel::field(QStringLiteral("field.high"), -kMost, kMost, 2);
  m_unit = new QLabel;
  m_unit->setObjectName(QStringLiteral("field.unit"));
  grid->addWidget(m_title, 0, 0);
  grid->addWidget(m_quantity, 0, 1);
  grid->addWidget(m_automatic, 1, 0, 1, 2);
  auto* ends = new QHBoxLayout;
  ends->addWidget(m_low, 1);
  ends->addWidget(new QLabel(QStringLiteral("–")));
  ends->addWidget(m_high, 1);
  ends->addWidget(m_unit);
  grid->addLayout(ends, 2, 0, 1, 2);
  grid->setColumnStretch(1, 1);
  connect(m_quantity, &QComboBox::activated, this,
          [this](int row) { m_field.show(row > 0 ? std::optional(kQuantities[row - 1]) : std::nullopt); });
  connect(m_automatic, &QCheckBox::clicked, this, [this](bool on) { on ? m_field.setAutomatic() : m_field.setRange(m_field.range()); });
  for (QDoubleSpinBox* end : {m_low, m_high}) connect(end, &QDoubleSpinBox::valueChanged, this, [this] { takeRange(); });
  // The scale may change while the view draws: no widget does then.
  connect(&field, &FieldView::rangeChanged, this, &FieldPanel::refresh, Qt::QueuedConnection);
  retranslate();
}

void FieldPanel::takeRange() { m_field.setRange({m_low->value() * m_si, m_high->value() * m_si}); }

void FieldPanel::refresh() {
  const auto quantity = m_field.quantity();
  const FieldRange& range = m_field.range();
  m_quantity->setCurrentIndex(quantity ? 1 + static_cast<int>(*quantity) : 0);
  m_automatic->setChecked(m_field.isAutomatic());
  for (QWidget* each : {static_cast<QWidget*>(m_automatic), static_cast<QWidget*>(m_low), static_cast<QWidget*>(m_high)})
    each->setEnabled(quantity.has_value());
  const FieldUnit unit = fieldUnit(quantity.value_or(Quantity::Stress), std::max(std::abs(range.low), std::abs(range.high)));
  m_si = unit.si;
  m_unit->setText(quantity ? unit.word : QString());
  const QSignalBlocker quietLow(m_low), quietHigh(m_high);
  m_low->setValue(quantity ? range.low / m_si : 0);
  m_high->setValue(quantity ? range.high / m_si : 0);
}

void FieldPanel::retranslate() {
  m_title->setText(tr("&Colours by"));
  m_quantity->setItemText(0, tr("Off"));
  for (const Quantity quantity : kQuantities) m_quantity->setItemText(1 + static_cast<int>(quantity), quantityLabel(quantity));
  m_quantity->setAccessibleName(tr("What colours the parts"));
  m_quantity->setToolTip(tr("Colour the parts by what they bear; point at one to read its value"));
  m_automatic->setText(tr("Automatic scale"));
  m_automatic->setToolTip(tr("The scale follows the values, in round steps; without it, it stays as it is"));
  m_low->setAccessibleName(tr("Low end of the scale"));
  m_high->setAccessibleName(tr("High end of the scale"));
  refresh();
}

void FieldPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace glenoid
