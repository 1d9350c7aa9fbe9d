// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QImage>
#include <QWidget>

class QLabel;

namespace glenoid {

class PictureLabel;

/// Two pictures side by side, each with words below it.
class PicturePair : public QWidget {
  Q_OBJECT
 public:
  explicit PicturePair(const QString& name, QWidget* parent = nullptr);
  void setPictures(const QImage& left, const QImage& right);
  void setWords(const QString& left, const QString& right);

 private:
  PictureLabel* m_pictures[2];
  QLabel* m_words[2];
};

}  // namespace glenoid
