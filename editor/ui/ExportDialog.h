// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QDialog>

#include "simcore/export/ExportJoint.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace glenoid {

/// Asks of which tetrahedra an export is, and how fine those of the part itself are.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ExportDialog(ExportFormat format, QWidget* parent = nullptr);

  /// What was chosen when the dialog was accepted; all parts.
  ExportWish wish() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void refresh();

  QLabel *m_text, *m_meshWord, *m_sizeWord, *m_distanceWord;
  QComboBox* m_mesh;
  QDoubleSpinBox *m_size, *m_distance;
};

}  // namespace glenoid
