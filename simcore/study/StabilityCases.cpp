// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/StabilityCases.h"

#include <string_view>

namespace glenoid {
namespace {

constexpr double kNoNumber = 0;
constexpr std::array<double, 5> kEveryStep{1e-3, 2e-3, 5e-3, 1e-2, 2e-2}, kEnds{1e-3, 2e-2}, kOwn{};

/// The gauntlet. Bounds of all of them: StabilityBounds.
const StabilityCase kCases[] = {
    {.id = "left-alone", .ordeal = Ordeal::Nothing, .over = Over::Scene, .amount = kNoNumber, .seconds = 0.2, .dts = kEveryStep, .quick = true},
    // Hands.
    {.id = "press", .ordeal = Ordeal::Hands, .over = Over::Touches, .amount = 0.005, .play = HandPlay::Press, .dts = kEveryStep, .quick = true},
    {.id = "hand-inside", .ordeal = Ordeal::Hands, .over = Over::Touches, .amount = 0.5, .play = HandPlay::Jump, .dts = kEnds, .quick = true},
    {.id = "impact", .ordeal = Ordeal::Hands, .over = Over::Touches, .amount = 5, .play = HandPlay::Dash, .dts = kEnds, .quick = true},
    {.id = "fast-drag", .ordeal = Ordeal::Hands, .over = Over::Touches, .amount = 1.5, .play = HandPlay::Drag, .dts = kOwn, .quick = true},
    {.id = "squeezed", .ordeal = Ordeal::StrongHands, .over = Over::Touches, .amount = 0.05, .play = HandPlay::Press, .dts = kOwn, .quick = true},
    {.id = "silent-device", .ordeal = Ordeal::Hands, .over = Over::Touches, .amount = 0.3, .play = HandPlay::Silent, .dts = kOwn, .quick = true},
    {.id = "wild-device", .ordeal = Ordeal::Hands, .over = Over::Touches, .amount = 1, .play = HandPlay::Wild, .dts = kOwn, .quick = true},
    // Bones.
    {.id = "blow", .ordeal = Ordeal::Blow, .over = Over::Bones, .amount = 1, .dts = kOwn, .quick = true},
    {.id = "end-of-range", .ordeal = Ordeal::EndOfRange, .over = Over::Bones, .amount = 0.35, .seconds = 0.5, .dts = kOwn, .quick = true},
    // The scene as a whole.
    {.id = "start-at-speed", .ordeal = Ordeal::Speed, .over = Over::Axes, .amount = 1, .dts = kEnds, .quick = true},
    {.id = "random-loads", .ordeal = Ordeal::RandomLoads, .over = Over::Seeds, .amount = 50, .seconds = 0.5, .dts = kEnds, .quick = true},
    {.id = "gravity-turned", .ordeal = Ordeal::Gravity, .over = Over::Axes, .amount = 1, .dts = kOwn, .quick = true},
    {.id = "gravity-gone", .ordeal = Ordeal::Gravity, .over = Over::Scene, .amount = 0, .dts = kOwn},
    // Shapes, of each soft part by itself: all at once they stay entangled (README).
    {.id = "scattered", .ordeal = Ordeal::Shape, .over = Over::Soft, .amount = 1, .shape = Misshape::Scattered, .dts = {2e-2}, .quick = true},
    {.id = "collapsed-to-plane", .ordeal = Ordeal::Shape, .over = Over::Soft, .amount = 1, .shape = Misshape::CollapsedToPlane, .quick = true},
    {.id = "collapsed-to-point", .ordeal = Ordeal::Shape, .over = Over::Soft, .amount = 1, .shape = Misshape::CollapsedToPoint},
    {.id = "mirrored", .ordeal = Ordeal::Shape, .over = Over::Soft, .amount = 1, .shape = Misshape::Mirrored, .quick = true},
    {.id = "inside-out", .ordeal = Ordeal::Shape, .over = Over::Soft, .amount = 1, .shape = Misshape::InsideOut},
    {.id = "flattened", .ordeal = Ordeal::Shape, .over = Over::Soft, .amount = 1, .shape = Misshape::Squeezed, .quick = true},
    // Matter, from the scene's own start on.
    {.id = "thousand-times-stiffer", .ordeal = Ordeal::Stiffness, .over = Over::Scene, .amount = 1e3, .dts = kEnds, .quick = true},
    {.id = "thousand-times-softer", .ordeal = Ordeal::Stiffness, .over = Over::Scene, .amount = 1e-3, .dts = kEnds, .quick = true},
    {.id = "poisson-0.49", .ordeal = Ordeal::Poisson, .over = Over::Scene, .amount = 0.49, .dts = kOwn},
    {.id = "poisson-0.4999", .ordeal = Ordeal::Poisson, .over = Over::Scene, .amount = 0.4999, .dts = kEnds, .quick = true},
};

}  // namespace

std::span<const StabilityCase> stabilityCases() { return kCases; }

const StabilityCase* findStabilityCase(std::string_view id) {
  for (const StabilityCase& known : kCases)
    if (id == known.id) return &known;
  return nullptr;
}

}  // namespace glenoid
