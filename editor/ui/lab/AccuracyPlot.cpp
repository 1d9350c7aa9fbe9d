// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/lab/AccuracyPlot.h"

#include <algorithm>
#include <cmath>

#include "editor/lab/SettingWords.h"
#include "editor/ui/Theme.h"
#include "editor/ui/lab/PlotStyle.h"

namespace glenoid {
namespace {

constexpr double kReach = 14;      // pixels within which a point is pointed at
constexpr double kMarginRow = 0.06;  // of the height, between two points at the margin

bool hasPlace(double value) { return std::isfinite(value) && value > 0; }

}  // namespace

AccuracyPlot::AccuracyPlot(QWidget* parent) : QCustomPlot(parent) {
  setObjectName(QStringLiteral("lab.accuracy.plot"));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 260);
  setMouseTracking(true);
  setNoAntialiasingOnDrag(true);
  for (QCPAxis* axis : {xAxis, yAxis}) makeLogarithmic(*axis);
  xAxis2->setVisible(true);
  yAxis2->setVisible(true);
  for (QCPAxis* axis : {xAxis2, yAxis2}) {
    axis->setTicks(false);
    axis->setTickLabels(false);
  }
  setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  connect(xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, [this] { m_ownRange = true; });
  legend->setVisible(true);
  axisRect()->setMinimumMargins(QMargins(0, 0, 34, 0));
  auto* below = new QCPLayoutGrid;  // the legend keeps off the points
  plotLayout()->addElement(1, 0, below);
  below->setMargins(QMargins(6, 0, 6, 4));
  below->addElement(0, 0, legend);
  legend->setFillOrder(QCPLegend::foColumnsFirst);
  legend->setWrap(4);
  plotLayout()->setRowStretchFactor(1, 0.001);
  restyle();
}

void AccuracyPlot::restyle() {
  styleAxes(*this);
  legend->setBrush(Qt::NoBrush);
  legend->setBorderPen(Qt::NoPen);
  legend->setTextColor(currentTheme().color(QStringLiteral("text")));
  legend->setFont(font());
  rebuild();
}

void AccuracyPlot::setPoints(AccuracyPoints points) {
  const bool otherView = points.view.quantity != m_points.view.quantity || points.view.against != m_points.view.against;
  m_points = std::move(points);
  if (otherView || m_points.points.empty()) m_ownRange = false;
  rebuild();
}

void AccuracyPlot::setChosen(const std::string& id) {
  if (m_chosen == id) return;
  m_chosen = id;
  rebuild();
}

/// What has no error at all has no place on a logarithmic axis; it stands left of the least that there is.
double AccuracyPlot::xOf(const AccuracyPoint& point) const {
  if (point.error != 0) return point.error;
  double least = hasPlace(m_points.floor) ? m_points.floor : INFINITY;
  for (const AccuracyPoint& other : m_points.points)
    if (hasPlace(other.error)) least = std::min(least, other.error);
  return std::isfinite(least) ? 0.5 * least : 1e-3;
}

std::optional<QPointF> AccuracyPlot::placeOf(std::size_t index) const {
  const AccuracyPoint& point = m_points.points[index];
  if (const auto margin = m_marginHeight.find(index); margin != m_marginHeight.end())
    return QPointF(axisRect()->right() + 16, axisRect()->top() + margin->second * axisRect()->height());
  if (!hasPlace(point.ms) || !hasPlace(xOf(point))) return std::nullopt;
  return QPointF(xAxis->coordToPixel(xOf(point)), yAxis->coordToPixel(point.ms));
}

void AccuracyPlot::showAll() {
  std::vector<double> xs{m_points.floor, 2 * m_points.floor}, ys{1, 5, 20, m_points.stepMs};
  for (const AccuracyPoint& point : m_points.points) {
    if (point.failure.empty() && std::isfinite(point.error)) xs.push_back(xOf(point));
    if (point.failure.empty() && !std::isfinite(point.error)) continue;
    ys.push_back(point.ms);
    ys.push_back(point.p95);
  }
  setLogRange(*xAxis, xs);
  setLogRange(*yAxis, ys);
  m_ownRange = false;
}

void AccuracyPlot::rebuild() {
  clearPlottables();
  clearItems();
  if (!m_ownRange) showAll();
  const bool length = isLengthQuantity(m_points.view.quantity);
  const QString quantity = quantityName(m_points.view.quantity);
  xAxis->setLabel(length ? tr("Error of %1, mm").arg(quantity) : tr("Error of %1, N").arg(quantity));
  yAxis->setLabel(tr("Computing time for %1 ms of simulated time, ms").arg(QLocale().toString(m_points.stepMs, 'g', 3)));
  addGround();
  addSeries();
  addMargin();
  addRing(m_chosen, currentTheme().color(QStringLiteral("accent")), 18);
  addRing(m_pointed, currentTheme().color(QStringLiteral("text")), 15);
  replot(rpQueuedReplot);
}

void AccuracyPlot::addGround() {
  if (hasPlace(m_points.floor)) {
    auto* band = new QCPItemRect(this);
    band->setSelectable(false);
    band->setLayer(QStringLiteral("background"));
    band->setPen(Qt::NoPen);
    QColor grey = currentTheme().color(QStringLiteral("muted"));
    grey.setAlpha(60);
    band->setBrush(grey);
    for (QCPItemPosition* corner : {band->topLeft, band->bottomRight}) corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
    band->topLeft->setTypeX(QCPItemPosition::ptAxisRectRatio);
    band->topLeft->setCoords(0, 0);
    band->bottomRight->setCoords(m_points.floor, 1);
    addLevel(*this, 2 * m_points.floor, {}, true);
  }
  const auto say = [&](double ms) {
    const QString words = msText(ms);
    addLevel(*this, ms, ms == m_points.stepMs ? tr("%1 (real time)").arg(words) : words);
  };
  for (const double ms : {1.0, 5.0, 20.0}) say(ms);
  if (m_points.stepMs != 1 && m_points.stepMs != 5 && m_points.stepMs != 20) say(m_points.stepMs);
}

void AccuracyPlot::addSeries() {
  std::vector<std::string> families;
  for (const AccuracyPoint& point : m_points.points)
    if (std::find(families.begin(), families.end(), point.family) == families.end()) families.push_back(point.family);
  for (std::size_t f = 0; f < families.size(); ++f)
    for (const bool hollow : {false, true}) {
      std::vector<const AccuracyPoint*> drawn;
      for (const AccuracyPoint& point : m_points.points)
        if (point.family == families[f] && (point.rough || point.few) == hollow && point.failure.empty() && std::isfinite(point.error) && hasPlace(point.ms)) drawn.push_back(&point);
      if (drawn.empty()) continue;
      // Whiskers go by the place in the graph, which sorts its points.
      std::stable_sort(drawn.begin(), drawn.end(), [this](const AccuracyPoint* a, const AccuracyPoint* b) { return xOf(*a) < xOf(*b); });
      QCPGraph* graph = addGraph();
      graph->setLineStyle(QCPGraph::lsNone);  // points: a line through them by their error would mean nothing
      graph->setScatterStyle(seriesMarker(f, hollow));
      graph->setName(familyName(families[f]));
      if (hollow && std::any_of(m_points.points.begin(), m_points.points.end(), [&](const AccuracyPoint& point) { return point.family == families[f] && !point.rough && !point.few && point.failure.empty(); }))
        graph->removeFromLegend();
      auto* whiskers = new QCPErrorBars(xAxis, yAxis);
      whiskers->removeFromLegend();
      whiskers->setPen(QPen(seriesColour(f), 1));
      whiskers->setDataPlottable(graph);
      whiskers->setSymbolGap(0);
      for (const AccuracyPoint* point : drawn) {
        graph->addData(xOf(*point), point->ms);
        whiskers->addData(0.0, hasPlace(point->p95) ? point->p95 - point->ms : 0.0);
      }
    }
  if (m_points.front.size() > 1) {
    auto* front = new QCPCurve(xAxis, yAxis);
    front->setName(tr("no other is both faster and nearer"));
    front->setPen(QPen(currentTheme().color(QStringLiteral("text")), 1.4));
    for (const std::size_t k : m_points.front) front->addData(xOf(m_points.points[k]), m_points.points[k].ms);
  }
}

/// Each at its height, or at the nearest below that is free.
void AccuracyPlot::addMargin() {
  m_marginHeight.clear();
  std::vector<std::size_t> failed;
  for (std::size_t k = 0; k < m_points.points.size(); ++k)
    if (!m_points.points[k].failure.empty()) failed.push_back(k);
  const double low = std::log10(yAxis->range().lower), high = std::log10(yAxis->range().upper);
  const auto wish = [&](std::size_t k) { return hasPlace(m_points.points[k].ms) ? std::clamp((high - std::log10(m_points.points[k].ms)) / (high - low), 0.03, 0.97) : 0.03; };
  std::stable_sort(failed.begin(), failed.end(), [&](std::size_t a, std::size_t b) { return wish(a) < wish(b); });
  double next = 0;
  for (std::size_t k = 0; k < failed.size(); ++k) {
    const double room = 0.97 - kMarginRow * static_cast<double>(failed.size() - 1 - k);
    m_marginHeight[failed[k]] = std::max(next, std::min(wish(failed[k]), room));
    next = m_marginHeight[failed[k]] + kMarginRow;
    auto* cross = new QCPItemText(this);
    cross->setSelectable(false);
    cross->setClipToAxisRect(false);
    cross->setText(QStringLiteral("✕"));
    cross->setColor(currentTheme().color(QStringLiteral("error")));
    QFont bold = font();
    bold.setBold(true);
    cross->setFont(bold);
    cross->position->setType(QCPItemPosition::ptAbsolute);
    cross->position->setParentAnchor(nullptr);
    cross->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
    cross->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    cross->position->setCoords(1.0 + 16.0 / std::max(1, axisRect()->width()), m_marginHeight[failed[k]]);
  }
}

void AccuracyPlot::addRing(const std::string& id, const QColor& colour, double size) {
  for (std::size_t k = 0; k < m_points.points.size(); ++k) {
    if (id.empty() || m_points.points[k].id != id || !placeOf(k)) continue;
    auto* ring = new QCPItemEllipse(this);
    ring->setSelectable(false);
    ring->setClipToAxisRect(false);
    ring->setPen(QPen(colour, 2));
    // About the point, in pixels, so that it stays round.
    auto* middle = new QCPItemTracer(this);
    middle->setStyle(QCPItemTracer::tsNone);
    middle->setSelectable(false);
    if (m_marginHeight.count(k)) {
      middle->position->setType(QCPItemPosition::ptAxisRectRatio);
      middle->position->setCoords(1.0 + 16.0 / std::max(1, axisRect()->width()), m_marginHeight.at(k));
    } else {
      middle->position->setCoords(xOf(m_points.points[k]), m_points.points[k].ms);
    }
    for (QCPItemPosition* corner : {ring->topLeft, ring->bottomRight}) {
      corner->setParentAnchor(middle->position);
      corner->setType(QCPItemPosition::ptAbsolute);
    }
    ring->topLeft->setCoords(-0.5 * size, -0.5 * size);
    ring->bottomRight->setCoords(0.5 * size, 0.5 * size);
  }
}

std::optional<std::size_t> AccuracyPlot::nearest(QPointF at) const {
  std::optional<std::size_t> found;
  double least = kReach * kReach;
  for (std::size_t k = 0; k < m_points.points.size(); ++k) {
    const auto place = placeOf(k);
    if (!place || (!m_marginHeight.count(k) && !std::isfinite(m_points.points[k].error))) continue;
    const QPointF away = *place - at;
    const double squared = away.x() * away.x() + away.y() * away.y();
    if (squared < least) least = squared, found = k;
  }
  return found;
}

void AccuracyPlot::point(const std::string& id) {
  if (m_pointed == id) return;
  m_pointed = id;
  rebuild();
  emit pointed(QString::fromStdString(id));
}

void AccuracyPlot::mouseMoveEvent(QMouseEvent* event) {
  QCustomPlot::mouseMoveEvent(event);
  if (event->buttons() != Qt::NoButton) return;
  const auto found = nearest(event->position());
  setCursor(found ? Qt::PointingHandCursor : Qt::ArrowCursor);
  point(found ? m_points.points[*found].id : std::string());
}

void AccuracyPlot::mousePressEvent(QMouseEvent* event) {
  m_pressedAt = event->position().toPoint();
  QCustomPlot::mousePressEvent(event);
}

void AccuracyPlot::mouseReleaseEvent(QMouseEvent* event) {
  QCustomPlot::mouseReleaseEvent(event);
  if (event->button() != Qt::LeftButton || (event->position().toPoint() - m_pressedAt).manhattanLength() > 4) return;
  if (const auto found = nearest(event->position())) {
    setChosen(m_points.points[*found].id);
    emit chosenByHand(QString::fromStdString(m_chosen));
  }
}

void AccuracyPlot::mouseDoubleClickEvent(QMouseEvent*) {
  showAll();
  rebuild();
}

void AccuracyPlot::leaveEvent(QEvent* event) {
  QCustomPlot::leaveEvent(event);
  point({});
}

/// Through the points that are drawn, by time.
void AccuracyPlot::keyPressEvent(QKeyEvent* event) {
  const bool on = event->key() == Qt::Key_Right || event->key() == Qt::Key_Down, back = event->key() == Qt::Key_Left || event->key() == Qt::Key_Up;
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space) && !m_pointed.empty()) {
    setChosen(m_pointed);
    emit chosenByHand(QString::fromStdString(m_chosen));
    return;
  }
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < m_points.points.size(); ++k)
    if (placeOf(k) && (m_marginHeight.count(k) || std::isfinite(m_points.points[k].error))) order.push_back(k);
  if ((!on && !back) || order.empty()) return QCustomPlot::keyPressEvent(event);
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) { return m_points.points[a].ms < m_points.points[b].ms; });
  const std::string& from = m_pointed.empty() ? m_chosen : m_pointed;
  const auto at = std::find_if(order.begin(), order.end(), [&](std::size_t k) { return m_points.points[k].id == from; });
  const auto count = static_cast<std::ptrdiff_t>(order.size());
  const std::ptrdiff_t place = at == order.end() ? (on ? 0 : count - 1) : std::clamp<std::ptrdiff_t>(at - order.begin() + (on ? 1 : -1), 0, count - 1);
  point(m_points.points[order[static_cast<std::size_t>(place)]].id);
}

void AccuracyPlot::changeEvent(QEvent* event) {
  QCustomPlot::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange) restyle();
}

}  // namespace glenoid
