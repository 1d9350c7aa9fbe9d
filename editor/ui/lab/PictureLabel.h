// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QImage>
#include <QWidget>

namespace glenoid {

/// One picture, as large as there is room and never distorted; nothing where there is none.
class PictureLabel : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  void setPicture(const QImage& image) {
    m_image = image;
    update();
  }
  bool isEmpty() const { return m_image.isNull(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage m_image;
};

}  // namespace glenoid
