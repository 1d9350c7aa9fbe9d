// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "editor/render/GlResources.h"

namespace glenoid {

/// The renderer's own targets: scene (linear, half floats, depth), its resolved form and outline mask.
/// Kept between frames and made anew when a size changes.
class FrameBuffers {
 public:
  /// width, height: of the picture; factor: scene texels per pixel along a side; samples: 1 or MSAA.
  /// False when the driver refuses the combination.
  bool resize(int width, int height, int factor, int samples);

  void bindScene();     ///< cleared: transparent black, farthest depth
  void resolveScene();  ///< makes color() and depth() valid
  void bindMask();  ///< cleared: nothing selected

  unsigned color() { return m_color.id(); }
  unsigned depth() { return m_depth.id(); }
  unsigned mask() { return m_mask.id(); }
  int width() const { return m_width; }
  int height() const { return m_height; }
  int factor() const { return m_factor; }

 private:
  int m_width = 0, m_height = 0, m_factor = 0, m_samples = 0;
  GlFramebuffer m_many, m_resolved, m_maskFrame;
  GlRenderbuffer m_manyColor, m_manyDepth;
  GlTexture m_color, m_depth, m_mask;
};

/// A picture's target: 8-bit RGBA that can be read back.
class ReadableTarget {
 public:
  bool resize(int width, int height);
  unsigned framebuffer() { return m_frame.id(); }

 private:
  GlFramebuffer m_frame;
  GlRenderbuffer m_color;
};

/// Integers and positions of what is seen, for picking.
class PickTarget {
 public:
  bool resize(int width, int height);
  void bind();  ///< cleared: nothing seen

 private:
  int m_width = 0, m_height = 0;
  GlFramebuffer m_frame;
  GlRenderbuffer m_what, m_where, m_normal, m_depth;
};

}  // namespace glenoid
