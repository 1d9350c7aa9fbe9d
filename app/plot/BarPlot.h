// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>
#include <string>
#include <vector>

class QPainter;

namespace glenoid {

/// One bar. A value that is not finite is no bar: `text` alone says why.
struct PlotBar {
  std::size_t series = 0;
  double value = std::numeric_limits<double>::quiet_NaN();
  double upTo = std::numeric_limits<double>::quiet_NaN();  ///< a whisker to this value
};

/// Bars that belong together, under one another, with words beside them.
struct PlotBarGroup {
  std::string label;
  std::vector<PlotBar> bars;
  std::vector<std::string> notes;  ///< lines at the right
};

/// Horizontal bars from zero on an even axis. Plain values; drawing is a function of them alone.
struct BarPlot {
  std::string title;
  std::vector<std::string> subtitle;
  std::string xTitle, notesTitle;
  double most = 0;                  ///< where the axis ends; a longer bar is cut there and says its value; 0: at the longest
  std::vector<std::string> series;  ///< for the legend
  std::vector<PlotBarGroup> groups;
  struct Level {
    double x;
    std::string label;
  };
  std::vector<Level> levels;  ///< vertical lines, where the axis reaches them
};

/// Fills kPlotWidth × kPlotHeight. Fonts need a QGuiApplication.
void draw(QPainter& painter, const BarPlot& plot);

/// 1, 2 or 5 times a power of ten, so that an axis up to `most` has four to nine ticks. `most` > 0.
double evenTick(double most);

}  // namespace glenoid
