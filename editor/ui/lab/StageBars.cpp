// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/lab/StageBars.h"

#include <algorithm>
#include <cmath>

#include "editor/lab/EffectPrices.h"
#include "editor/lab/SettingWords.h"
#include "editor/ui/Theme.h"
#include "editor/ui/lab/PlotStyle.h"

namespace glenoid {
namespace {

constexpr int kBars = kStageCount + 1;  // the whole step at the top

bool isFar(double budget, double most) { return budget > 4 * most && most > 0; }

}  // namespace

StageBars::StageBars(QWidget* parent) : QCustomPlot(parent) {
  setObjectName(QStringLiteral("lab.effects.stages"));
  setMinimumHeight(220);
  m_bars = new QCPBars(yAxis, xAxis);  // they lie
  m_bars->setWidth(0.7);
  m_whiskers = new QCPErrorBars(yAxis, xAxis);
  m_whiskers->setDataPlottable(m_bars);
  m_whiskers->setErrorType(QCPErrorBars::etValueError);
  m_whiskers->setSymbolGap(0);
  yAxis->setRange(-0.6, kBars - 0.4);
  yAxis->setTickLength(0, 0);
  yAxis->setSubTicks(false);
  yAxis->grid()->setVisible(false);
  restyle();
  retranslate();
}

void StageBars::restyle() {
  styleAxes(*this);
  QColor accent = currentTheme().color(QStringLiteral("accent"));
  m_bars->setPen(Qt::NoPen);
  m_bars->setBrush(accent);
  m_whiskers->setPen(QPen(currentTheme().color(QStringLiteral("text")), 1.2));
}

void StageBars::retranslate() {
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (int s = 0; s < kStageCount; ++s) ticker->addTick(kBars - 2 - s, stageWords(static_cast<Stage>(s)));
  ticker->addTick(kBars - 1, tr("Whole step"));
  yAxis->setTicker(ticker);
  xAxis->setLabel(tr("Thread time of a step, ms: median, whisker up to 95 of 100"));
  setAccessibleName(tr("Time of a step by stage"));
  replot(rpQueuedReplot);
}

void StageBars::show(const StepSeries& series, double budgetMs) {
  QVector<double> keys, medians, up;
  double most = 0;
  const auto add = [&](double key, const StepSeries::Figures& figures) {
    if (!std::isfinite(figures.p50)) return;
    keys << key;
    medians << figures.p50;
    up << figures.p95 - figures.p50;
    most = std::max(most, figures.p95);
  };
  for (int s = kStageCount - 1; s >= 0; --s) add(kBars - 2 - s, series.stages({static_cast<Stage>(s)}));  // from below: whiskers go by the order
  add(kBars - 1, series.step());
  m_bars->setData(keys, medians);
  m_whiskers->setData(QVector<double>(up.size(), 0.0), up);
  // Grows at once and shrinks only where much room is left, so that bars do not jump about.
  const double wanted = isFar(budgetMs, most) ? 1.3 * most : std::max(1.15 * budgetMs, 1.1 * most);
  if (wanted > m_range || wanted < 0.6 * m_range) m_range = wanted;
  xAxis->setRange(0, std::max(1e-3, m_range));
  clearItems();
  if (budgetMs < m_range) {
    addLevel(*this, budgetMs, tr("budget: %1").arg(msText(budgetMs)), true);
  } else {
    auto* text = new QCPItemText(this);
    text->setSelectable(false);
    text->setText(tr("budget: %1, to the right of this →").arg(msText(budgetMs)));
    text->setColor(currentTheme().color(QStringLiteral("muted")));
    text->setFont(font());
    text->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
    text->position->setType(QCPItemPosition::ptAxisRectRatio);
    text->position->setCoords(0.99, 0.98);
  }
  replot(rpQueuedReplot);
}

void StageBars::changeEvent(QEvent* event) {
  QCustomPlot::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) restyle();
}

TimesPlot::TimesPlot(QWidget* parent) : QCustomPlot(parent) {
  setObjectName(QStringLiteral("lab.effects.times"));
  setMinimumHeight(140);
  m_p50 = addGraph();
  m_p95 = addGraph();
  legend->setVisible(true);
  axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignBottom | Qt::AlignLeft);
  restyle();
  retranslate();
}

void TimesPlot::restyle() {
  styleAxes(*this);
  m_p50->setPen(QPen(seriesColour(0), 1.8));
  m_p95->setPen(QPen(seriesColour(1), 1.4));
  for (QCPGraph* graph : {m_p50, m_p95}) graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 3));
  QColor behind = currentTheme().color(QStringLiteral("base"));
  behind.setAlpha(200);
  legend->setBrush(behind);
  legend->setBorderPen(Qt::NoPen);
  legend->setTextColor(currentTheme().color(QStringLiteral("text")));
  legend->setFont(font());
}

void TimesPlot::retranslate() {
  m_p50->setName(tr("half of the steps stay below"));
  m_p95->setName(tr("95 of 100 stay below"));
  xAxis->setLabel(tr("Time, s before now"));
  yAxis->setLabel(tr("ms a step"));
  setAccessibleName(tr("Time of a step over the last two minutes"));
  replot(rpQueuedReplot);
}

void TimesPlot::show(const StepSeries& series, double budgetMs, double now) {
  QVector<double> at, p50, p95;
  double most = 0;
  for (const StepSeries::Moment& moment : series.moments()) {
    at << moment.at - now;
    p50 << moment.p50;  // NaN: a gap
    p95 << moment.p95;
    if (std::isfinite(moment.p95)) most = std::max(most, moment.p95);
  }
  m_p50->setData(at, p50, true);
  m_p95->setData(at, p95, true);
  xAxis->setRange(-StepSeries::kKept, 0);
  clearItems();
  const bool far = isFar(budgetMs, most);
  yAxis->setRange(0, std::max(1e-3, far ? 1.5 * most : std::max(1.2 * budgetMs, 1.1 * most)));
  if (!far) addLevel(*this, budgetMs, tr("budget: %1").arg(msText(budgetMs)));
  replot(rpQueuedReplot);
}

void TimesPlot::changeEvent(QEvent* event) {
  QCustomPlot::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) restyle();
}

}  // namespace glenoid
