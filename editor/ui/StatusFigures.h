// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QTimer>
#include <QWidget>
#include <array>

#include "editor/core/PlayLink.h"

class QLabel;

namespace glenoid {

/// The figures at the right of the status bar: simulated time, speed, time of a step, contacts, islands, frames.
/// Refreshed five times a second, since nobody reads faster.
class StatusFigures : public QWidget {
  Q_OBJECT
 public:
  explicit StatusFigures(PlayLink& link, QWidget* parent = nullptr);
  void setFramesPerSecond(std::function<double()> source) { m_fps = std::move(source); }
  void refresh();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void reserveWidths();
  enum Figure { Time, Speed, Rate, StepTime, Contacts, Islands, Frames, kCount };
  PlayLink& m_link;
  std::function<double()> m_fps;
  std::array<QLabel*, kCount> m_labels{};
  QTimer m_timer;
};

}  // namespace glenoid
