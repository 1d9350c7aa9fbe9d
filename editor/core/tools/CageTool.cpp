// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/CageTool.h"

#include <algorithm>

namespace glenoid {

void CageTool::setCage(const Cage* cage) {
  cancel();
  if (!cage) {
    m_triangles.clear();
    m_rest_W.clear();
    m_kept_W.clear();
    m_moved_W.clear();
    m_picked.clear();
    return;
  }
  if (cage->rest_W.size() != m_rest_W.size()) m_picked.clear();
  m_triangles = cage->triangles;
  m_rest_W = cage->rest_W;
  m_kept_W = m_moved_W = cage->moved_W;
}

void CageTool::pick(std::set<int> handles) {
  m_picked = std::move(handles);
  std::erase_if(m_picked, [this](int i) { return i < 0 || i >= static_cast<int>(m_moved_W.size()); });
}

Vec3 CageTool::middle() const {
  Vec3 sum = Vec3::Zero();
  for (const int i : m_picked) sum += m_moved_W[i] / static_cast<double>(m_picked.size());
  return sum;
}

Vec3 CageTool::meanShift() const {
  Vec3 sum = Vec3::Zero();
  for (const int i : m_picked) sum += (m_moved_W[i] - m_rest_W[i]) / static_cast<double>(m_picked.size());
  return sum;
}

std::vector<Vec3> CageTool::withMeanShift(const Vec3& shift_W) const {
  std::vector<Vec3> moved = m_moved_W;
  const Vec3 by = shift_W - meanShift();
  for (const int i : m_picked) moved[i] += by;
  return moved;
}

void CageTool::press(const Viewport& viewport, const Pointer& pointer) {
  cancel();
  if (!hasCage()) return;
  if (!m_picked.empty() && !pointer.shift && !pointer.ctrl) {
    m_gizmo.emplace(viewport, middle());
    m_grip = m_gizmo->at(pointer.at);
    m_from = pointer.at;
    if (m_grip != Gizmo::Grip::None) return;
    m_gizmo.reset();
  }
  m_before = m_picked;
  m_subtract = pointer.ctrl;
  if (!pointer.shift && !pointer.ctrl) m_picked.clear();
  m_stroke.emplace(m_mode, pointer.at, m_radius);
  if (m_mode == PickMode::Brush) mark(viewport);
}

void CageTool::mark(const Viewport& viewport) {
  // A click takes the handle nearest to it, not every one within reach.
  int nearest = -1;
  double best = 1e30;
  for (int i = 0; i < static_cast<int>(m_moved_W.size()); ++i) {
    const auto pixel = projected(viewport.view, m_moved_W[i], viewport.width, viewport.height);
    if (!pixel || !m_stroke->covers(*pixel)) continue;
    if (m_mode == PickMode::Click) {
      const double distance = (*pixel - m_stroke->last()).norm();
      if (distance < best) best = distance, nearest = i;
    } else if (m_subtract) {
      m_picked.erase(i);
    } else {
      m_picked.insert(i);
    }
  }
  if (nearest < 0) return;
  if (m_subtract)
    m_picked.erase(nearest);
  else
    m_picked.insert(nearest);
}

void CageTool::move(const Viewport& viewport, const Pointer& pointer) {
  if (m_grip != Gizmo::Grip::None) {
    m_moved_W = m_kept_W;
    const Vec3 by = m_gizmo->shift(m_grip, m_from, pointer.at);
    for (const int i : m_picked) m_moved_W[i] += by;
  } else if (m_stroke) {
    m_stroke->extend(pointer.at);
    if (m_mode == PickMode::Brush) mark(viewport);
  } else if (!m_picked.empty()) {
    m_hot = Gizmo(viewport, middle()).at(pointer.at);
  }
}

CageTool::Done CageTool::release(const Viewport& viewport, const Pointer& pointer) {
  if (m_grip != Gizmo::Grip::None) {
    move(viewport, pointer);
    m_grip = Gizmo::Grip::None;
    m_gizmo.reset();
    return m_moved_W == m_kept_W ? Done::Nothing : Done::Moved;
  }
  if (!m_stroke) return Done::Nothing;
  if ((pointer.at - m_stroke->last()).norm() > 0) m_stroke->extend(pointer.at);
  mark(viewport);
  m_stroke.reset();
  return m_picked == m_before ? Done::Nothing : Done::Picked;
}

void CageTool::cancel() {
  if (m_stroke) m_picked = m_before;
  m_before.clear();
  m_stroke.reset();
  m_grip = Gizmo::Grip::None;
  m_gizmo.reset();
  m_moved_W = m_kept_W;
}

std::vector<Strokes> CageTool::strokes(const Viewport& viewport) const {
  if (!hasCage()) return {};
  Strokes cage;
  cage.linePx = 1.2f;
  cage.dotPx = 8;
  cage.hiddenStrength = 0.45f;
  for (const auto& t : m_triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (a > b) continue;  // of a closed surface every edge comes once each way
      for (const int end : {a, b})
        cage.lines.push_back({m_moved_W[end].cast<float>(), {0.35f, 0.75f, 0.95f, 0.8f}});
    }
  for (int i = 0; i < static_cast<int>(m_moved_W.size()); ++i) {
    const bool on = m_picked.count(i) > 0;
    cage.dots.push_back({m_moved_W[i].cast<float>(), on ? std::array<float, 4>{1.0f, 0.60f, 0.15f, 1}
                                                        : std::array<float, 4>{0.55f, 0.85f, 1.0f, 1}});
  }
  std::vector<Strokes> all;
  all.push_back(std::move(cage));
  if (!m_picked.empty() && !m_stroke) {
    // While dragged the arrows go with the handles, though the drag is measured where it began.
    all.push_back(Gizmo(viewport, middle()).strokes(isDragging() ? m_grip : m_hot));
  }
  return all;
}

}  // namespace glenoid
