// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/SelectTool.h"

#include <algorithm>

#include "editor/core/tools/NodeMap.h"
#include "editor/core/tools/ScreenMap.h"

namespace glenoid {

void SelectTool::setTarget(std::shared_ptr<const TriMesh> surface,
                           std::vector<std::shared_ptr<const TriMesh>> others) {
  set(std::move(surface), nullptr, std::move(others));
}

void SelectTool::setNodes(std::shared_ptr<const TetMesh> cells, std::vector<std::shared_ptr<const TriMesh>> others) {
  set(nullptr, std::move(cells), std::move(others));
}

void SelectTool::set(std::shared_ptr<const TriMesh> surface, std::shared_ptr<const TetMesh> cells,
                     std::vector<std::shared_ptr<const TriMesh>> others) {
  if (surface == m_surface && cells == m_cells && others == m_others) return;
  cancel();
  m_surface = std::move(surface);
  m_cells = std::move(cells);
  m_others = std::move(others);
  m_map.reset();
}

void SelectTool::setRadius(double radius) {
  m_radius = std::clamp(radius, 2.0, 200.0);
}

const PickMap& SelectTool::mapFor(const Viewport& viewport) {
  if (!m_map || !sameViewport(viewport, m_viewport)) {
    if (m_cells) m_map = std::make_unique<NodeMap>(viewport, *m_cells, m_others);
    else m_map = std::make_unique<ScreenMap>(viewport, *m_surface, m_others);
    m_viewport = viewport;
  }
  return *m_map;
}

void SelectTool::press(const Viewport& viewport, const Pointer& pointer, const std::vector<int>& selected) {
  cancel();
  if (!m_surface && !m_cells) return;
  const std::size_t count = mapFor(viewport).centres().size();
  m_subtract = pointer.ctrl;
  m_through = pointer.alt;
  m_flags.assign(count, 0);
  if (pointer.shift || pointer.ctrl)
    for (const int t : selected) m_flags[t] = 1;
  m_stroke.emplace(m_mode, pointer.at, m_radius);
  if (m_mode == PickMode::Brush) mark();
}

void SelectTool::move(const Pointer& pointer) {
  if (!m_stroke) return;
  m_stroke->extend(pointer.at);
  if (m_mode == PickMode::Brush) mark();
}

std::vector<int> SelectTool::release(const Pointer& pointer) {
  if (!m_stroke) return {};
  if ((pointer.at - m_stroke->last()).norm() > 0) m_stroke->extend(pointer.at);
  mark();
  std::vector<int> selected = now();
  m_stroke.reset();
  return selected;
}

void SelectTool::mark() {
  const PickStroke& stroke = *m_stroke;
  const char value = m_subtract ? 0 : 1;
  // What is under the cursor, and under its way since the last event: a triangle may be larger than the
  // brush, and its centre alone would miss it.
  if (stroke.mode() == PickMode::Click || (stroke.mode() == PickMode::Brush && m_map->haveExtent())) {
    const Vec2 way =
        stroke.mode() == PickMode::Brush ? Vec2(stroke.last() - stroke.previous()) : Vec2(Vec2::Zero());
    const int steps = 1 + static_cast<int>(way.norm() / 3);
    for (int i = 0; i < steps; ++i)
      if (const int t = m_map->at(stroke.last() - way * i / steps, m_through); t >= 0)
        m_flags[t] = value;
  }
  if (stroke.mode() == PickMode::Click) return;
  const auto& centres = m_map->centres();
  for (std::size_t t = 0; t < centres.size(); ++t)
    if ((m_through || m_map->seen(static_cast<int>(t))) && stroke.covers(centres[t].cast<double>()))
      m_flags[t] = value;
}

std::vector<int> SelectTool::now() const {
  std::vector<int> selected;
  for (std::size_t t = 0; t < m_flags.size(); ++t)
    if (m_flags[t]) selected.push_back(static_cast<int>(t));
  return selected;
}

}  // namespace glenoid
