// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "editor/render/View.h"

namespace glenoid {

/// Where a viewer stands and how large the window is; pixels from the top left.
struct Viewport {
  View view;
  int width = 1, height = 1;
};

inline bool sameViewport(const Viewport& a, const Viewport& b) {
  return a.width == b.width && a.height == b.height && a.view.eye_W == b.view.eye_W &&
         a.view.target_W == b.view.target_W && a.view.up_W == b.view.up_W &&
         a.view.fieldOfView == b.view.fieldOfView;
}

}  // namespace glenoid
