// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/lab/EffectsPanel.h"

#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "editor/core/Sentences.h"
#include "editor/lab/EffectPrices.h"
#include "editor/lab/IslandRows.h"
#include "editor/lab/SettingWords.h"
#include "editor/ui/PanelParts.h"
#include "editor/ui/Theme.h"
#include "editor/ui/lab/StageBars.h"

namespace glenoid {
namespace {

constexpr Wish kWishes[] = {Wish::Auto, Wish::On, Wish::Off};
enum EffectColumn { kEffect, kSwitch, kState, kPrice, kEffectColumns };
enum IslandColumn { kMembers, kSize, kMs, kResidual, kWhy, kMethod, kIslandColumns };

QTableWidget* table(const char* name, int columns) {
  auto* made = new QTableWidget(0, columns);
  made->setObjectName(QLatin1String(name));
  made->setEditTriggers(QAbstractItemView::NoEditTriggers);
  made->setSelectionBehavior(QAbstractItemView::SelectRows);
  made->setTabKeyNavigation(false);
  made->verticalHeader()->hide();
  made->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  made->setAlternatingRowColors(true);
  return made;
}

void put(QTableWidget* table, int row, int column, const QString& text, bool right = false) {
  QTableWidgetItem* item = table->item(row, column);
  if (!item) {
    item = new QTableWidgetItem;
    if (right) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table->setItem(row, column, item);
  }
  if (item->text() == text) return;
  item->setText(text);
  item->setToolTip(text);
}

}  // namespace

EffectsPanel::EffectsPanel(Document& document, PlayLink& link, QWidget* parent) : QWidget(parent), m_document(document), m_link(link) {
  m_summary = panel::words("lab.effects.summary", "title");
  m_bars = new StageBars;
  m_times = new TimesPlot;
  m_effectsTitle = panel::words("lab.effects.title", "hint");
  m_islandsTitle = panel::words("lab.effects.islandsTitle", "hint");
  m_effects = table("lab.effects.table", kEffectColumns);
  m_islands = table("lab.effects.islands", kIslandColumns);
  const auto titled = [](QWidget* title, QWidget* content) {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    column->addWidget(title);
    column->addWidget(content, 1);
    return box;
  };
  auto* splitter = new QSplitter(Qt::Vertical);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(m_bars);
  splitter->addWidget(titled(m_effectsTitle, m_effects));
  splitter->addWidget(titled(m_islandsTitle, m_islands));
  splitter->addWidget(m_times);
  splitter->setSizes({270, 230, 140, 160});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(m_summary);
  layout->addWidget(splitter, 1);
  m_timer.setInterval(250);
  m_clock.start();
  connect(&m_timer, &QTimer::timeout, this, &EffectsPanel::look);
  connect(&document, &Document::changed, this, [this](const ChangeSet& changes) {
    if (changes.everything) {
      m_series.clear();
      m_lastMs.clear();
    }
    if (m_watched) fillEffects();
  });
  makeRows();
  retranslate();
}

void EffectsPanel::makeRows() {
  const Model* model = m_link.snapshot().model.get();
  const int count = model ? static_cast<int>(model->effects.size()) : 0;
  if (m_effects->rowCount() == count) return;
  m_effects->setRowCount(count);
  for (int row = 0; row < count; ++row) {
    const std::string name = model->effects[static_cast<std::size_t>(row)].name;
    auto* choice = new QComboBox;
    choice->setObjectName(QStringLiteral("lab.effect.") + QString::fromStdString(name));
    choice->setFocusPolicy(Qt::StrongFocus);
    choice->addItems({tr("by the scene"), tr("on"), tr("off")});
    connect(choice, &QComboBox::activated, this, [this, name](int wish) { setEffect(m_document, name, kWishes[wish]); });
    m_effects->setCellWidget(row, kSwitch, choice);
  }
}

void EffectsPanel::setWatched(bool watched) {
  m_watched = watched;
  m_link.meter().setWanted(watched);
  if (!watched) return m_timer.stop();
  m_timer.start();
  look();
}

void EffectsPanel::look() {
  const StepMeter::Reading reading = m_link.meter().take();
  const double now = 1e-3 * static_cast<double>(m_clock.elapsed());
  m_series.add(now, reading);
  const Model* model = m_link.snapshot().model.get();
  const double budget = model ? 1e3 * model->scenario.dt : 5;
  const StepSeries::Figures step = m_series.step();
  m_summary->setText(!model                     ? tr("No scene runs.")
                     : std::isfinite(step.p50) ? tr("A step takes %1, and %2 at most in 95 of 100; it simulates %3.").arg(msText(step.p50), msText(step.p95), msText(budget))
                                               : tr("Press play to see what each stage and effect takes."));
  m_times->show(m_series, budget, now);
  if (m_series.hasSteps() || !reading.steps.empty()) m_bars->show(m_series, budget);
  fillEffects();
  if (reading.model) fillIslands(reading);
}

void EffectsPanel::fillEffects() {
  const Model* model = m_link.snapshot().model.get();
  if (!model) return;
  makeRows();
  const std::vector<EffectPrice> prices = effectPrices(*model, m_document.scenario().effects, m_series);
  for (std::size_t k = 0; k < prices.size(); ++k) {
    const EffectPrice& price = prices[k];
    const int row = static_cast<int>(k);
    put(m_effects, row, kEffect, effectName(price.name));
    put(m_effects, row, kState, (price.on ? tr("on: %1") : tr("off: %1")).arg(price.reason));
    QString words = priceText(price);
    if (price.on && std::isfinite(price.ms.p50)) m_lastMs[price.name] = price.ms.p50;
    if (const auto last = m_lastMs.find(price.name); !price.on && last != m_lastMs.end()) words = tr("off: nothing (%1 when it was on)").arg(msText(last->second));
    put(m_effects, row, kPrice, words);
    if (auto* choice = qobject_cast<QComboBox*>(m_effects->cellWidget(row, kSwitch))) {
      const QSignalBlocker quiet(choice);
      choice->setCurrentIndex(static_cast<int>(std::find(std::begin(kWishes), std::end(kWishes), price.wish) - std::begin(kWishes)));
      choice->setAccessibleName(tr("Whether this effect is on: %1").arg(effectName(price.name)));
    }
  }
}

void EffectsPanel::fillIslands(const StepMeter::Reading& reading) {
  const std::vector<IslandRow> rows = islandRows(*reading.model, reading.islands);
  m_islands->setRowCount(static_cast<int>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const IslandRow& island = rows[k];
    const int row = static_cast<int>(k);
    put(m_islands, row, kMembers, island.members);
    put(m_islands, row, kSize, island.rows > 0 ? tr("%1 velocities, %2 rows").arg(island.unknowns).arg(island.rows) : tr("%1 velocities").arg(island.unknowns));
    put(m_islands, row, kMs, msText(island.ms), true);
    put(m_islands, row, kResidual, std::isfinite(island.residual) ? QLocale().toString(island.residual, 'e', 1) : QStringLiteral("–"), true);
    put(m_islands, row, kWhy, island.why);
    put(m_islands, row, kMethod, island.method);
  }
}

void EffectsPanel::retranslate() {
  m_effectsTitle->setText(tr("Effects: what is on, why, and what it costs"));
  m_islandsTitle->setText(tr("Islands of the last step: what is solved as one, and what joins it"));
  m_effects->setHorizontalHeaderLabels({tr("Effect"), tr("Switch"), tr("State"), tr("Price of a step")});
  m_effects->setAccessibleName(tr("Effects with their price"));
  m_effects->setColumnWidth(kEffect, 130);
  m_effects->setColumnWidth(kSwitch, 110);
  m_effects->setColumnWidth(kState, 190);
  m_effects->horizontalHeader()->setStretchLastSection(true);
  m_islands->setHorizontalHeaderLabels({tr("Parts"), tr("Size"), tr("Time"), tr("Residual"), tr("Why joined"), tr("Solved by")});
  m_islands->setAccessibleName(tr("Islands"));
  m_islands->setColumnWidth(kMembers, 170);
  m_islands->setColumnWidth(kSize, 150);
  m_islands->setColumnWidth(kMs, 70);
  m_islands->setColumnWidth(kResidual, 70);
  m_islands->setColumnWidth(kWhy, 260);
  m_effects->setRowCount(0);  // the switches' words
  if (m_watched) look();
}

void EffectsPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace glenoid
