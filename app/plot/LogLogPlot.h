// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

class QPainter;

namespace glenoid {

/// Places of a series; a coordinate that is not finite or not above zero has no place on logarithmic axes: the point is not
/// drawn, and a line through the series has a gap there.
struct PlotPoint {
  double x = 0, y = 0;
  std::string label = {};              ///< drawn beside it where there is room; empty: none
  double upTo = std::numeric_limits<double>::quiet_NaN();  ///< a whisker to this y
  bool important = false;              ///< its label finds room before others'
  bool hollow = false;
};

struct PlotSeries {
  std::string name;                    ///< in the legend; empty: not there
  std::vector<PlotPoint> points;
  bool line = false, markers = true;
};

/// What has no x: drawn at the right margin, at its height where it has one, with its reason.
struct PlotMargin {
  double y = std::numeric_limits<double>::quiet_NaN();
  std::string label, reason;
};

/// Two logarithmic axes: work over error, error over refinement. Plain values; drawing is a function of them alone.
struct LogLogPlot {
  std::string title;
  std::vector<std::string> subtitle;   ///< lines under it
  std::string xTitle, yTitle;
  std::vector<PlotSeries> series;
  std::vector<PlotMargin> margin;
  std::string marginTitle;
  struct Level {
    double y;
    std::string label;
  };
  std::vector<Level> levels;           ///< horizontal lines; the axis reaches as far as them
  double band = 0;                     ///< grey from the left up to this x; 0: none
  std::string bandLabel;               ///< in the legend
  double limit = 0;                    ///< dashed vertical line; 0: none
  std::string limitLabel;              ///< in the legend
};

/// Size that draw() fills, in its own units.
inline constexpr int kPlotWidth = 1200, kPlotHeight = 820;

/// Fonts need a QGuiApplication.
void draw(QPainter& painter, const LogLogPlot& plot);

}  // namespace glenoid
