// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <vector>

#include "simcore/body/ContactObject.h"
#include "simcore/collide/FilmSearch.h"
#include "simcore/coupling/SpringAssembly.h"
#include "simcore/step/Model.h"
#include "simcore/tool/PoseSpring.h"

namespace glenoid {

/// A rigid body pulled toward a pose: the hold of an arm (tool −1) or a hand's coupling to its tool.
struct BoundPoseSpring {
  int object = 0, base = 0, tool = -1;
  PoseSpring spring;
  PoseTarget rest;  ///< target of a hold
  std::array<BlockEntry, 3> entries;
};

/// A constant force and torque on a rigid body.
struct BoundLoad {
  int object = 0, base = 0;
  Vec3 anchor_B = Vec3::Zero(), force_W = Vec3::Zero(), torque_W = Vec3::Zero();
};

/// A coupling island compiled: which objects, where their blocks start, pattern and forces.
struct CouplingIslandModel {
  std::vector<int> objects;                      ///< ascending
  std::vector<int> base;                         ///< first block of each
  std::vector<std::vector<BlockEntry>> entries;  ///< of each object
  std::vector<BoundSpring> springs;              ///< an end may be fixed
  std::vector<BoundPoseSpring> poseSprings;
  std::vector<BoundLoad> loads;
  std::shared_ptr<const BlockSymbolic> symbolic;
  int blockCount = 0;
};

/// A bursa compiled: whose vertices feel whose triangles, and how a film presses.
struct FilmModel {
  std::string id;                       ///< of the bursa
  FilmSides sides;                      ///< its surfaces are objects
  int firstKey = 0;                     ///< of its touches
  double thickness = 0;                 ///< m
  double stiffnessPerArea = 0;          ///< Pa/m
  double damping = 0;                   ///< s, per stiffness
  double friction = 0;                  ///< Coulomb's coefficient inside
  std::vector<std::vector<char>> floor; ///< by object and collision vertex: whether the film covers it; empty: none
  std::vector<std::vector<char>> roof;
};

/// What a soft object gives under a tool beyond its tetrahedra.
struct DentModel {
  std::vector<Vec3> at_W;            ///< places on its surface at rest; empty: it gives nothing more
  std::vector<double> logCompliance; ///< of m/N
  std::vector<double> depthMost;     ///< m
  double radius = 0;                 ///< m, of a tip's patch
};

/// The numerical inside of a model, private to step/. Constant; threads share it.
struct StepModel {
  std::vector<std::unique_ptr<ContactObject>> objects;
  std::vector<int> islandOfObject;   ///< −1: fixed
  std::vector<int> baseOfObject;     ///< first block in its island; −1: fixed
  std::vector<CouplingIslandModel> islands;
  StepSettings settings;
  std::vector<FilmModel> films;      ///< empty where the effect is off
  std::vector<DentModel> dents;      ///< one for each object; empty where the effect is off
  bool contact = false, friction = false;
};

}  // namespace glenoid
