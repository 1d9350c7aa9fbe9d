// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/LoadFields.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QTimer>

#include "editor/core/PartName.h"
#include "editor/ui/PanelParts.h"

namespace glenoid {
namespace {

constexpr double kMost = 1e6;  // of the scenario's schema, SI
constexpr const char* kAxes[] = {"X", "Y", "Z"};

}  // namespace

LoadFields::LoadFields(Document& document, const std::string& part, bool& editing, QWidget* parent)
    : QGroupBox(parent), m_document(document), m_part(part), m_editing(editing) {
  setTitle(tr("Loads"));
  auto* form = new QFormLayout(this);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setRowWrapPolicy(QFormLayout::WrapAllRows);  // three numbers beside a label are wider than the panel
  const Scenario& scenario = m_document.scenario();
  if (m_part.empty()) showRise(*form);
  for (std::size_t i = 0; i < scenario.loads.size(); ++i)
    if (m_part.empty() || scenario.loads[i].part == m_part) showLoad(*form, static_cast<int>(i));
  if (m_part.empty()) return;
  QPushButton* add = panel::button("addLoad");
  add->setText(tr("Add a load"));
  // What is pressed goes with the old fields, so only once its event is over.
  connect(add, &QPushButton::clicked, this, [this] {
    QTimer::singleShot(0, &m_document, [&document = m_document, part = m_part] { addLoad(document, part); });
  });
  form->addRow(add);
}

void LoadFields::showRise(QFormLayout& form) {
  QDoubleSpinBox* rise = panel::field(QStringLiteral("loadRise"), 0, kMost, 3);
  rise->setValue(m_document.scenario().loadRise);
  rise->setAccessibleName(tr("Time in which loads rise"));
  rise->setToolTip(tr("Loads rise evenly from nothing over this time from the start; 0: they are whole at once"));
  connect(rise, &QDoubleSpinBox::valueChanged, this, [this, rise](double seconds) {
    const QScopedValueRollback guard(m_editing, true);
    if (setLoadRise(m_document, seconds)) return;
    const QSignalBlocker quiet(rise);
    rise->setValue(m_document.scenario().loadRise);
  });
  connect(rise, &QDoubleSpinBox::editingFinished, this, [this] { m_document.endGesture(); });
  form.addRow(tr("They rise over (s):"), rise);
}

void LoadFields::showLoad(QFormLayout& form, int index) {
  const Load& load = m_document.scenario().loads[index];
  const int part = findPart(m_document.joint(), load.part);
  const bool rigid = part >= 0 && m_document.joint().parts[part].kind == PartKind::Rigid;
  const QByteArray prefix = "load." + QByteArray::number(index);
  QLabel* title = panel::words(prefix + ".title", "hint");
  title->setText(tr("%1. On “%2”").arg(QString::number(index + 1), partName(m_document.joint(), load.part)));
  QPushButton* remove = panel::button(prefix + ".remove");
  remove->setText(tr("Remove"));
  remove->setAccessibleName(tr("Remove load %1").arg(index + 1));
  connect(remove, &QPushButton::clicked, this, [this, index] {
    QTimer::singleShot(0, &m_document, [&document = m_document, index] { removeLoad(document, index); });
  });
  auto* head = new QHBoxLayout;
  head->addWidget(title, 1);
  head->addWidget(remove);
  form.addRow(head);
  form.addRow(tr("Force (N):"), vectorRow(index, Vector::Force));
  if (rigid && (!m_part.empty() || !load.torque_W.isZero(0))) form.addRow(tr("Torque (N·m):"), vectorRow(index, Vector::Torque));
  if (load.point_W) {
    form.addRow(tr("Point (mm):"), vectorRow(index, Vector::Point));
  } else {
    QLabel* where = panel::words(prefix + ".where");
    where->setText(rigid ? tr("at the origin, as the part carries it") : tr("spread over the part as its weight is"));
    form.addRow(tr("Where:"), where);
  }
}

QWidget* LoadFields::vectorRow(int index, Vector which) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  for (int axis = 0; axis < 3; ++axis) layout->addWidget(component(index, which, axis));
  return row;
}

QDoubleSpinBox* LoadFields::component(int index, Vector which, int axis) {
  const auto of = [which](Load& load) -> Vec3& {
    switch (which) {
      case Vector::Torque: return load.torque_W;
      case Vector::Point: return *load.point_W;
      case Vector::Force: break;
    }
    return load.force_W;
  };
  // Of a number shown, SI.
  const double unit = which == Vector::Point ? 1e-3 : 1;
  const char* const word = which == Vector::Force ? "force" : which == Vector::Torque ? "torque" : "point";
  QDoubleSpinBox* box = panel::field(QStringLiteral("load.%1.%2.%3").arg(index).arg(QLatin1String(word), QString(QLatin1String(kAxes[axis])).toLower()),
                                     -kMost / unit, kMost / unit, which == Vector::Point ? 2 : 3);
  box->setMinimumWidth(60);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);  // keys and wheel do the same in less room
  Load load = m_document.scenario().loads[index];
  box->setValue(of(load)[axis] / unit);
  const QString words = which == Vector::Force    ? tr("Force of load %1 along %2")
                         : which == Vector::Torque ? tr("Torque of load %1 about %2")
                                                   : tr("Point of load %1 along %2");
  box->setAccessibleName(words.arg(index + 1).arg(QLatin1String(kAxes[axis])));
  box->setToolTip(box->accessibleName());
  connect(box, &QDoubleSpinBox::valueChanged, this, [=, this](double value) {
    // The other two keep every digit, of which the fields show few.
    Load now = m_document.scenario().loads[index];
    of(now)[axis] = value * unit;
    const QScopedValueRollback guard(m_editing, true);
    if (setLoad(m_document, index, now)) return;
    Load kept = m_document.scenario().loads[index];
    const QSignalBlocker quiet(box);
    box->setValue(of(kept)[axis] / unit);
  });
  connect(box, &QDoubleSpinBox::editingFinished, this, [this] { m_document.endGesture(); });
  return box;
}

}  // namespace glenoid
