// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/lab/PictureLabel.h"

#include <QPainter>

namespace glenoid {

void PictureLabel::paintEvent(QPaintEvent*) {
  if (m_image.isNull()) return;
  const QSizeF size = QSizeF(m_image.size()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRectF(QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())), size), m_image);
}

}  // namespace glenoid
