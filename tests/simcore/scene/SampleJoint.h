// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Joint.h"

namespace glenoid {

/// A bone and a tendon on it: every kind of value that a joint can hold, in a few triangles.
Joint sampleJoint();

/// Values and meshes are the same (a joint has no operator==: its meshes are shared, not owned).
void expectSame(const Joint& a, const Joint& b);

}  // namespace glenoid
