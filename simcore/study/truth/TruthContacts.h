// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/study/truth/TruthBlocks.h"

/// Bodies that press on each other, with closed forms. Metres, Y up.
namespace glenoid::truth {

/// A rigid ball resting with its lowest point at the origin, on a soft block (ν 0.3) that is glued to a fixed
/// plate far below. The block is cut finely where they touch: cells of `cell` there, growing by `growth`
/// outwards to at least `reach`. Gravity acts on the ball alone for the block is given next to no weight.
TruthScene ballOnBlock(double radius, double mass, double youngsModulus, double cell, double growth,
                       double reach);

/// How deep a ball lies in a bonded layer of ν 0.3 over how deep in a half-space, under one force
/// (Dimitriadis et al., Biophysical Journal 82, 2002, equation 13): a = √(R d) over the thickness.
double layerDepth(double contactOverThickness);

/// The contact patch test (Taylor and Papadopoulos 1991): a block of 4 cm on a slab of 8 cm, both soft, ν
/// 0.3, in the corner of two walls on a level bed, none of which gives; one pressure on the block's top and
/// on what the slab shows beside it, so that both hold one stress. Squares of the slab: `below` along 8 cm (an
/// even number), of the block: `above` along 4 cm. No friction, no gravity.
TruthScene contactPatch(int below, int above, double stiffness);
inline constexpr double kPatchPressure = 5, kPatchYoung = 5e4;  ///< Pa: so little that strains are small
inline constexpr double kPatchGap = 1e-9;                       ///< m, between the two at the start

/// A band round half a cylinder: one end held by springs, the other pulled, slowly; friction holds e^{µπ}
/// times as much. So many facets and bricks round the half.
TruthScene capstan(int around, double friction);
inline constexpr double kCapstanPull = 2, kCapstanRise = 1, kCapstanSpring = 2000;  ///< N, s, N/m

}  // namespace glenoid::truth
