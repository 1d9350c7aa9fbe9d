// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/lab/PicturePair.h"

#include <QGridLayout>
#include <QLabel>

#include "editor/ui/lab/PictureLabel.h"

namespace glenoid {

PicturePair::PicturePair(const QString& name, QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  for (int k = 0; k < 2; ++k) {
    m_pictures[k] = new PictureLabel;
    m_pictures[k]->setObjectName(name + (k ? QStringLiteral(".after") : QStringLiteral(".before")));
    m_pictures[k]->setMinimumHeight(140);
    m_words[k] = new QLabel;
    m_words[k]->setProperty("role", QStringLiteral("hint"));
    m_words[k]->setWordWrap(true);
    m_words[k]->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    grid->addWidget(m_pictures[k], 0, k);
    grid->addWidget(m_words[k], 1, k);
    grid->setColumnStretch(k, 1);
  }
  grid->setRowStretch(0, 1);
}

void PicturePair::setPictures(const QImage& left, const QImage& right) {
  m_pictures[0]->setPicture(left);
  m_pictures[1]->setPicture(right);
}

void PicturePair::setWords(const QString& left, const QString& right) {
  m_words[0]->setText(left);
  m_words[1]->setText(right);
  for (int k = 0; k < 2; ++k) m_pictures[k]->setAccessibleName(m_words[k]->text());
}

}  // namespace glenoid
