// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/Raster.h"

namespace glenoid::raster {

std::vector<Corner> cornersOf(const Viewport& viewport, const TriMesh& mesh) {
  const ViewAxes axes = axesOf(viewport.view);
  const double scale = viewport.height / (2 * std::tan(viewport.view.fieldOfView / 2));
  const double x0 = viewport.width / 2.0, y0 = viewport.height / 2.0;
  std::vector<Corner> corners(mesh.vertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 d = mesh.vertices[i] - viewport.view.eye_W;
    const double depth = -d.dot(axes.back_W);
    if (depth < 1e-5) continue;
    corners[i] = {static_cast<float>(x0 + scale * d.dot(axes.right_W) / depth),
                  static_cast<float>(y0 - scale * d.dot(axes.up_W) / depth), static_cast<float>(1 / depth)};
  }
  return corners;
}

}  // namespace glenoid::raster
