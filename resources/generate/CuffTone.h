// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid::generate {

/// Tone of a resting shoulder, N. A few hundredths of what the muscles can pull: enough to hold a hanging arm's head in its
/// socket with some 60 N (in life: tens of newtons at rest, several hundreds when the arm is lifted: Bergmann et al., J.
/// Biomech. 40, 2007).
struct Tone {
  double supraspinatus = 15, infraspinatus = 18, subscapularis = 22, biceps = 12;
};

/// The pull of the cuff and of the long head of the biceps as the loads of a scenario, from a joint's own footprints;
/// rounded to 1 mN and 0.1 mm.
///
/// A muscle goes the shortest way from the middle of its insertion round a ball about the head's centre, as wide as that
/// lies from it, to the middle of its origin. Its pull acts on the humerus along the way's tangent at the insertion.
/// Where the way bends it presses: force × change of the tangent, in two equal parts of the bend, which act on the muscle
/// itself, in the middle of its tissue, where it has left its footprint, so that muscle presses on head by contact. Both together are the pull along the
/// tangent at which the way leaves the ball. Source: B. A. Garner, M. G. Pandy, "The obstacle-set method for representing
/// muscle paths", Comput. Methods Biomech. Biomed. Eng. 3(1), 2000.
/// The biceps tendon, pulled from both ends, is pressed into its groove where it turns over the head.
/// Needs the parts and regions of the shoulder that ships.
std::vector<Load> cuffTone(const Joint& joint, const Tone& tone = {});

}  // namespace glenoid::generate
