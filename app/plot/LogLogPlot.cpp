// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plot/LogLogPlot.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/plot/PlotAxis.h"

namespace glenoid {
namespace {

// Okabe and Ito's colours, which people tell apart whatever they see of colour.
const QColor kColours[] = {QColor(0, 114, 178), QColor(213, 94, 0), QColor(0, 158, 115), QColor(204, 121, 167),
                           QColor(86, 180, 233), QColor(230, 159, 0), QColor(90, 90, 90), QColor(0, 0, 0)};
const QColor kText(30, 30, 30), kFaint(225, 225, 225), kBand(205, 205, 205), kLevel(120, 120, 120);
constexpr double kMarker = 5;

/// What is a line alone is black.
QColor colourOf(const LogLogPlot& plot, std::size_t series) {
  return plot.series[series].line && !plot.series[series].markers ? QColor(Qt::black) : kColours[series % std::size(kColours)];
}

QFont fontOf(double size, bool bold = false) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(size));
  font.setBold(bold);
  font.setStyleStrategy(QFont::PreferNoShaping);  // ligatures could not be searched for in a PDF
  return font;
}

QString words(const std::string& text) { return QString::fromStdString(text); }

void drawMarker(QPainter& painter, std::size_t kind, QPointF at, bool hollow) {
  const QColor colour = kColours[kind % std::size(kColours)];
  painter.setPen(QPen(colour, 1.6));
  painter.setBrush(hollow ? QBrush(Qt::white) : QBrush(colour));
  const double r = kMarker;
  switch (kind % 6) {
    case 0: painter.drawEllipse(at, r, r); break;
    case 1: painter.drawRect(QRectF(at.x() - r, at.y() - r, 2 * r, 2 * r)); break;
    case 2: painter.drawPolygon(QPolygonF({at + QPointF(0, -1.3 * r), at + QPointF(1.2 * r, r), at + QPointF(-1.2 * r, r)})); break;
    case 3: painter.drawPolygon(QPolygonF({at + QPointF(0, -1.4 * r), at + QPointF(1.4 * r, 0), at + QPointF(0, 1.4 * r), at + QPointF(-1.4 * r, 0)})); break;
    case 4: painter.drawPolygon(QPolygonF({at + QPointF(0, 1.3 * r), at + QPointF(1.2 * r, -r), at + QPointF(-1.2 * r, -r)})); break;
    default:
      painter.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
      painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
  }
}

/// Where things are, so that labels find room.
struct Room {
  QRectF area;
  std::vector<QRectF> taken;
  bool isFree(const QRectF& rect) const {
    return area.contains(rect) && std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(rect); });
  }
};

/// Beside a point, in the nearest place that is free; further away with a thin line to it; not at all where the plot is full.
void placeLabel(QPainter& painter, Room& room, QPointF at, const QString& text, double size) {
  const QFontMetricsF metrics(painter.font());
  const double width = metrics.horizontalAdvance(text) + 2, height = size + 3;
  for (const double away : {9.0, 17.0, 27.0, 39.0, 53.0, 69.0, 88.0})
    for (const int turn : {0, 4, 1, 7, 3, 5, 2, 6}) {  // right first, then left, then aslant, above, below
      const double angle = turn * M_PI / 4;
      const QPointF foot = at + away * QPointF(std::cos(angle), -std::sin(angle));
      const double x = std::cos(angle) > 0.3 ? foot.x() : std::cos(angle) < -0.3 ? foot.x() - width : foot.x() - 0.5 * width;
      const QRectF rect(x, foot.y() - 0.5 * height, width, height);
      if (!room.isFree(rect)) continue;
      room.taken.push_back(rect);
      if (away > 20) {
        painter.setPen(QPen(QColor(160, 160, 160), 0.7));
        painter.drawLine(at, foot);
      }
      painter.setPen(kText);
      painter.drawText(QPointF(rect.left() + 1, rect.bottom() - 0.25 * height), text);
      return;
    }
}

void drawHeading(QPainter& painter, const LogLogPlot& plot, double& y) {
  painter.setPen(kText);
  painter.setFont(fontOf(21, true));
  painter.drawText(QPointF(24, y += 30), words(plot.title));
  painter.setFont(fontOf(13));
  for (const std::string& line : plot.subtitle) painter.drawText(QPointF(24, y += 18), words(line));
}

void drawLegend(QPainter& painter, const LogLogPlot& plot, double& y) {
  painter.setFont(fontOf(13));
  const QFontMetricsF metrics(painter.font());
  double x = 30;
  y += 28;
  const auto place = [&](const std::string& name) {  // how wide it is, on the next line where this one is full
    const double width = 36 + metrics.horizontalAdvance(words(name));
    if (x + width > kPlotWidth - 20) x = 30, y += 20;
    return width;
  };
  const auto name = [&](const std::string& text, double width) {
    painter.setPen(kText);
    painter.drawText(QPointF(x + 13, y), words(text));
    x += width;
  };
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    if (series.name.empty()) continue;
    const double width = place(series.name);
    if (series.line) {
      painter.setPen(QPen(colourOf(plot, k), 1.6));
      painter.drawLine(QPointF(x - 8, y - 4.5), QPointF(x + 8, y - 4.5));
    }
    if (series.markers) drawMarker(painter, k, QPointF(x, y - 4.5), false);
    name(series.name, width);
  }
  if (plot.band > 0 && !plot.bandLabel.empty()) {
    const double width = place(plot.bandLabel);
    painter.fillRect(QRectF(x - 8, y - 11, 16, 13), kBand);
    name(plot.bandLabel, width);
  }
  if (plot.limit > 0 && !plot.limitLabel.empty()) {
    const double width = place(plot.limitLabel);
    painter.setPen(QPen(kLevel, 1.2, Qt::DashLine));
    painter.drawLine(QPointF(x, y - 12), QPointF(x, y + 2));
    name(plot.limitLabel, width);
  }
}

void drawAxes(QPainter& painter, const LogLogPlot& plot, const QRectF& area, const PlotAxis& xs, const PlotAxis& ys) {
  painter.setFont(fontOf(13));
  for (const PlotAxis::Tick& tick : xs.ticks()) {
    const double x = xs.at(tick.value);
    painter.setPen(QPen(kFaint, tick.major ? 1.2 : 0.5));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(kText);
    if (!tick.label.empty()) painter.drawText(QRectF(x - 50, area.bottom() + 4, 100, 20), Qt::AlignCenter, words(tick.label));
  }
  for (const PlotAxis::Tick& tick : ys.ticks()) {
    const double y = ys.at(tick.value);
    painter.setPen(QPen(kFaint, tick.major ? 1.2 : 0.5));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(kText);
    if (!tick.label.empty()) painter.drawText(QRectF(area.left() - 68, y - 10, 60, 20), Qt::AlignRight | Qt::AlignVCenter, words(tick.label));
  }
  painter.setFont(fontOf(14, true));
  painter.drawText(QRectF(area.left(), area.bottom() + 26, area.width(), 22), Qt::AlignCenter, words(plot.xTitle));
  painter.drawText(QPointF(24, area.top() - 10), words(plot.yTitle));
}

/// Behind everything: the band, its limit, the levels.
void drawGround(QPainter& painter, const LogLogPlot& plot, const QRectF& area, const PlotAxis& xs, const PlotAxis& ys, Room& room) {
  painter.setFont(fontOf(12));
  const QFontMetricsF metrics(painter.font());
  const auto say = [&](QPointF at, const QString& text) {
    painter.setPen(QColor(80, 80, 80));
    painter.drawText(at, text);
    room.taken.push_back(QRectF(at.x(), at.y() - 12, metrics.horizontalAdvance(text), 15));
  };
  if (plot.band > 0) painter.fillRect(QRectF(area.left(), area.top(), std::max(0.0, std::min(xs.at(plot.band), area.right()) - area.left()), area.height()), kBand);
  if (plot.limit > 0 && xs.at(plot.limit) < area.right()) {
    painter.setPen(QPen(kLevel, 1.2, Qt::DashLine));
    painter.drawLine(QPointF(xs.at(plot.limit), area.top()), QPointF(xs.at(plot.limit), area.bottom()));
  }
  for (const LogLogPlot::Level& level : plot.levels) {
    const double y = ys.at(level.y);
    painter.setPen(QPen(kLevel, 1.2, Qt::DashDotLine));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    const double width = metrics.horizontalAdvance(words(level.label));
    say(QPointF(area.right() - width - 6, y - 4), words(level.label));
  }
}

void drawLines(QPainter& painter, const LogLogPlot& plot, const PlotAxis& xs, const PlotAxis& ys, Room& room) {
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    if (!series.line) continue;
    QPainterPath path;
    bool open = false;
    for (const PlotPoint& point : series.points) {
      if (!PlotAxis::hasPlace(point.x) || !PlotAxis::hasPlace(point.y)) {
        open = false;  // a gap: no line joins its neighbours
        continue;
      }
      const QPointF at(xs.at(point.x), ys.at(point.y));
      if (open) path.lineTo(at);
      else path.moveTo(at);
      open = true;
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colourOf(plot, k), 1.6));
    painter.drawPath(path);
    const double length = path.length();
    for (double at = 0; at < length; at += 6) {  // labels keep off it
      const QPointF point = path.pointAtPercent(path.percentAtLength(at));
      room.taken.push_back(QRectF(point.x() - 2, point.y() - 2, 4, 4));
    }
  }
}

void drawPoints(QPainter& painter, const LogLogPlot& plot, const PlotAxis& xs, const PlotAxis& ys, Room& room) {
  struct Labelled {
    QPointF at;
    const PlotPoint* point;
  };
  std::vector<Labelled> labels;
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    for (const PlotPoint& point : plot.series[k].points) {
      if (!plot.series[k].markers || !PlotAxis::hasPlace(point.x) || !PlotAxis::hasPlace(point.y)) continue;
      const QPointF at(xs.at(point.x), ys.at(point.y));
      if (PlotAxis::hasPlace(point.upTo)) {
        const double top = ys.at(point.upTo);
        painter.setPen(QPen(kColours[k % std::size(kColours)], 1));
        painter.drawLine(at, QPointF(at.x(), top));
        painter.drawLine(QPointF(at.x() - 3, top), QPointF(at.x() + 3, top));
      }
      drawMarker(painter, k, at, point.hollow);
      room.taken.push_back(QRectF(at.x() - 7, at.y() - 7, 14, 14));
      if (!point.label.empty()) labels.push_back({at, &point});
    }
  std::stable_sort(labels.begin(), labels.end(), [](const Labelled& a, const Labelled& b) { return a.point->important > b.point->important; });
  for (const Labelled& label : labels) {
    const double size = label.point->important ? 13 : 11;
    painter.setFont(fontOf(size, label.point->important));
    placeLabel(painter, room, label.at, words(label.point->label), size);
  }
}

/// What failed: a cross on the right edge at its height, its words beside it, one under the other where they would meet.
void drawMargin(QPainter& painter, const LogLogPlot& plot, const QRectF& area, const PlotAxis& ys) {
  if (plot.margin.empty()) return;
  const double x = area.right();
  painter.setFont(fontOf(13, true));
  painter.setPen(kText);
  painter.drawText(QPointF(x + 14, area.top() - 10), words(plot.marginTitle));
  std::vector<const PlotMargin*> order;
  for (const PlotMargin& one : plot.margin) order.push_back(&one);
  const auto height = [&](const PlotMargin* one) { return PlotAxis::hasPlace(one->y) ? ys.at(one->y) : area.top() + 10; };
  std::stable_sort(order.begin(), order.end(), [&](const PlotMargin* a, const PlotMargin* b) { return height(a) < height(b); });
  constexpr double kEach = 30;
  double next = area.top() + 8;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double left = kEach * static_cast<double>(order.size() - k);  // for those that follow
    const double y = std::max(next, std::min(height(order[k]), area.bottom() - left + 8));
    painter.setPen(QPen(QColor(180, 0, 0), 1.6));
    if (PlotAxis::hasPlace(order[k]->y)) {
      const double at = height(order[k]);
      painter.drawLine(QPointF(x - 5, at - 5), QPointF(x + 5, at + 5));
      painter.drawLine(QPointF(x - 5, at + 5), QPointF(x + 5, at - 5));
      painter.setPen(QPen(QColor(160, 160, 160), 0.7));
      painter.drawLine(QPointF(x + 6, at), QPointF(x + 13, y));
    }
    painter.setPen(kText);
    painter.setFont(fontOf(11, true));
    const double width = kPlotWidth - x - 22;
    painter.drawText(QPointF(x + 15, y + 1), QFontMetricsF(painter.font()).elidedText(words(order[k]->label), Qt::ElideRight, width));
    painter.setFont(fontOf(11));
    painter.drawText(QPointF(x + 15, y + 14), QFontMetricsF(painter.font()).elidedText(words(order[k]->reason), Qt::ElideRight, width));
    next = y + kEach;
  }
}

}  // namespace

void draw(QPainter& painter, const LogLogPlot& plot) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(0, 0, kPlotWidth, kPlotHeight), Qt::white);
  double y = 4;
  drawHeading(painter, plot, y);
  drawLegend(painter, plot, y);
  const double right = plot.margin.empty() ? 30 : 250;
  const QRectF area(86, y + 46, kPlotWidth - 86 - right, kPlotHeight - y - 46 - 60);
  std::vector<double> xValues{plot.band, plot.limit}, yValues;
  for (const PlotSeries& series : plot.series)
    for (const PlotPoint& point : series.points) {
      xValues.push_back(point.x);
      yValues.push_back(point.y);
      yValues.push_back(point.upTo);
    }
  for (const PlotMargin& one : plot.margin) yValues.push_back(one.y);
  for (const LogLogPlot::Level& level : plot.levels) yValues.push_back(level.y);
  const PlotAxis xs(xValues, area.left(), area.right()), ys(yValues, area.bottom(), area.top());
  Room room{area, {}};
  drawGround(painter, plot, area, xs, ys, room);
  drawAxes(painter, plot, area, xs, ys);
  drawLines(painter, plot, xs, ys, room);
  drawPoints(painter, plot, xs, ys, room);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kText, 1.2));
  painter.drawRect(area);
  drawMargin(painter, plot, area, ys);
}

}  // namespace glenoid
