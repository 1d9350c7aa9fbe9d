// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

#include "simcore/mesh/TriMesh.h"

/// Surfaces of a real body to compare with. They are no part of the project: a folder beside the repository,
/// or the one that GLENOID_ANATOMY names, may hold them.
namespace glenoid::test {

/// The folder, or nothing where there is none.
std::optional<std::string> referenceFolder();

/// A binary STL of that folder in the joint's frame: millimetres, centre of the humeral head at the origin, x
/// anterior, y superior, z lateral, scaled by 1.0975 to a head radius of 24 mm. Corners that coincide are
/// merged.
TriMesh referenceMesh(const std::string& folder, const std::string& file);

/// Rigid motion that brings `moved` nearest to `still` (iterated closest points, the worst fifth left out),
/// applied to `moved`.
TriMesh aligned(const TriMesh& moved, const TriMesh& still, int rounds);

}  // namespace glenoid::test
