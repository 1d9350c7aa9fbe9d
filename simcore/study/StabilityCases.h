// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <span>

#include "simcore/study/StabilityBounds.h"
#include "simcore/study/StabilityHands.h"
#include "simcore/study/StabilityShapes.h"

namespace glenoid {

/// What kind of thing is done to a scene that has come to rest; `amount` of its case is in the unit said here.
enum class Ordeal {
  Nothing,       ///< it is left alone
  Hands,         ///< a hand does `play` with its tool; amount: as HandPlay says
  StrongHands,   ///< the same with a virtual coupling ten times as stiff, ten times as strong
  Blow,          ///< a bone gets a velocity at once, m/s
  EndOfRange,    ///< a bone is turned by a torque that would turn it by `amount` rad against its hold, beside twenty times its own weight at its own length
  Speed,         ///< all parts begin with a velocity, m/s, and bones with a turn of ten times as many rad/s
  RandomLoads,   ///< every part is shaken by accelerations up to `amount` m/s², new ones every 50 ms, bones turned likewise
  Gravity,       ///< gravity points somewhere else from the first moment on, `amount` times as strong
  Shape,         ///< a soft part begins in the misshape `shape`; amount: the seed
  Stiffness,     ///< all tissue `amount` times as stiff from the scene's own start on, and a hand presses 5 mm deep
  Poisson        ///< all tissue has this Poisson's ratio, likewise
};

/// What a case is run for, one by one.
enum class Over {
  Scene,   ///< once
  Touches, ///< each tool with the nearest soft and the nearest rigid part
  Axes,    ///< the six directions of the axes of W
  Bones,   ///< each bone that moves by itself and weighs, times the six directions
  Soft,    ///< each soft part that moves
  Seeds    ///< three
};

/// One line of the gauntlet.
struct StabilityCase {
  const char* id;
  Ordeal ordeal;
  Over over;
  double amount;
  HandPlay play = HandPlay::Press;
  Misshape shape = Misshape::Scattered;
  double seconds = 0;                ///< s that the load lasts, where `play` does not say
  std::array<double, 5> dts{};       ///< s, beside the scene's own; 0: none
  bool quick = false;                ///< in the short form: at the scene's own Δt, only the first of what it is run for
};

/// The cases, one table for `glenoid study stability`, for replays of its recordings and for tests/hard.
std::span<const StabilityCase> stabilityCases();

/// Their bounds.
inline constexpr StabilityBounds kGauntletBounds{};

/// By its id, or null.
const StabilityCase* findStabilityCase(std::string_view id);

}  // namespace glenoid
