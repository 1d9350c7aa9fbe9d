// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "editor/render/Layers.h"
#include "editor/render/ScopeLook.h"
#include "editor/render/View.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// The radius of the round field in pixels, and its middle (from the top left) in a picture of this size.
double scopeRadius(int width, int height);

/// Where an arthroscope looks from in a state, and how its picture looks.
struct ScopeSight {
  View view;      ///< its field of view is that of the whole picture's height, so that the round field holds halfField
  ScopeLook look;
};
/// Of an object that is an arthroscope; the picture's size in pixels.
ScopeSight scopeSight(const Model& model, const VecX& q, int object, int width, int height);

/// Layers as an arthroscope sees them: without itself, and nothing marked as selected.
Layers throughScope(Layers layers, int object);

/// The first object that is an arthroscope, or the one with this tool id; nothing where there is none.
std::optional<int> findScope(const Model& model, std::string_view id = {});

/// Pixel (from the top left) at which a point is seen through the optics; nothing outside of the field.
std::optional<Vec2> seenThrough(const ScopeSight& sight, const Vec3& p_W, int width, int height);

}  // namespace glenoid
