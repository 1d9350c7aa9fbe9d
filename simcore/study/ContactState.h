// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/live/Run.h"

namespace glenoid {

/// A scene to be measured, not yet compiled, and the hands that move in it.
struct StudyScene {
  Joint joint;
  Scenario scenario;
  Recording input;
};

/// A moment of a scene with about a wanted number of contacts.
struct ContactState {
  int wanted = 0, pressingWanted = 0;
  int contacts = 0, pressing = 0;
  double time = 0;             ///< s of the input
  double contactDistance = 0;  ///< m, of the scenario that gives this many contacts
  double loadFactor = 1;       ///< by which the scenario's loads were multiplied
  bool distanceChanged = false;  ///< against the scenario as it is shipped
  std::string mark;            ///< of the recording, what the hands were doing
  State state;                 ///< before the step
  Inputs inputs;               ///< of that step
};

/// What to look for: a number of contacts and how many of them press at least, under so many times the scenario's loads.
struct ContactWish {
  int contacts = 65, pressing = 0;
  double loadFactor = 1;
};

/// Plays the input once for each load factor and keeps, for each wish, the step nearest to it during which a hand presses
/// (inside a mark of the recording, with at least one pressing contact): by what is off in the number of contacts and what
/// is missing of those that press together; of equals the one with most pressing contacts. Where the number of contacts
/// misses by more than a few hundredths, the contact distance is changed by bisection, at most tenfold either way,
/// the state staying the same: more or fewer features count as near. The answer says what it took. Fails as
/// compileModel does, with Unusable for an input that never presses, with Cancelled.
Result<std::vector<ContactState>> findContactStates(const StudyScene& scene, const std::vector<ContactWish>& wanted,
                                                    const std::function<bool(double)>& progress = {});

/// The scene with the contact distance and the loads of a state.
Scenario scenarioOf(const StudyScene& scene, const ContactState& state);

}  // namespace glenoid
