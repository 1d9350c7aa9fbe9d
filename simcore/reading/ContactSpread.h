// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// Contact forces, which act at points, as a force for each area of the visual surfaces, Pa: values by object and vertex, as
/// SurfaceValues. Parts have them, rigid ones too; tools have none.
/// Each contact's normal force F (friction is left out; a bursa's film counts) goes to the vertices around, once on each of its
/// two parts, in shares of
///   A_v max(0, n_v · m) (1 − d²/h²)²,  d < h,
/// d from the contact's point, n_v the vertex' normal, m the way out of the part along the contact's normal, so that the far
/// side of a thin part has none; A_v a third of the area of the triangles around. Where no vertex is that near, the nearest
/// takes it all. The radius h is the larger of both parts' spreadRadius: what one contact of the collision surfaces stands for.
/// So Σ A_v p_v over a part is the sum of the forces of its contacts (spreadSum), to round-off, whatever the mesh. A peak is the
/// kernel's where a single contact presses: 3 F / (π h²).
std::vector<std::vector<float>> spreadContacts(const Model& model, const VecX& q, std::span<const ContactView> contacts);

/// One and a half mean edges of an object's collision surface, but at least two of its visual surface, m.
double spreadRadius(const SceneObject& object);

/// Σ A_v p_v over an object, N.
double spreadSum(const Model& model, const VecX& q, const std::vector<std::vector<float>>& values, int object);

}  // namespace glenoid
