// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "tests/hard/HardCase.h"
#include "tests/scenes/BlockScenes.h"

/// Pieces that several hard cases share: boxes, couplings and hands over the block scenes.
namespace glenoid::hard {

Material tissue(const std::string& id, double youngsModulus, double poissonRatio, double density, double stiffnessDamping);

/// A box part of one material; `cells` per edge where soft, `surface` squares per edge of the collision mesh.
Part box(const std::string& id, int number, PartKind kind, const std::string& material, const Vec3& low, const Vec3& high,
         int cells = 2, int surface = 2);

/// Couples face `axis`/`side` (0 low, 1 high) of part a, which gets the region, to part b with the given total stiffness.
void couple(Joint& joint, const std::string& a, int axis, int side, const std::string& b, double stiffness, double damping = 1e-3);

/// A finger that points down, its tip at `tip`.
Tool finger(const Vec3& tip, double length = 0.06, double radius = 0.006);

/// The home pose of a tool with its tip moved.
Pose handAt(const Tool& tool, const Vec3& tip);

/// A soft block on a fixed plate with a finger above, block 4 cm wide, top at 40.5 mm.
HardCase fingerOverBlock(const std::string& name);

}  // namespace glenoid::hard
