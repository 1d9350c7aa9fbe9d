// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/step/Model.h"

namespace glenoid {

/// Where an arthroscope looks from, and where to.
struct ScopeView {
  Vec3 lens_W = Vec3::Zero();    ///< m: the tip
  Vec3 axis_W = -Vec3::UnitZ();  ///< unit, the middle of the picture (ScopeOptics.h)
  Vec3 up_W = Vec3::UnitX();     ///< unit, what is up in it
};

/// The view of a tool, by its lens and light post.
ScopeView scopeView(const Model& model, const VecX& q, int tool);

/// Whether nothing of any part or of another tool lies between a lens and a point, on collision surfaces; what is nearer to
/// the point than `tolerance` does not hide it. `tool`: whose lens it is; its own surface hides nothing.
bool inSight(const Model& model, const VecX& q, int tool, const Vec3& from_W, const Vec3& to_W, double tolerance);

}  // namespace glenoid
