// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "simcore/base/Error.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// A point of an object as it lies in the rest frame, followed through a run: of a tool in the tool's own frame (its tip
/// is zero), of a part in W at rest. On a soft part it is carried by the tetrahedron that holds it or lies nearest.
class CarriedPoint {
 public:
  CarriedPoint() = default;
  /// `object`: −1: a point of the room, which stays.
  CarriedPoint(const Model& model, int object, const Vec3& rest);
  /// W, m. `model`: the one it was made of.
  Vec3 at(const Model& model, const VecX& q) const;

 private:
  int m_object = -1;
  Vec3 m_rest = Vec3::Zero();
  SurfaceBinding m_binding;  ///< one vertex, no mesh
};

/// A place of a task bound to what carries it. The model must outlive it.
class BoundPlace {
 public:
  /// Fails with UnknownId (arguments: id and "part", "region" or "landmark").
  static Result<BoundPlace> bind(const Model& model, const TaskPlace& place);

  int object() const { return m_object; }  ///< −1: in the room
  /// Landmark or point; of a region the mean of its corners, of a whole part its middle at rest. W, m.
  Vec3 point(const VecX& q) const;
  /// From what somebody touches on the part to the place: zero anywhere on a region or on a whole part. m.
  double distanceTo(const Vec3& touched_W, const VecX& q) const;
  /// Unit, W: of a ring, turned as its part has turned about the place.
  Vec3 normal(const VecX& q) const;

 private:
  explicit BoundPlace(const Model& model) : m_model(&model) {}
  const Model* m_model;
  int m_object = -1;
  bool m_anywhere = false;             ///< a whole part
  CarriedPoint m_point, m_ahead;       ///< m_ahead: a millimetre along the normal
  SurfaceBinding m_region;             ///< its corners; empty: no region
  std::vector<std::array<int, 3>> m_triangles;  ///< of those corners
};

}  // namespace glenoid
