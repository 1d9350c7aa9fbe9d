// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "editor/render/LinePainter.h"
#include "editor/render/View.h"

namespace glenoid {

/// The orientation marker: three axes with the letters A, P (anterior, posterior), S, I (superior, inferior)
/// and L, M (lateral, medial) of a joint of this side, in the lower left corner, as lines in pixels from the
/// lower left; colours are sRGB, for a finished picture. `dark`: for a dark background. Letters are strokes
/// of our own, so no font is needed.
struct MarkerLines {
  std::vector<ColoredPoint> axes, letters;  ///< each two neighbours are a line; z = 0
};
MarkerLines markerLines(const View& view, double sizePx, bool dark, JointSide side = JointSide::Unsaid);

}  // namespace glenoid
