// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <qcustomplot.h>

#include <span>

namespace glenoid {

/// A plot in the colours of the current theme: background, axes, grid, letters.
void styleAxes(QCustomPlot& plot);
void styleAxis(QCPAxis& axis);

/// Colours that people tell apart whatever they see of colour, by number. Source: Okabe and Ito, "Color Universal Design", 2008; black
/// gives way to the theme's text.
QColor seriesColour(std::size_t series);
QCPScatterStyle seriesMarker(std::size_t series, bool hollow);

/// A dashed line over the whole plot at a height (or, `upright`, at a place) with its words at the far end.
void addLevel(QCustomPlot& plot, double at, const QString& words, bool upright = false);

/// The ticks of a logarithmic axis, on a scale of its own.
void makeLogarithmic(QCPAxis& axis);

/// Sets a logarithmic range that holds these values, widened by a little, a decade at least. Values without a place on it do not count; with
/// none at all it is 0.1 to 10.
void setLogRange(QCPAxis& axis, std::span<const double> values);

}  // namespace glenoid
