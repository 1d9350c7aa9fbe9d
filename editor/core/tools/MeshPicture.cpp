// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/MeshPicture.h"

#include <algorithm>
#include <cmath>

#include "editor/core/tools/Raster.h"

namespace glenoid {
namespace {

constexpr std::array<float, 3> kMarked{1.0f, 0.55f, 0.10f};

Vec3 areaVector(const TriMesh& mesh, const std::array<int, 3>& t) {
  return (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
}

}  // namespace

Image meshPicture(const TriMesh& mesh, const Viewport& viewport, const MeshLook& look) {
  Image image;
  image.width = std::max(viewport.width, 1);
  image.height = std::max(viewport.height, 1);
  const std::size_t pixels = static_cast<std::size_t>(image.width) * image.height;
  image.rgba.assign(4 * pixels, 0);
  std::vector<float> depth(pixels, 0);
  const std::vector<raster::Corner> corners = raster::cornersOf(viewport, mesh);
  const ViewAxes axes = axesOf(viewport.view);
  // A lamp a little above and left of the viewer, so that a sphere looks round.
  const Vec3 lamp = (axes.back_W + 0.35 * axes.up_W - 0.35 * axes.right_W).normalized();
  const auto light = [&lamp](const Vec3& normal) {
    const double length = normal.norm();
    return static_cast<float>(0.25 + 0.75 * (length > 0 ? std::abs(normal.dot(lamp)) / length : 0));
  };
  std::vector<float> vertexLight;
  if (look.smooth) {
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (const auto& t : mesh.triangles)
      for (const int v : t) normals[v] += areaVector(mesh, t);
    for (const Vec3& normal : normals) vertexLight.push_back(light(normal));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& k = mesh.triangles[t];
    const raster::Corner &a = corners[k[0]], &b = corners[k[1]], &c = corners[k[2]];
    if (!(a.inverse > 0 && b.inverse > 0 && c.inverse > 0)) continue;
    const raster::Slope slope = raster::slopeOf(a, b, c);
    const auto& color = std::binary_search(look.marked.begin(), look.marked.end(), static_cast<int>(t))
                            ? kMarked
                            : look.color;
    const float flat = light(areaVector(mesh, k));
    const std::array<float, 3> sides = {std::hypot(c.x - b.x, c.y - b.y), std::hypot(a.x - c.x, a.y - c.y),
                                        std::hypot(b.x - a.x, b.y - a.y)};
    raster::fill(a, b, c, slope, image.width, image.height, [&](int x, int y, float inverse) {
      const std::size_t pixel = static_cast<std::size_t>(x) + static_cast<std::size_t>(y) * image.width;
      if (inverse <= depth[pixel]) return;
      depth[pixel] = inverse;
      const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
      const float wb = ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) / slope.area;
      const float wc = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / slope.area;
      const std::array<float, 3> w = {1 - wb - wc, wb, wc};
      float shade =
          look.smooth ? w[0] * vertexLight[k[0]] + w[1] * vertexLight[k[1]] + w[2] * vertexLight[k[2]] : flat;
      if (look.edges)
        for (int i = 0; i < 3; ++i)  // height over an edge in pixels
          if (sides[i] > 0 && w[i] * std::abs(slope.area) / sides[i] < 0.8f) shade *= 0.45f;
      for (int i = 0; i < 3; ++i)
        image.rgba[4 * pixel + i] =
            static_cast<unsigned char>(std::lround(255 * std::clamp(color[i] * shade, 0.0f, 1.0f)));
      image.rgba[4 * pixel + 3] = 255;
    });
  }
  return image;
}

}  // namespace glenoid
