// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/step/Model.h"

namespace glenoid {

/// The state of a running model brought into a changed one, so that an edit changes no bit that it does not edit.
/// Objects are known by id, parts and tools apart.
///   soft with the same tetrahedra   q, v and the rotations of its elements stay, bit for bit;
///   rigid                           its frame and its motion stay, bit for bit unless the mass centre has another place
///                                   in that frame (another surface, another density): q and v are about the centre;
///   fixed in both                   stands where it stood if something moved it, else where the new model puts it;
///   anything else                   starts at `to.start`; what was fixed and is now free starts at rest.
/// Tools keep the last pose of their hands. An impulse stays with its pair of objects and features, however pairs are
/// numbered now, while both objects stay and have the same collision surfaces; so does that of a bursa's film.
/// Time goes on; the step count is that of the time where Δt has changed. Carrying into an equal model changes no bit.
State carryState(const Model& from, const State& state, const Model& to);

}  // namespace glenoid
