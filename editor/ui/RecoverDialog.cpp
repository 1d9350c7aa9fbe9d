// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/RecoverDialog.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace glenoid {
namespace {

constexpr int kSessionRole = Qt::UserRole, kGenerationRole = Qt::UserRole + 1;

}  // namespace

RecoverDialog::RecoverDialog(std::vector<AbandonedSession> sessions, QWidget* parent)
    : QDialog(parent), m_sessions(std::move(sessions)) {
  setObjectName(QStringLiteral("recoverDialog"));
  m_text = new QLabel;
  m_text->setWordWrap(true);
  m_list = new QTreeWidget;
  m_list->setObjectName(QStringLiteral("recoverList"));
  m_list->setColumnCount(3);
  m_list->setUniformRowHeights(true);
  m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  for (std::size_t s = 0; s < m_sessions.size(); ++s) {
    QTreeWidgetItem* newest = nullptr;
    for (std::size_t g = 0; g < m_sessions[s].generations.size(); ++g) {
      auto* item = newest ? new QTreeWidgetItem(newest) : new QTreeWidgetItem(m_list);
      if (!newest) newest = item;  // older ones of the same scene hang below
      item->setData(0, kSessionRole, static_cast<int>(s));
      item->setData(0, kGenerationRole, static_cast<int>(g));
    }
  }
  auto* buttons = new QDialogButtonBox;
  m_recover = buttons->addButton(QString(), QDialogButtonBox::AcceptRole);
  m_later = buttons->addButton(QString(), QDialogButtonBox::RejectRole);
  m_remove = buttons->addButton(QString(), QDialogButtonBox::DestructiveRole);
  m_recover->setObjectName(QStringLiteral("recover"));
  m_later->setObjectName(QStringLiteral("decline"));
  m_remove->setObjectName(QStringLiteral("removeCopies"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_text);
  layout->addWidget(m_list, 1);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_remove, &QPushButton::clicked, this, &RecoverDialog::removeChosen);
  connect(m_list, &QTreeWidget::currentItemChanged, this, &RecoverDialog::refresh);
  connect(m_list, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);
  m_list->setCurrentItem(m_list->topLevelItem(0));
  retranslate();
  resize(680, 360);
}

const AbandonedSession* RecoverDialog::chosenSession() const {
  const QTreeWidgetItem* item = m_list->currentItem();
  return item ? &m_sessions[item->data(0, kSessionRole).toInt()] : nullptr;
}

const Generation* RecoverDialog::chosen() const {
  const AbandonedSession* session = chosenSession();
  return session ? &session->generations[m_list->currentItem()->data(0, kGenerationRole).toInt()] : nullptr;
}

void RecoverDialog::refresh() {
  m_recover->setEnabled(chosen() != nullptr);
  m_remove->setEnabled(chosen() != nullptr);
}

void RecoverDialog::removeChosen() {
  const AbandonedSession* session = chosenSession();
  if (!session) return;
  const auto answer = QMessageBox::question(this, tr("Remove the safety copies"),
                                            tr("Remove every safety copy of this scene? This cannot be undone."),
                                            QMessageBox::Yes | QMessageBox::Cancel, QMessageBox::Cancel);
  if (answer != QMessageBox::Yes) return;
  removeSession(session->folder);
  QTreeWidgetItem* item = m_list->currentItem();
  while (item->parent()) item = item->parent();
  delete item;
  refresh();
  if (m_list->topLevelItemCount() == 0) reject();
}

void RecoverDialog::retranslate() {
  setWindowTitle(tr("Recover unsaved work"));
  m_text->setText(tr("These scenes had changes that were not saved when the program ended. Your own files are as you last "
                     "saved them. Whatever you do not recover now can be found again under File > Recover."));
  m_list->setAccessibleName(tr("Scenes that can be recovered"));
  m_list->setHeaderLabels({tr("Saved"), tr("Scene"), tr("Opened from")});
  m_recover->setText(tr("&Recover"));
  m_later->setText(tr("&Not now"));
  m_remove->setText(tr("Remove &copies"));
  for (QTreeWidgetItemIterator it(m_list); *it; ++it) {
    const Generation& generation =
        m_sessions[(*it)->data(0, kSessionRole).toInt()].generations[(*it)->data(0, kGenerationRole).toInt()];
    (*it)->setText(0, QLocale().toString(generation.saved.toLocalTime(), tr("yyyy-MM-dd HH:mm:ss")));
    (*it)->setText(1, generation.name.isEmpty() ? tr("Without a name") : generation.name);
    (*it)->setText(2, generation.origin.isEmpty() ? tr("New scene") : generation.origin);
  }
  refresh();
}

void RecoverDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

}  // namespace glenoid
