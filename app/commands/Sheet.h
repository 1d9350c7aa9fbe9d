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
  Meshes    ///< visual surfaces; collision surfaces; tetrahedra
};

/// "anatomy" or "meshes". Fails with BadUsage.
Result<Sheet> sheetNamed(const std::string& word);

/// The layers of each panel, from left to right; what `layers` hides stays hidden.
std::vector<Layers> panelsOf(Sheet sheet, const Model& model, const Layers& layers);

/// Of equal heights, in a row.
Image besideEachOther(const std::vector<Image>& images);

}  // namespace glenoid
