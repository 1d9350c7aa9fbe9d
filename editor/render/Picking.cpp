// SPDX-License-Identifier: GPL-3.0-or-later
// Picking by drawing numbers instead of colours, into a target no larger than what is asked for.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "editor/render/SceneRendererInside.h"

namespace glenoid {

bool SceneRenderer::Inside::pickInto(const View& view, const VecX& q, const Layers& layers,
                                     const Target& target, int x0, int y0, int width, int height) {
  if (!fits(q) || !pickTarget.resize(width, height)) return false;
  updateBoxes(q);
  evaluate(q, layers.dents, visuallyShown(layers));
  const Eye eye = eyeFor(view, layers, static_cast<double>(target.width) / target.height);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  pickTarget.bind();
  // The whole window, shifted so that the wanted pixels fall on the small target; rows count from below.
  glViewport(-x0, -(target.height - y0 - height), target.width, target.height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  pick.use();
  pick.set("worldToView", eye.worldToView);
  pick.set("viewToClip", eye.viewToClip);
  glBindVertexArray(evaluator.surfaces());
  for (const Shown& s : shownSurfaces(layers)) {
    if (!s.filled) continue;
    pick.set("object", s.object);
    pick.set("surface", static_cast<int>(s.kind));
    triangles(scene.objects[s.object].surface(s.kind).triangles);
  }
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(0);
  glUseProgram(0);
  return true;
}

namespace {

struct Seen {
  std::vector<std::array<GLint, 4>> what;
  std::vector<std::array<float, 4>> where, normal;
};

Seen readSeen(int width, int height) {
  const std::size_t count = static_cast<std::size_t>(width) * height;
  Seen seen{std::vector<std::array<GLint, 4>>(count), std::vector<std::array<float, 4>>(count),
            std::vector<std::array<float, 4>>(count)};
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(0, 0, width, height, GL_RGBA_INTEGER, GL_INT, seen.what.data());
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, seen.where.data());
  glReadBuffer(GL_COLOR_ATTACHMENT2);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, seen.normal.data());
  return seen;
}

PickHit hitOf(const Seen& seen, std::size_t i, const View& view) {
  PickHit hit;
  hit.object = seen.what[i][0] - 1;
  hit.surface = static_cast<SurfaceKind>(seen.what[i][1]);
  hit.triangle = seen.what[i][2];
  hit.point_W = Vec3(seen.where[i][0], seen.where[i][1], seen.where[i][2]);
  hit.normal_W = Vec3(seen.normal[i][0], seen.normal[i][1], seen.normal[i][2]);
  if (hit.normal_W.dot(view.eye_W - hit.point_W) < 0) hit.normal_W = -hit.normal_W;
  return hit;
}

}  // namespace

std::optional<PickHit> SceneRenderer::pick(const View& view, const VecX& q, const Layers& layers,
                                           const Target& target, double x, double y) {
  if (!(x >= 0 && y >= 0 && x < target.width && y < target.height)) return std::nullopt;
  if (!m_inside->pickInto(view, q, layers, target, static_cast<int>(x), static_cast<int>(y), 1, 1))
    return std::nullopt;
  const Seen seen = readSeen(1, 1);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  if (seen.what[0][0] == 0) return std::nullopt;
  return hitOf(seen, 0, view);
}

std::vector<PickHit> SceneRenderer::pickRectangle(const View& view, const VecX& q, const Layers& layers,
                                                  const Target& target, int x0, int y0, int x1, int y1) {
  std::vector<PickHit> hits;
  x0 = std::max(x0, 0), y0 = std::max(y0, 0);
  x1 = std::min(x1, target.width - 1), y1 = std::min(y1, target.height - 1);
  if (x0 > x1 || y0 > y1) return hits;
  const int width = x1 - x0 + 1, height = y1 - y0 + 1;
  if (!m_inside->pickInto(view, q, layers, target, x0, y0, width, height)) return hits;
  const Seen seen = readSeen(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  for (std::size_t i = 0; i < seen.what.size(); ++i)
    if (seen.what[i][0] != 0) hits.push_back(hitOf(seen, i, view));
  const auto key = [](const PickHit& h) {
    return std::tuple(h.object, static_cast<int>(h.surface), h.triangle);
  };
  std::stable_sort(hits.begin(), hits.end(),
                   [&](const PickHit& a, const PickHit& b) { return key(a) < key(b); });
  hits.erase(std::unique(hits.begin(), hits.end(),
                         [&](const PickHit& a, const PickHit& b) { return key(a) == key(b); }),
             hits.end());
  return hits;
}

}  // namespace glenoid
