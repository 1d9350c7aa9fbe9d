// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

/// Joints of boxes, small enough to reason about by hand. Metres, Y up.
namespace glenoid::scenes {

/// Closed box with `n` squares along each edge, wound outwards.
TriMesh boxSurface(const Vec3& low, const Vec3& high, int n = 1);

/// The box cut into n³ bricks of five tetrahedra each, faces matching.
TetMesh boxVolume(const Vec3& low, const Vec3& high, int nx, int ny, int nz);

/// A part with a box as both surfaces and, if soft, boxVolume of cells per edge. Material ids: "bone", "tissue".
Part boxPart(const std::string& id, int number, PartKind kind, const Vec3& low, const Vec3& high, int cells = 2);

/// Region of all visual triangles whose centroid lies in a box.
Region regionIn(const Part& part, const std::string& id, const Box3& box);

/// Elements that the scenarios of all these scenes ask for: none, or cells where the environment says so
/// (GLENOID_ELEMENTS=cells), by which a test is run again with those.
std::optional<Elements> wishedElements();

/// Adds materials "bone" (2000 kg/m³) and "tissue" (1000 kg/m³, 50 kPa, ν 0.4, β 1e-3 s).
void addMaterials(Joint& joint);

/// The paper's Figure 4: rigid 1 – soft 2 – rigid 3 in a row along X, coupled at both faces. Part 1 is fixed.
Joint figure4Joint();
Scenario figure4Scenario();

/// The paper's Figure 5: the coupling island of Figure 4 with every part free, standing over nothing, and two
/// finger tools that rest on the soft middle from above (no gravity): one contact island of three.
Scenario figure5Scenario();

/// A soft block over a fixed plate, 0.5 mm apart, under gravity, with a finger above.
Joint blockOnPlateJoint();
Scenario blockOnPlateScenario();

/// Three cubes of 20 mm in a row, which start kCubeDepths deep in the top of a fixed slab, far from its sides. Without gravity
/// they leave it at the recovery speed: after n steps they lie deep still what they did less n Δt kRecovery. A third of their
/// thickness 2 V/A is 20/9 mm.
inline constexpr double kCubeDepths[] = {0.0039, 0.003, 0.001}, kRecovery = 0.01;  // m, m/s
Joint sunkenCubesJoint();  ///< "slab", then "deep", "middle", "shallow"
Scenario sunkenCubesScenario();

}  // namespace glenoid::scenes
