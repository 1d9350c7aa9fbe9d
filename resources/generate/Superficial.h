// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "resources/generate/Parts.h"

/// The outer layers that palpation needs over the shoulder of eleven parts: clavicle, deltoid, skin with fat.
/// Frame W, millimetres.
namespace glenoid::generate {

/// What a layer lies on: distance to the nearest of the parts below, of their visual and of their coarse surfaces.
struct Ground {
  Field visual, coarse;
};
/// The nearer of both at each place.
Ground over(const Ground& a, const Ground& b);
Ground groundOf(const Surfaces& surfaces);

/// S-shaped from its sternal to its acromial end, which stops short of the acromion. Its lateral half follows the scaled
/// landmarks, its length what is published: 152 ± 11 mm in men (Andermahr et al., Clin Anat 20:48, 2007).
Surfaces clavicle(const Bones& bones);

/// The three parts of the deltoid, from the clavicle, the acromion and the spine to the deltoid tuberosity, laid over
/// the ground with room for the bursa. Thickness 12 mm in front, 24 mm at the side, 23 mm behind, in the order
/// clavicular, acromial, spinal.
inline constexpr int kDeltoidAround = 24, kDeltoidAlong = 26;
std::array<Surfaces, 3> deltoid(const Ground& ground);

/// Skin and fat as one layer over the shoulder from the clavicle to below the deltoid's insertion: 8 mm of fat, 2 mm of
/// skin, 1.5 mm above what lies below. Its visual surface is two sheets of (kSkinAcross + 1) × (kSkinAlong + 1)
/// vertices, inner then outer, from front to back and from the neck down the arm.
inline constexpr int kSkinAcross = 36, kSkinAlong = 32;
Surfaces skinLayer(const Ground& ground);

}  // namespace glenoid::generate
