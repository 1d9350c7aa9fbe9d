// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be named in a picture and where its line begins: at a pixel that shows it, near the middle of all that do.
// Found by drawing numbers into a small target, so that nothing hidden is named.
#include <algorithm>
#include <cmath>

#include "editor/render/SceneRendererInside.h"

namespace glenoid {
namespace {

constexpr int kCoarser = 3;          ///< pixels of the picture along one of the small target
constexpr int kSeenLeast = 4;        ///< small pixels: less than this is not worth a name
constexpr float kSolid = 0.6f;       ///< opacity from which a surface counts as hiding what is behind it

/// Pixels that show one thing.
struct Seen {
  std::vector<Eigen::Vector2i> pixels;
  Vec2 anchor() const {
    Vec2 middle = Vec2::Zero();
    for (const Eigen::Vector2i& p : pixels) middle += p.cast<double>();
    middle /= static_cast<double>(pixels.size());
    const auto nearest = std::min_element(pixels.begin(), pixels.end(), [&](const auto& a, const auto& b) {
      return (a.template cast<double>() - middle).squaredNorm() < (b.template cast<double>() - middle).squaredNorm();
    });
    return nearest->cast<double>();
  }
};

}  // namespace

std::vector<LabelPainter::Label> SceneRenderer::Inside::labelsFor(const View& view, const VecX& q, const Layers& layers,
                                                                  const Target& target) {
  const Target small{0, std::max(target.width / kCoarser, 1), std::max(target.height / kCoarser, 1)};
  Layers solid = layers;
  solid.objects.resize(scene.objects.size());
  for (ObjectLook& look : solid.objects) look.visible = look.visible && look.opacity >= kSolid;
  if (!pickInto(view, q, solid, small, 0, 0, small.width, small.height)) return {};
  std::vector<std::array<GLint, 4>> what(static_cast<std::size_t>(small.width) * small.height);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(0, 0, small.width, small.height, GL_RGBA_INTEGER, GL_INT, what.data());

  // By object and surface: which region each triangle shows; the smallest wins where they overlap.
  std::vector<std::vector<int>> regionOf(2 * scene.objects.size());
  if (layers.regions) {
    std::vector<int> order(scene.regions.size());
    for (std::size_t r = 0; r < order.size(); ++r) order[r] = static_cast<int>(r);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      return scene.regions[a].triangles.count > scene.regions[b].triangles.count;
    });
    for (const int r : order) {
      const RegionRanges& region = scene.regions[r];
      std::vector<int>& of = regionOf[2 * region.object + static_cast<int>(region.surface)];
      of.resize(scene.objects[region.object].surface(region.surface).triangles.count / 3, -1);
      for (const TriangleRun& run : region.runs) std::fill_n(of.begin() + run.first, run.count, r);
    }
  }
  std::vector<Seen> objects(scene.objects.size()), regions(scene.regions.size());
  for (std::size_t i = 0; i < what.size(); ++i) {
    const int object = what[i][0], kind = what[i][1], triangle = what[i][2];
    if (object == 0) continue;
    const int across = static_cast<int>(i) % small.width, up = static_cast<int>(i) / small.width;
    const Eigen::Vector2i pixel(across, small.height - 1 - up);
    const std::vector<int>& of = regionOf[2 * (object - 1) + kind];
    if (triangle < static_cast<int>(of.size()) && of[triangle] >= 0) regions[of[triangle]].pixels.push_back(pixel);
    objects[object - 1].pixels.push_back(pixel);
  }
  std::vector<LabelPainter::Label> labels;
  const auto add = [&](const Seen& seen, const std::string& name) {
    if (static_cast<int>(seen.pixels.size()) < kSeenLeast || name.empty()) return;
    const auto shown = layers.names.find(name);
    const Vec2 scale(static_cast<double>(target.width) / small.width, static_cast<double>(target.height) / small.height);
    labels.push_back({shown == layers.names.end() ? name : shown->second, (seen.anchor() + Vec2(0.5, 0.5)).cwiseProduct(scale)});
  };
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (!scene.objects[i].tool) add(objects[i], scene.objects[i].name);
  for (std::size_t r = 0; r < regions.size(); ++r) add(regions[r], scene.regions[r].name);
  return labels;
}

}  // namespace glenoid
