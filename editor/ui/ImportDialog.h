// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QDialog>

#include "editor/core/ImportSession.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace glenoid {

class ImportPicture;

/// What arrived from files, what is wrong with it and what will be done about it, before anything reaches the document:
/// a table of surfaces, the findings of the one that is chosen with a box for each repair, its picture, its unit and
/// axes. "Import" adds all that are wanted as one undo step. Texts are made once: it is modal and short-lived.
class ImportDialog : public QDialog {
  Q_OBJECT
 public:
  ImportDialog(Document& document, const QStringList& files, QWidget* parent = nullptr);

  ImportSession& session() { return m_session; }
  void addFiles(const QStringList& files) { m_session.add(files); }

 signals:
  void imported(const QStringList& parts);  ///< ids

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* makeTable();
  QWidget* makeDetails();
  QWidget* makeWishes();
  void refreshTable();
  void refreshRow(int row);
  void refreshDetails();
  void refreshFindings();
  void refreshMarks();
  void refreshState();
  void takeFindings(QTreeWidgetItem* item);
  void wishAxes();
  void accept() override;
  void reject() override;
  int chosen() const;

  Document& m_document;
  ImportSession m_session;
  bool m_filling = false;  ///< fields are being set by the program
  QTreeWidget *m_table = nullptr, *m_findings = nullptr;
  ImportPicture* m_picture = nullptr;
  QCheckBox *m_showResult = nullptr, *m_mirror = nullptr;
  QLabel *m_notes = nullptr, *m_unitReason = nullptr, *m_size = nullptr, *m_state = nullptr;
  QComboBox *m_unit = nullptr, *m_axes = nullptr;
  QDoubleSpinBox* m_thin = nullptr;
  std::array<QDoubleSpinBox*, 3> m_shift{};
  QPushButton *m_forAll = nullptr, *m_import = nullptr, *m_stop = nullptr;
  QProgressBar* m_progress = nullptr;
};

}  // namespace glenoid
