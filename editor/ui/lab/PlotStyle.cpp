// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/lab/PlotStyle.h"

#include <algorithm>
#include <cmath>

#include "editor/ui/Theme.h"

namespace glenoid {

void styleAxis(QCPAxis& axis) {
  const Theme& theme = currentTheme();
  const QColor text = theme.color(QStringLiteral("muted")), line = theme.color(QStringLiteral("line"));
  axis.setBasePen(QPen(line));
  axis.setTickPen(QPen(line));
  axis.setSubTickPen(QPen(line));
  axis.setTickLabelColor(text);
  axis.setLabelColor(theme.color(QStringLiteral("text")));
  axis.setLabelFont(axis.parentPlot()->font());
  axis.setTickLabelFont(axis.parentPlot()->font());
  axis.grid()->setPen(QPen(line, 0, Qt::DotLine));
  axis.grid()->setZeroLinePen(Qt::NoPen);
}

void styleAxes(QCustomPlot& plot) {
  plot.setBackground(currentTheme().color(QStringLiteral("base")));
  for (QCPAxisRect* rect : plot.axisRects())
    for (QCPAxis* axis : rect->axes()) styleAxis(*axis);
}

QColor seriesColour(std::size_t series) {
  static const QColor kColours[] = {QColor(86, 180, 233), QColor(213, 94, 0), QColor(0, 158, 115), QColor(204, 121, 167),
                                    QColor(230, 159, 0),  QColor(0, 114, 178)};
  constexpr std::size_t kCount = std::size(kColours);
  return series % (kCount + 1) == kCount ? currentTheme().color(QStringLiteral("text")) : kColours[series % (kCount + 1)];
}

QCPScatterStyle seriesMarker(std::size_t series, bool hollow) {
  static constexpr QCPScatterStyle::ScatterShape kShapes[] = {QCPScatterStyle::ssCircle,   QCPScatterStyle::ssSquare, QCPScatterStyle::ssTriangle,
                                                              QCPScatterStyle::ssDiamond, QCPScatterStyle::ssTriangleInverted};
  const QColor colour = seriesColour(series);
  return QCPScatterStyle(kShapes[series % std::size(kShapes)], QPen(colour, 1.4), hollow ? QBrush(Qt::NoBrush) : QBrush(colour), 9);
}

void addLevel(QCustomPlot& plot, double at, const QString& words, bool upright) {
  const QColor colour = currentTheme().color(QStringLiteral("muted"));
  auto* line = new QCPItemLine(&plot);
  line->setSelectable(false);
  line->setPen(QPen(colour, 1, Qt::DashLine));
  for (QCPItemPosition* end : {line->start, line->end}) {
    end->setTypeX(upright ? QCPItemPosition::ptPlotCoords : QCPItemPosition::ptAxisRectRatio);
    end->setTypeY(upright ? QCPItemPosition::ptAxisRectRatio : QCPItemPosition::ptPlotCoords);
  }
  line->start->setCoords(upright ? at : 0, upright ? 1 : at);
  line->end->setCoords(upright ? at : 1, upright ? 0 : at);
  if (words.isEmpty()) return;
  auto* text = new QCPItemText(&plot);
  text->setSelectable(false);
  text->setText(words);
  text->setColor(colour);
  text->setFont(plot.font());
  text->setPadding(QMargins(4, 1, 4, 1));
  text->setPositionAlignment(upright ? Qt::AlignRight | Qt::AlignTop : Qt::AlignLeft | Qt::AlignBottom);
  text->position->setTypeX(upright ? QCPItemPosition::ptPlotCoords : QCPItemPosition::ptAxisRectRatio);
  text->position->setTypeY(upright ? QCPItemPosition::ptAxisRectRatio : QCPItemPosition::ptPlotCoords);
  text->position->setCoords(upright ? at : 0, upright ? 0 : at);
}

void makeLogarithmic(QCPAxis& axis) {
  axis.setScaleType(QCPAxis::stLogarithmic);
  axis.setTicker(QSharedPointer<QCPAxisTickerLog>::create());
  axis.setNumberFormat(QStringLiteral("gb"));
  axis.setNumberPrecision(0);
}

void setLogRange(QCPAxis& axis, std::span<const double> values) {
  double low = INFINITY, high = 0;
  for (const double value : values)
    if (std::isfinite(value) && value > 0) low = std::min(low, value), high = std::max(high, value);
  if (high <= 0) low = 0.1, high = 10;
  const double decades = std::max(1.0, std::log10(high / low)), middle = 0.5 * (std::log10(high) + std::log10(low));
  const double half = 0.5 * decades + 0.06 * decades;
  axis.setRange(std::pow(10, middle - half), std::pow(10, middle + half));
}

}  // namespace glenoid
