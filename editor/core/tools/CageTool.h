// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <set>

#include "editor/core/tools/Gizmo.h"
#include "editor/core/tools/PickStroke.h"
#include "simcore/scene/Cage.h"

namespace glenoid {

/// Picks and drags the handles of a cage with the mouse. Handles are picked as triangles are (click, box,
/// lasso, brush; Shift adds, Ctrl subtracts), all of them being in sight; those picked are moved together by
/// a gizmo in their middle. A state machine without window. Frame W, metres.
class CageTool {
 public:
  /// The cage as the document has it; handles stay picked while there are as many.
  void setCage(const Cage* cage);
  bool hasCage() const { return !m_rest_W.empty(); }
  void setMode(PickMode mode) { m_mode = mode; }
  void setRadius(double pixels) { m_radius = pixels; }

  const std::set<int>& picked() const { return m_picked; }
  void pick(std::set<int> handles);
  /// Where the handles stand, with the drag that is under way.
  const std::vector<Vec3>& moved_W() const { return m_moved_W; }
  /// Mean of the picked handles' shifts from rest, m.
  Vec3 meanShift() const;
  /// Handles with the picked ones moved on, so that their mean shift is this.
  std::vector<Vec3> withMeanShift(const Vec3& shift_W) const;

  void press(const Viewport& viewport, const Pointer& pointer);
  void move(const Viewport& viewport, const Pointer& pointer);
  enum class Done { Nothing, Picked, Moved };
  Done release(const Viewport& viewport, const Pointer& pointer);
  void cancel();
  bool busy() const { return m_stroke || m_grip != Gizmo::Grip::None; }
  bool isDragging() const { return m_grip != Gizmo::Grip::None; }

  const PickStroke* stroke() const { return m_stroke ? &*m_stroke : nullptr; }
  /// Edges, handles and, where some are picked, the gizmo.
  std::vector<Strokes> strokes(const Viewport& viewport) const;

 private:
  Vec3 middle() const;
  void mark(const Viewport& viewport);

  std::vector<std::array<int, 3>> m_triangles;
  std::vector<Vec3> m_rest_W, m_kept_W, m_moved_W;  ///< kept: as the document has them
  std::set<int> m_picked, m_before;
  PickMode m_mode = PickMode::Click;
  double m_radius = 16;
  std::optional<PickStroke> m_stroke;
  bool m_subtract = false;
  Gizmo::Grip m_grip = Gizmo::Grip::None, m_hot = Gizmo::Grip::None;
  std::optional<Gizmo> m_gizmo;  ///< of the drag under way: it does not follow itself
  Vec2 m_from = Vec2::Zero();
};

}  // namespace glenoid
