// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

/// Boxes and what is cut from them: the matter of problems with known answers, for `glenoid study truth` and
/// for tests alike. Metres, Y up.
namespace glenoid::truth {

/// A joint and a scenario that belong together, not in files yet.
struct TruthScene {
  Joint joint;
  Scenario scenario;
};

/// Closed box with `n` squares along each edge, wound outwards.
TriMesh boxSurface(const Vec3& low, const Vec3& high, int n = 1);

/// The box cut into nx × ny × nz bricks of five tetrahedra each, faces matching.
TetMesh boxVolume(const Vec3& low, const Vec3& high, int nx, int ny, int nz);

/// As boxVolume but with these coordinates along each axis, and its surface with the same grid, wound
/// outwards.
TetMesh gradedVolume(const std::vector<double>& x, const std::vector<double>& y,
                     const std::vector<double>& z);
TriMesh gradedSurface(const std::vector<double>& x, const std::vector<double>& y,
                      const std::vector<double>& z);

/// A part with a box as both surfaces and, if soft, boxVolume of cells per edge. Material ids: "bone",
/// "tissue".
Part boxPart(const std::string& id, int number, PartKind kind, const Vec3& low, const Vec3& high,
             int cells = 2);
/// A rigid box with two triangles on each face.
Part plainBox(const std::string& id, int number, const Vec3& low, const Vec3& high);

/// Region of all visual triangles whose centroid lies in a box.
Region regionIn(const Part& part, const std::string& id, const Box3& box);
/// The level of W at which a coordinate has this value, as a box for regionIn; a metre wide on both sides.
Box3 levelAt(int axis, double at);

/// Adds materials "bone" (2000 kg/m³) and "tissue" (1000 kg/m³, 50 kPa, ν 0.4, β 1e-3 s).
void addMaterials(Joint& joint);

/// With names and materials, nothing else.
TruthScene namedScene(const char* id);

}  // namespace glenoid::truth
