// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "editor/core/tools/Viewport.h"
#include "editor/render/Image.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// How a mesh is drawn in a small picture.
struct MeshLook {
  std::array<float, 3> color{0.8f, 0.8f, 0.8f};  ///< sRGB
  bool smooth = false;                           ///< shade between vertices, else each triangle flat
  bool edges = false;
  std::vector<int> marked;  ///< triangles in another colour, ascending
};

/// A picture of one mesh on a transparent ground, lit from the viewer, drawn on the CPU: needs no window and
/// may run on any thread, so that previews follow a slider without touching the view.
Image meshPicture(const TriMesh& mesh, const Viewport& viewport, const MeshLook& look);

}  // namespace glenoid
