// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/NoticeStrip.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <algorithm>

#include "editor/core/NoticeSentences.h"

namespace glenoid {
namespace {

/// The same thing said again, perhaps with another figure.
bool sameMatter(const Notice& a, const Notice& b) {
  return a.kind == b.kind && a.subject == b.subject && a.other == b.other;
}

}  // namespace

NoticeStrip::NoticeStrip(const Document& document, const PlayLink& link, QWidget* parent)
    : QWidget(parent), m_document(document), m_link(link) {
  setProperty("role", QStringLiteral("banner"));
  setAttribute(Qt::WA_StyledBackground);
  m_words = new QLabel;
  m_words->setObjectName(QStringLiteral("notice"));
  m_words->setWordWrap(true);
  m_words->setTextFormat(Qt::PlainText);
  m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_all = new QPushButton;
  m_all->setObjectName(QStringLiteral("allNotices"));
  m_close = new QToolButton;
  m_close->setObjectName(QStringLiteral("closeNotice"));
  m_close->setText(QStringLiteral("✕"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 6, 4, 6);
  row->addWidget(m_words, 1);
  row->addWidget(m_all);
  row->addWidget(m_close);
  connect(m_all, &QPushButton::clicked, this, &NoticeStrip::allWanted);
  connect(m_close, &QToolButton::clicked, this, &NoticeStrip::close);
  connect(&link, &PlayLink::noticesChanged, this, &NoticeStrip::refresh);
  refresh();
}

void NoticeStrip::close() {
  m_closed = m_link.notices();
  refresh();
}

void NoticeStrip::refresh() {
  const std::vector<Notice>& notices = m_link.notices();
  const bool news = std::any_of(notices.begin(), notices.end(), [this](const Notice& notice) {
    return std::none_of(m_closed.begin(), m_closed.end(), [&](const Notice& closed) { return sameMatter(closed, notice); });
  });
  if (news || notices.empty()) m_closed.clear();
  setVisible(news);
  m_all->setToolTip(tr("Show everything that is to be said about this run in the list of problems"));
  m_all->setAccessibleName(m_all->toolTip());
  m_close->setAccessibleName(tr("Close the notice"));
  m_close->setToolTip(tr("Close the notice"));
  if (!news) return;
  const QString role = isGrave(notices[0].kind) ? QStringLiteral("graveNotice") : QStringLiteral("notice");
  if (m_words->property("role") != role) {
    m_words->setProperty("role", role);
    style()->unpolish(m_words);  // the style sheet looks at a role only once
    style()->polish(m_words);
  }
  m_words->setText(sentenceOf(notices[0], namesIn(m_document.joint(), m_document.scenario())));
  m_all->setVisible(notices.size() > 1);
  m_all->setText(tr("%n more", nullptr, static_cast<int>(notices.size()) - 1));
}

void NoticeStrip::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) refresh();
  QWidget::changeEvent(event);
}

}  // namespace glenoid
