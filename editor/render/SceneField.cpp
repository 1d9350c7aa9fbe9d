// SPDX-License-Identifier: GPL-3.0-or-later
// Values on surfaces: what of them goes to the GPU, and when.
#include <cmath>

#include "editor/render/SceneRendererInside.h"

namespace glenoid {

bool SceneRenderer::Inside::hasFieldLook(const Shown& shown, const Layers& layers) const {
  return layers.field && shown.kind == SurfaceKind::Visual && !scene.objects[shown.object].tool && valued.size() == scene.objects.size();
}

void SceneRenderer::Inside::updateField(const FieldLook& field) {
  if (field.values != fieldSent || valued.size() != scene.objects.size()) {
    valued.assign(scene.objects.size(), 0);
    std::vector<float> byVertex(scene.vertices.size(), 0.0f);
    for (std::size_t i = 0; field.values && i < scene.objects.size() && i < field.values->size(); ++i) {
      const std::vector<float>& own = (*field.values)[i];
      const SurfaceRanges& visual = scene.objects[i].visual;
      if (!visual.present || own.empty() || static_cast<int>(own.size()) != visual.meshVertices) continue;
      valued[i] = 1;
      for (int v = visual.vertices.first; v < visual.vertices.first + visual.vertices.count; ++v) {
        const float value = own[scene.source[v]];
        byVertex[v] = std::isfinite(value) ? value : 0.0f;
      }
    }
    evaluator.setField(byVertex);
    fieldSent = field.values;
  }
  const std::array<double, 3> scale{field.low, field.high, field.zeroIsNone ? 1.0 : 0.0};
  if (scale == scaleSent) return;
  scaleSent = scale;
  // A scale of 1024 colours: what is interpolated between them is no step to the eye.
  constexpr int kEntries = 1024;
  std::vector<std::array<float, 3>> colors(kEntries);
  for (int i = 0; i < kEntries; ++i) colors[i] = colorOf(field, field.low + (field.high - field.low) * i / (kEntries - 1.0));
  glBindTexture(GL_TEXTURE_1D, scaleTexture.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB32F, kEntries, 0, GL_RGB, GL_FLOAT, colors.data());
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_1D, 0);
}

}  // namespace glenoid
