// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "editor/render/SceneRendererInside.h"

namespace glenoid {

Result<Image> SceneRenderer::picture(const View& view, const VecX& q, const Layers& layers,
                                     std::span<const ContactView> contacts, const Look& look, int width,
                                     int height) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  const int limit = std::min(kImageSideMax, most / std::clamp(look.supersample, 1, 4));
  if (width < 1 || height < 1 || width > limit || height > limit)
    return Error{Fault::OutOfRange,
                 {},
                 {std::to_string(width) + "x" + std::to_string(height), "1", std::to_string(limit)},
                 "picture size"};
  ReadableTarget target;
  if (!target.resize(width, height)) return Error{Fault::NoGraphics, {}, {}, "no target for a picture"};
  if (look.ambientOcclusion)
    if (auto answer = m_inside->occlusionJob.take(true)) m_inside->occlusion = std::move(answer);
  draw(view, q, layers, contacts, look, {target.framebuffer(), width, height});

  Image image{width, height, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) * height)};
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  for (int y = 0; y < height / 2; ++y)  // OpenGL's first row is the lowest
    std::swap_ranges(image.rgba.begin() + y * row, image.rgba.begin() + (y + 1) * row,
                     image.rgba.begin() + (height - 1 - y) * row);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const int alpha = image.rgba[i + 3];
    for (int c = 0; c < 3 && alpha > 0 && alpha < 255; ++c)
      image.rgba[i + c] =
          static_cast<std::uint8_t>(std::min(255, (image.rgba[i + c] * 255 + alpha / 2) / alpha));
  }
  return image;
}

Result<Image> renderPicture(const Model& model, const State& state, const View& view, const Layers& layers,
                            int width, int height, const Look& look, std::span<const ContactView> contacts) {
  auto context = HeadlessContext::create();
  if (!context) return context.error();
  auto renderer = SceneRenderer::create();
  if (!renderer) return renderer.error();
  if (auto set = (*renderer)->setScene(model); !set) return set.error();
  Look fine = look;
  if (fine.samples < 0) fine.samples = 4;  // nobody waits for the next frame
  auto image = (*renderer)->picture(view, state.q, layers, contacts, fine, width, height);
  renderer->reset();  // before its context
  return image;
}

Box3 sceneBounds(const Model& model, const VecX& q) {
  Box3 box;
  const auto geometry = buildSceneGeometry(model);
  if (!geometry || q.size() != geometry->qSize) return box;
  for (const ObjectGeometry& object : geometry->objects)
    for (int v = object.visual.vertices.first; v < object.visual.vertices.first + object.visual.meshVertices;
         ++v)
      box.extend(positionOf(geometry->vertices[v], q));
  return box;
}

}  // namespace glenoid
