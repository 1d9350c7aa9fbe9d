// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of a frame, in the order in which they are laid down: opaque surfaces, lines, transparent
// surfaces from far to near (of each only its front layer), and what is hidden of springs and contacts once
// more, faintly.
#include <algorithm>
#include <cmath>

#include "editor/render/SceneRendererInside.h"

namespace glenoid {
namespace {

constexpr float kLift = 1.2e-3f;  ///< of lines above the surface they lie on, share of the distance

Eigen::Vector4f withAlpha(const Eigen::Vector3f& color, float alpha) {
  return {color.x(), color.y(), color.z(), alpha};
}

Eigen::Vector3f colorOf(const ObjectGeometry& object) {
  return linearColor(object.color[0], object.color[1], object.color[2]);
}

/// Colour of a named region by what it is.
Eigen::Vector3f regionColor(const std::string& kind) {
  if (kind == "footprint") return linearColor(0.85f, 0.33f, 0.20f);
  if (kind == "cartilage") return linearColor(0.45f, 0.72f, 0.85f);
  if (kind == "tendon") return linearColor(0.93f, 0.90f, 0.78f);
  if (kind == "landmark") return linearColor(0.55f, 0.35f, 0.75f);
  if (kind == "groove") return linearColor(0.95f, 0.72f, 0.20f);
  return linearColor(0.30f, 0.65f, 0.45f);
}

}  // namespace

void SceneRenderer::Inside::triangles(Range indices) {
  glDrawElements(
      GL_TRIANGLES, indices.count, GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(static_cast<std::size_t>(indices.first) * sizeof(std::uint32_t)));
}

void SceneRenderer::Inside::drawFilled(const Shown& shown, const Eye& eye, const Layers& layers) {
  const ObjectGeometry& object = scene.objects[shown.object];
  const ObjectLook look = layers.lookOf(shown.object);
  const bool field = hasFieldLook(shown, layers);
  const Program& program = field ? fieldSurface : *surface;
  program.use();
  if (field) {
    const bool has = valued[shown.object];
    program.set("valued", has ? 1 : 0);
    program.set("scale", 0);
    program.set("ends", static_cast<float>(layers.field->low), static_cast<float>(layers.field->high));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_1D, scaleTexture.id());
  }
  glBindVertexArray(evaluator.surfaces());
  program.set("worldToView", eye.worldToView);
  program.set("viewToClip", eye.viewToClip);
  program.set("up_V", eye.up_V);
  if (field) {
    program.set("color", linearColor(kNeutralColor[0], kNeutralColor[1], kNeutralColor[2]));
  } else {
    program.set("color", look.color ? linearColor((*look.color)[0], (*look.color)[1], (*look.color)[2]) : colorOf(object));
  }
  program.set("opacity", look.opacity);
  if (scope && !field) {
    program.set("reach", static_cast<float>(scope->reach));
    program.set("fog", static_cast<float>(std::clamp(scope->haze, 0.0, 1.0) * 0.6931 / std::max(scope->reach, 1e-6)));
  }
  program.set("faceted", shown.kind == SurfaceKind::Collision ? 1 : 0);
  const bool plain = shown.kind == SurfaceKind::Collision;
  program.set("occluded", occluded && !plain ? 1.0f : 0.0f);
  program.set("shafts", occluded && !plain && !object.tool ? shafts : 0);
  program.set("roughness", object.roughness);
  program.set("wet", plain ? 0.0f : object.wet);
  program.set("grain", plain ? 0 : static_cast<int>(object.grain));
  Eigen::Vector4f tint = Eigen::Vector4f::Zero();
  if (look.hovered) tint = withAlpha(linearColor(1.0f, 0.90f, 0.70f), 0.16f);
  if (look.selected) tint = withAlpha(linearColor(1.0f, 0.62f, 0.18f), 0.26f);
  program.set("tint", tint);

  if (look.opacity >= 1) {
    glDepthFunc(GL_LESS);
    triangles(object.surface(shown.kind).triangles);
  } else {
    // First its depth alone, then its colour where that depth won: one layer, whatever the order of its
    // triangles.
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_LESS);
    triangles(object.surface(shown.kind).triangles);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    triangles(object.surface(shown.kind).triangles);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
  }
  drawOverlays(shown, layers, program);
  if (field) glBindTexture(GL_TEXTURE_1D, 0);
}

/// Regions and marks on a surface that has just been drawn: the same triangles again, at the same depth.
void SceneRenderer::Inside::drawOverlays(const Shown& shown, const Layers& layers, const Program& program) {
  const bool marked = std::any_of(layers.marks.begin(), layers.marks.end(), [&](const TriangleMark& m) {
    return m.object == shown.object && m.surface == shown.kind;
  });
  if (!layers.regions && !marked) return;
  const SurfaceRanges& ranges = scene.objects[shown.object].surface(shown.kind);
  program.set("tint", Eigen::Vector4f(0, 0, 0, 0));
  program.set("grain", 0);
  program.set("valued", 0);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  if (layers.regions)
    for (const RegionRanges& region : scene.regions) {
      if (region.object != shown.object || region.surface != shown.kind) continue;
      program.set("color", regionColor(region.kind));
      program.set("opacity", 0.72f);
      triangles(region.triangles);
    }
  std::vector<GLsizei> counts;
  std::vector<const void*> offsets;
  for (const TriangleMark& mark : layers.marks) {
    if (mark.object != shown.object || mark.surface != shown.kind) continue;
    counts.clear();
    offsets.clear();
    int next = -1;  // after the run so far: neighbours in the list are one draw
    for (const int t : mark.triangles) {
      if (t < 0 || 3 * t >= ranges.triangles.count) continue;
      if (t == next) {
        counts.back() += 3;
      } else {
        counts.push_back(3);
        offsets.push_back(
            reinterpret_cast<const void*>(static_cast<std::size_t>(ranges.triangles.first + 3 * t) * 4));
      }
      next = t + 1;
    }
    program.set("color", linearColor(mark.color[0], mark.color[1], mark.color[2]));
    program.set("opacity", 0.85f);
    if (!counts.empty())
      glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                          static_cast<GLsizei>(counts.size()));
  }
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void SceneRenderer::Inside::drawScene(const Eye& eye, const Layers& layers,
                                      std::span<const ContactView> contacts, double strokeScale) {
  const std::vector<Shown> shown = shownSurfaces(layers);
  painter.begin(eye.worldToClip, frame.width() * frame.factor(), frame.height() * frame.factor(),
                eye.depthScale());
  glEnable(GL_DEPTH_TEST);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  std::vector<std::pair<double, Shown>> blended;
  for (const Shown& s : shown) {
    if (!s.filled) continue;
    if (layers.lookOf(s.object).opacity >= 1) {
      drawFilled(s, eye, layers);
      continue;
    }
    // By the nearest corner: what encloses another is nearer than it and comes later.
    double nearest = 1e30;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p = boxes[s.object].corner(static_cast<Box3::CornerType>(corner));
      const Eigen::Vector4f p_V = eye.worldToView * Eigen::Vector4f(p.cast<float>().homogeneous());
      nearest = std::min(nearest, static_cast<double>(-p_V.z()));
    }
    blended.push_back({nearest, s});
  }

  const auto strokes = [&](float strength, GLenum test) {
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glDepthFunc(test);
    if (layers.couplings) drawSprings(layers, strokeScale, strength);
    if (layers.contacts) drawContacts(layers, contacts, strokeScale, strength);
    if (!layers.strokes.empty()) drawStrokes(layers, strokeScale, test == GL_GREATER);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
  };
  strokes(1, GL_LEQUAL);
  drawEdges(shown, layers, strokeScale);
  std::stable_sort(blended.begin(), blended.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [distance, s] : blended) drawFilled(s, eye, layers);
  if (layers.couplings || layers.contacts || !layers.strokes.empty()) strokes(0.35f, GL_GREATER);
  glDepthFunc(GL_LESS);
  glDisable(GL_DEPTH_TEST);
}

void SceneRenderer::Inside::drawEdges(const std::vector<Shown>& shown, const Layers& layers, double scale) {
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_LEQUAL);
  for (const Shown& s : shown) {
    if (!s.edges) continue;
    const ObjectGeometry& object = scene.objects[s.object];
    const Eigen::Vector3f ink = 0.18f * colorOf(object);
    painter.linesByIndex(evaluator.points(), object.collision.edges,
                         withAlpha(ink, 0.75f * std::min(1.0f, layers.lookOf(s.object).opacity)),
                         {static_cast<float>(0.9 * scale), kLift, 1});
  }
  if (layers.dynamics)
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const ObjectGeometry& object = scene.objects[i];
      const ObjectLook look = layers.lookOf(static_cast<int>(i));
      if (!look.visible || object.tetEdges.count == 0) continue;
      const Eigen::Vector3f ink = 0.55f * colorOf(object);
      const Stroke stroke{static_cast<float>(1.0 * scale), 0, 1};
      painter.linesByIndex(evaluator.points(), object.tetEdges, withAlpha(ink, 0.9f), stroke);
      if (!layers.visual) continue;
      glDepthFunc(GL_GREATER);  // inside the opaque surface: a hint of it
      painter.linesByIndex(evaluator.points(), object.tetEdges, withAlpha(ink, 0.16f), stroke);
      glDepthFunc(GL_LEQUAL);
    }
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void SceneRenderer::Inside::drawSprings(const Layers& layers, double scale, float strength) {
  Eigen::Vector3f line = linearColor(0.10f, 0.55f, 0.62f), end = linearColor(0.16f, 0.78f, 0.80f);
  // Runs of springs whose objects are both shown.
  const auto seen = [&](int object) { return layers.lookOf(object).visible; };
  const int springs = scene.springs.count / 2;
  for (int first = 0; first < springs;) {
    int last = first;
    while (last < springs && seen(scene.springObjects[last][0]) && seen(scene.springObjects[last][1]) &&
           (!layers.islands || scene.springObjects[last] == scene.springObjects[first]))
      ++last;
    const Range run{scene.springs.first + 2 * first, 2 * (last - first)};
    if (layers.islands && last > first) {  // a fixed part has no island; then the other one's colour
      auto own = layers.lookOf(scene.springObjects[first][0]).color;
      if (!own) own = layers.lookOf(scene.springObjects[first][1]).color;
      if (own) line = end = linearColor((*own)[0], (*own)[1], (*own)[2]);
    }
    painter.lines(evaluator.points(), run, withAlpha(line, 0.95f),
                  {static_cast<float>(1.6 * scale), kLift, strength});
    painter.dots(evaluator.points(), run, withAlpha(end, 1),
                 {static_cast<float>(4.0 * scale), kLift, strength});
    first = std::max(last, first + 1);
  }
}

void SceneRenderer::Inside::drawContacts(const Layers& layers, std::span<const ContactView> contacts,
                                         double scale, float strength) {
  const Eigen::Vector4f idle = withAlpha(linearColor(0.98f, 0.86f, 0.30f), 0.9f);
  const Eigen::Vector4f active = withAlpha(linearColor(0.92f, 0.16f, 0.12f), 1);
  std::vector<ColoredPoint> points, normals;
  for (const ContactView& contact : contacts) {
    if (!layers.lookOf(std::max(contact.objectA, 0)).visible &&
        !layers.lookOf(std::max(contact.objectB, 0)).visible)
      continue;
    if (!contact.point_W.allFinite() || !contact.normal_W.allFinite()) continue;
    // 2 mm without force; with force 4 mm for each tenfold above a hundredth of a newton: 10 N gives 14 mm.
    const double length = contact.force > 0 ? 0.002 + 0.004 * std::log10(1 + 100 * contact.force) : 0.002;
    const Eigen::Vector4f& color = contact.force > 0 ? active : idle;
    const Vec3 tip = contact.point_W + length * contact.normal_W;
    points.push_back({contact.point_W.cast<float>(), color});
    normals.push_back({contact.point_W.cast<float>(), color});
    normals.push_back({tip.cast<float>(), color});
  }
  painter.lines(normals, {static_cast<float>(1.8 * scale), kLift, strength});
  painter.dots(points, {static_cast<float>(4.5 * scale), kLift, strength});
}

void SceneRenderer::Inside::drawMask(const Eye& eye, const Layers& layers) {
  frame.bindMask();
  mask.use();
  mask.set("worldToView", eye.worldToView);
  mask.set("viewToClip", eye.viewToClip);
  glBindVertexArray(evaluator.surfaces());
  for (const bool selected : {false, true})  // selected last: it wins where both are
    for (const Shown& s : shownSurfaces(layers)) {
      const ObjectLook look = layers.lookOf(s.object);
      if (!s.filled || (selected ? !look.selected : !look.hovered || look.selected)) continue;
      mask.set("amount", selected ? 1.0f : 0.5f);
      triangles(scene.objects[s.object].surface(s.kind).triangles);
    }
}

namespace {

std::vector<ColoredPoint> pointsOf(const std::vector<Strokes::End>& ends) {
  std::vector<ColoredPoint> points;
  points.reserve(ends.size());
  for (const Strokes::End& end : ends)
    points.push_back({end.at, withAlpha(linearColor(end.color[0], end.color[1], end.color[2]), end.color[3])});
  return points;
}

}  // namespace

void SceneRenderer::Inside::drawStrokes(const Layers& layers, double scale, bool hidden) {
  for (const Strokes& strokes : layers.strokes) {
    const float strength = hidden ? strokes.hiddenStrength : 1;
    if (strokes.onScreen || strength <= 0) continue;
    painter.lines(pointsOf(strokes.lines), {static_cast<float>(strokes.linePx * scale), kLift, strength});
    painter.dots(pointsOf(strokes.dots), {static_cast<float>(strokes.dotPx * scale), kLift, strength});
  }
}

void SceneRenderer::Inside::drawScreenStrokes(const Layers& layers, const Look& look, const Target& target) {
  Eigen::Matrix4f pixels = Eigen::Matrix4f::Identity();
  const float ratio = static_cast<float>(std::max(look.pixelRatio, 0.1));
  pixels(0, 0) = 2 * ratio / static_cast<float>(target.width);
  pixels(1, 1) = -2 * ratio / static_cast<float>(target.height);
  pixels(0, 3) = -1;
  pixels(1, 3) = 1;
  painter.begin(pixels, target.width, target.height, 0);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (const Strokes& strokes : layers.strokes) {
    if (!strokes.onScreen) continue;
    painter.lines(pointsOf(strokes.lines), {strokes.linePx * ratio, 0, 1});
    painter.dots(pointsOf(strokes.dots), {strokes.dotPx * ratio, 0, 1});
  }
  glDisable(GL_BLEND);
}

}  // namespace glenoid
