// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QByteArray>
#include <string>

#include "app/plot/BarPlot.h"
#include "app/plot/LogLogPlot.h"
#include "simcore/base/Error.h"

namespace glenoid {

/// STEM.png (twice the plot's size), STEM.svg and STEM.pdf, each written whole or not at all; text in the last two can be searched for.
/// Needs a QGuiApplication (any platform, also offscreen). Fails as writeWholeFile does.
Result<Done> writePlot(const LogLogPlot& plot, const std::string& stem);
Result<Done> writePlot(const BarPlot& plot, const std::string& stem);

/// The same SVG as bytes.
QByteArray plotSvg(const LogLogPlot& plot);

}  // namespace glenoid
