// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/step/Model.h"

namespace glenoid {

/// The state of a running model brought into a changed one: each free object that is in both (same id, same
/// dynamics: rigid with the same surface, or soft with the same mesh) keeps its q and v; every other object
/// starts at `to.start`. Time and step go on. Impulses, which are only a first guess, are kept when the
/// objects are the same ones in the same order.
State carryState(const Model& from, const State& state, const Model& to);

}  // namespace glenoid
