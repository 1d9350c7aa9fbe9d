// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
namespace glenoid {

/// On which side of the body a joint lies. W is the body's whatever the side: X forward, Y up, Z to the right; so lateral
/// is +Z of a right joint and −Z of a left one. Unsaid: shown as a right one, of the spine or of no body.
enum class JointSide { Unsaid, Left, Right };

/// +1 where lateral is +Z of W, −1 where it is −Z.
inline int lateralSign(JointSide side) { return side == JointSide::Left ? -1 : 1; }

/// The other side; what says none stays.
inline JointSide otherSide(JointSide side) {
  return side == JointSide::Left ? JointSide::Right : side == JointSide::Right ? JointSide::Left : JointSide::Unsaid;
}

}  // namespace glenoid
