// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/shape/Field.h"

/// The lower end of a right humerus. Millimetres; frame of the elbow: x lateral, y forward, z proximal, origin in the middle
/// between the epicondyles.
namespace glenoid::shape {

/// What the forearm turns on: in front at the outer side a ball (capitulum), inward of it a spool (trochlea) whose inner lip is
/// larger and reaches lower.
Field elbowRollers(const Frame& elbow);
/// Middle of the axis that they share nearly, in the frame of the elbow.
inline const Vec3 kElbowAxis{0, 5, -7};

/// A shaft that ends between the epicondyles gets both of them, the rollers, and the fossae that take the forearm's bones at the
/// ends of their way.
Field withElbow(Field shaft, const Frame& elbow);

}  // namespace glenoid::shape
