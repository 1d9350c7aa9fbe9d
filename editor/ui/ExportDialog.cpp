// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/ExportDialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>

namespace glenoid {
namespace {

/// Millimetres; 0 means that the part decides.
QDoubleSpinBox* lengthField(const char* name) {
  auto* field = new QDoubleSpinBox;
  field->setObjectName(QLatin1String(name));
  field->setRange(0, 1000);
  field->setDecimals(3);
  field->setSingleStep(0.1);
  return field;
}

}  // namespace

ExportDialog::ExportDialog(ExportFormat format, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("exportDialog"));
  m_text = new QLabel;
  m_text->setWordWrap(true);
  m_mesh = new QComboBox;
  m_mesh->setObjectName(QStringLiteral("exportMesh"));
  for (const ExportMesh mesh : kExportMeshes) m_mesh->addItem(QString(), static_cast<int>(mesh));
  m_mesh->setCurrentIndex(m_mesh->findData(static_cast<int>(usualMesh(format))));
  m_size = lengthField("exportSize");
  m_distance = lengthField("exportDistance");
  m_meshWord = new QLabel;
  m_sizeWord = new QLabel;
  m_distanceWord = new QLabel;
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  auto* layout = new QFormLayout(this);
  layout->addRow(m_text);
  layout->addRow(m_meshWord, m_mesh);
  layout->addRow(m_sizeWord, m_size);
  layout->addRow(m_distanceWord, m_distance);
  layout->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_mesh, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
  retranslate();
  refresh();
}

ExportWish ExportDialog::wish() const {
  ExportWish wish;
  wish.mesh = static_cast<ExportMesh>(m_mesh->currentData().toInt());
  if (wish.mesh == ExportMesh::Conforming) wish.size = {1e-3 * m_size->value(), 1e-3 * m_distance->value()};
  return wish;
}

void ExportDialog::refresh() {
  const bool own = m_mesh->currentData().toInt() == static_cast<int>(ExportMesh::Conforming);
  for (QWidget* each : {static_cast<QWidget*>(m_size), static_cast<QWidget*>(m_distance)}) each->setEnabled(own);
}

void ExportDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

void ExportDialog::retranslate() {
  setWindowTitle(tr("Export"));
  m_text->setText(tr("The cells of the simulation stand out of the part and are several times its volume. For another solver, write tetrahedra of the part itself."));
  m_meshWord->setText(tr("Tetrahedra"));
  m_mesh->setItemText(0, tr("Of the simulation's cells"));
  m_mesh->setItemText(1, tr("Of the part itself"));
  m_sizeWord->setText(tr("Length of their edges"));
  m_distanceWord->setText(tr("Largest distance from the surface"));
  m_size->setSpecialValueText(tr("two thirds of the part's thickness"));
  m_distance->setSpecialValueText(tr("a tenth of the edges"));
  for (QDoubleSpinBox* field : {m_size, m_distance}) field->setSuffix(tr(" mm"));
}

}  // namespace glenoid
