// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "editor/render/Image.h"
#include "editor/render/Layers.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// Pictures side by side that take a scene apart.
enum class Sheet {
  None,
  Anatomy,  ///< bones; with ligaments and tendons; with muscles; with skin: panels that add nothing are left out
  Meshes,   ///< visual surfaces; collision surfaces; tetrahedra
  Cage      ///< parts at rest with the triangles that cut other parts; the cages that free them; the start they make
};

/// One picture of a sheet.
struct Panel {
  Layers layers;
  VecX q;  ///< what it shows; empty: the state that was asked for
};

/// "anatomy", "meshes" or "cage". Fails with BadUsage.
Result<Sheet> sheetNamed(const std::string& word);

/// From left to right; what `layers` hides stays hidden. `part`: id of the only part whose cage is drawn; empty: all.
/// None where the scene has nothing for this sheet.
std::vector<Panel> panelsOf(Sheet sheet, const Model& model, const Layers& layers, const std::string& part = {});

/// Of equal heights, in a row.
Image besideEachOther(const std::vector<Image>& images);

}  // namespace glenoid
