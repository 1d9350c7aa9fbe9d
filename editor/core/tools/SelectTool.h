// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "editor/core/tools/PickMap.h"
#include "editor/core/tools/PickStroke.h"
#include "editor/core/tools/Viewport.h"
#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Picks triangles of one surface, or nodes of a part's cells, with the mouse: what is under a click, in a box or a
/// lasso, or under a brush. Shift adds to what was selected, Ctrl takes from it, neither begins anew; Alt also takes what is
/// hidden or turned away. A state machine without window: press, moves, release. Frame W at rest.
class SelectTool {
 public:
  /// What is picked from, and what may hide it. Ends a stroke that is under way.
  void setTarget(std::shared_ptr<const TriMesh> surface, std::vector<std::shared_ptr<const TriMesh>> others);
  void setNodes(std::shared_ptr<const TetMesh> cells, std::vector<std::shared_ptr<const TriMesh>> others);
  void setMode(PickMode mode) { m_mode = mode; }
  PickMode mode() const { return m_mode; }
  /// Of the brush, pixels, kept within 2…200.
  void setRadius(double radius);
  double radius() const { return m_radius; }

  /// Begins a stroke on what is selected so far (ascending).
  void press(const Viewport& viewport, const Pointer& pointer, const std::vector<int>& selected);
  void move(const Pointer& pointer);
  /// Ends it; what is selected now, ascending. Meaningless without a press before.
  std::vector<int> release(const Pointer& pointer);
  void cancel() { m_stroke.reset(); }
  bool busy() const { return m_stroke.has_value(); }

  /// What is selected while a stroke is under way, ascending.
  std::vector<int> now() const;
  const PickStroke* stroke() const { return m_stroke ? &*m_stroke : nullptr; }

 private:
  void set(std::shared_ptr<const TriMesh> surface, std::shared_ptr<const TetMesh> cells, std::vector<std::shared_ptr<const TriMesh>> others);
  const PickMap& mapFor(const Viewport& viewport);
  void mark();

  std::shared_ptr<const TriMesh> m_surface;  ///< null: nodes are picked, or nothing
  std::shared_ptr<const TetMesh> m_cells;
  std::vector<std::shared_ptr<const TriMesh>> m_others;
  PickMode m_mode = PickMode::Brush;
  double m_radius = 16;
  std::optional<PickStroke> m_stroke;
  bool m_subtract = false, m_through = false;
  std::vector<char> m_flags;
  std::unique_ptr<PickMap> m_map;
  Viewport m_viewport;
};

}  // namespace glenoid
