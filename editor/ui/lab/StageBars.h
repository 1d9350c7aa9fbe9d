// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <qcustomplot.h>

#include "editor/lab/StepSeries.h"

namespace glenoid {

/// What a step takes, bar by bar: the whole and each stage, median with a whisker up to what 95 of 100 steps stay below, and the budget: the
/// time that a step simulates.
class StageBars : public QCustomPlot {
  Q_OBJECT
 public:
  explicit StageBars(QWidget* parent = nullptr);
  void show(const StepSeries& series, double budgetMs);
  void restyle();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();

  QCPBars* m_bars;
  QCPErrorBars* m_whiskers;
  double m_budget = 5, m_range = 0;
};

/// p50 and p95 of a step over the last two minutes, with the budget. Where nothing ran there is a gap.
class TimesPlot : public QCustomPlot {
  Q_OBJECT
 public:
  explicit TimesPlot(QWidget* parent = nullptr);
  void show(const StepSeries& series, double budgetMs, double now);
  void restyle();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();

  QCPGraph *m_p50, *m_p95;
};

}  // namespace glenoid
