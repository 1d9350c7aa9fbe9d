// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <qcustomplot.h>

#include <map>
#include <optional>

#include "editor/lab/AccuracyPoints.h"

namespace glenoid {

/// Error beside milliseconds, both logarithmic, a point for each setting: grey where the reference's own error hides all, lines at 1, 5
/// and 20 ms, the front, and at the right margin what has no error, with its reason. Pointing at one or going through them with the arrow
/// keys tells which; a click or Enter chooses one. The wheel and a drag change the ranges, a double click shows all again.
class AccuracyPlot : public QCustomPlot {
  Q_OBJECT
 public:
  explicit AccuracyPlot(QWidget* parent = nullptr);

  void setPoints(AccuracyPoints points);
  const AccuracyPoints& points() const { return m_points; }
  void setChosen(const std::string& id);  ///< empty: none
  const std::string& chosen() const { return m_chosen; }
  /// Where a setting is drawn, in pixels; nothing where this view has no place for it.
  std::optional<QPointF> placeOf(std::size_t point) const;
  void restyle();

 signals:
  void pointed(const QString& id);  ///< empty: at none
  void chosenByHand(const QString& id);

 protected:
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void addGround();
  void addSeries();
  void addMargin();
  void addRing(const std::string& id, const QColor& colour, double size);
  void showAll();
  void point(const std::string& id);
  std::optional<std::size_t> nearest(QPointF at) const;
  double xOf(const AccuracyPoint& point) const;

  AccuracyPoints m_points;
  std::string m_chosen, m_pointed;
  std::map<std::size_t, double> m_marginHeight;  ///< share of the height from above, of points without error
  QPoint m_pressedAt;
  bool m_ownRange = false;  ///< somebody has zoomed
};

}  // namespace glenoid
