// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "editor/render/LabelPainter.h"
#include "editor/render/Layers.h"

namespace glenoid {

struct Target;

/// What a legend took of the lower right corner, pixels of the target with the way to the border; zero: nothing.
struct LegendBox {
  double width = 0, height = 0;
};

/// The scale of a field in the lower right corner of a finished picture: its title, a bar of the colours and ticks with
/// their values, on a plate in the theme's colours. In a picture too small for it there is none.
class LegendPainter {
 public:
  Result<Done> build();
  /// Into the bound target; blends, leaves depth test off. `scale`: one-dimensional texture of the colours, low first.
  LegendBox draw(const FieldLook& field, const Target& target, unsigned scale, double pixelRatio, bool dark, LabelPainter& words,
                 LinePainter& lines);

 private:
  Program m_program;
  GlVertexArray m_array;
};

}  // namespace glenoid
