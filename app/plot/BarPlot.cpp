// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plot/BarPlot.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/plot/LogLogPlot.h"
#include "app/plot/PlotAxis.h"

namespace glenoid {
namespace {

// Okabe and Ito's colours, as in the other plots.
const QColor kBars[] = {QColor(160, 160, 160), QColor(0, 114, 178), QColor(230, 159, 0), QColor(0, 158, 115)};
const QColor kWords(30, 30, 30), kGrid(225, 225, 225);

QFont plotFont(double size, bool bold = false) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(size));
  font.setBold(bold);
  font.setStyleStrategy(QFont::PreferNoShaping);  // ligatures could not be searched for in a PDF
  return font;
}

QString said(const std::string& words) {
  return QString::fromStdString(words);
}

double mostOf(const BarPlot& plot) {
  double most = 0;
  for (const PlotBarGroup& group : plot.groups)
    for (const PlotBar& bar : group.bars)
      for (const double value : {bar.value, bar.upTo})
        if (std::isfinite(value)) most = std::max(most, value);
  return most > 0 ? most : 1;
}

void drawHeads(QPainter& painter, const BarPlot& plot, double& y) {
  painter.setPen(kWords);
  painter.setFont(plotFont(21, true));
  painter.drawText(QPointF(24, y += 30), said(plot.title));
  painter.setFont(plotFont(13));
  for (const std::string& line : plot.subtitle) painter.drawText(QPointF(24, y += 18), said(line));
  double x = 30;
  y += 28;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    painter.fillRect(QRectF(x - 8, y - 11, 16, 13), kBars[k % std::size(kBars)]);
    painter.setPen(kWords);
    painter.drawText(QPointF(x + 13, y), said(plot.series[k]));
    x += 40 + QFontMetricsF(painter.font()).horizontalAdvance(said(plot.series[k]));
  }
}

void drawScale(QPainter& painter, const BarPlot& plot, const QRectF& area, double most) {
  painter.setFont(plotFont(13));
  const double step = evenTick(most);
  for (int k = 0; k * step <= most * (1 + 1e-9); ++k) {
    const double x = area.left() + area.width() * k * step / most;
    painter.setPen(QPen(kGrid, 1));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(kWords);
    painter.drawText(QRectF(x - 50, area.bottom() + 4, 100, 20), Qt::AlignCenter, said(k == 0 ? std::string("0") : axisNumber(k * step)));
  }
  for (const BarPlot::Level& level : plot.levels) {
    if (level.x > most) continue;
    const double x = area.left() + area.width() * level.x / most;
    painter.setPen(QPen(QColor(120, 120, 120), 1.2, Qt::DashDotLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(QColor(80, 80, 80));
    painter.drawText(QPointF(x + 4, area.top() - 6), said(level.label));
  }
  painter.setPen(kWords);
  painter.setFont(plotFont(14, true));
  painter.drawText(QRectF(area.left(), area.bottom() + 26, area.width(), 22), Qt::AlignCenter,
                   said(plot.xTitle));
  painter.drawText(QPointF(area.right() + 16, area.top() - 6), said(plot.notesTitle));
}

void drawGroup(QPainter& painter, const PlotBarGroup& group, const QRectF& row, const QRectF& area,
               double most) {
  painter.setPen(kWords);
  painter.setFont(plotFont(14, true));
  painter.drawText(QRectF(10, row.top(), area.left() - 20, row.height()), Qt::AlignRight | Qt::AlignVCenter,
                   said(group.label));
  const double each = 0.8 * row.height() / std::max<double>(1, static_cast<double>(group.bars.size()));
  double y = row.top() + 0.1 * row.height();
  for (const PlotBar& bar : group.bars) {
    const QColor colour = kBars[bar.series % std::size(kBars)];
    if (std::isfinite(bar.value)) {
      const double right = area.left() + area.width() * std::clamp(bar.value / most, 0.0, 1.0);
      painter.fillRect(QRectF(area.left(), y + 0.08 * each, right - area.left(), 0.84 * each), colour);
      if (bar.value > most) {
        painter.setPen(Qt::white);
        painter.setFont(plotFont(11, true));
        painter.drawText(QRectF(area.left(), y, right - area.left() - 6, each), Qt::AlignRight | Qt::AlignVCenter, said(axisNumber(std::round(bar.value))));
      } else if (std::isfinite(bar.upTo)) {
        const double to = area.left() + area.width() * std::clamp(bar.upTo / most, 0.0, 1.0),
                     middle = y + 0.5 * each;
        painter.setPen(QPen(kWords, 1));
        painter.drawLine(QPointF(right, middle), QPointF(to, middle));
        painter.drawLine(QPointF(to, middle - 0.25 * each), QPointF(to, middle + 0.25 * each));
      }
    }
    y += each;
  }
  painter.setPen(kWords);
  painter.setFont(plotFont(11));
  const QFontMetricsF metrics(painter.font());
  const double line = 14, left = area.right() + 16, width = kPlotWidth - left - 10;
  double at = row.center().y() - 0.5 * line * static_cast<double>(group.notes.size()) + 11;
  for (const std::string& note : group.notes) {
    painter.drawText(QPointF(left, at), metrics.elidedText(said(note), Qt::ElideRight, width));
    at += line;
  }
}

}  // namespace

double evenTick(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)) - 1);
  for (const double times : {1, 2, 5, 10, 20, 50})
    if (most / (times * power) <= 9) return times * power;
  return 100 * power;
}

void draw(QPainter& painter, const BarPlot& plot) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(0, 0, kPlotWidth, kPlotHeight), Qt::white);
  double y = 4;
  drawHeads(painter, plot, y);
  const QRectF area(172, y + 36, 448, kPlotHeight - y - 36 - 60);
  const double most = plot.most > 0 ? plot.most : 1.04 * mostOf(plot);
  drawScale(painter, plot, area, most);
  const double each = area.height() / std::max<double>(1, static_cast<double>(plot.groups.size()));
  for (std::size_t k = 0; k < plot.groups.size(); ++k)
    drawGroup(painter, plot.groups[k],
              QRectF(area.left(), area.top() + each * static_cast<double>(k), area.width(), each), area,
              most);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kWords, 1.2));
  painter.drawRect(area);
}

}  // namespace glenoid
