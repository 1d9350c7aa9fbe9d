// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <map>

#include "editor/core/PlayLink.h"
#include "editor/lab/StepSeries.h"

class QLabel;
class QTableWidget;

namespace glenoid {

class StageBars;
class TimesPlot;

/// Only the effects a scene calls for: what a step takes by stage beside its budget, each effect with its switch and its price, the groups
/// that are solved as one, and how times went over the last minutes. While it is not seen nothing is measured for it.
class EffectsPanel : public QWidget {
  Q_OBJECT
 public:
  EffectsPanel(Document& document, PlayLink& link, QWidget* parent = nullptr);
  const StepSeries& series() const { return m_series; }
  /// Whether somebody sees it.
  void setWatched(bool watched);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void look();
  void retranslate();
  void makeRows();
  void fillEffects();
  void fillIslands(const StepMeter::Reading& reading);

  Document& m_document;
  PlayLink& m_link;
  StepSeries m_series;
  std::map<std::string, double> m_lastMs;  ///< of effects that are off now, when they were on
  StageBars* m_bars;
  TimesPlot* m_times;
  QLabel *m_summary, *m_effectsTitle, *m_islandsTitle;
  QTableWidget *m_effects, *m_islands;
  bool m_watched = false;
  QTimer m_timer;
  QElapsedTimer m_clock;
};

}  // namespace glenoid
