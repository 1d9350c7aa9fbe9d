// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/body/State.h"
#include "simcore/body/SurfaceBinding.h"
#include "simcore/collide/CollisionSurface.h"
#include "simcore/mesh/TetMesh.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// One object of a running scene as views, reports and the interface see it: parts first, in the joint's
/// order, then tools in the scenario's order.
struct SceneObject {
  std::string id, name;
  int number = 0;               ///< the part's number; 0 for a tool
  bool tool = false;
  int toolIndex = -1;           ///< in scenario.tools
  std::array<float, 3> color{0.8f, 0.8f, 0.8f};
  ObjectLayout layout;
  SurfaceBinding visual, collision;
  std::shared_ptr<const TetMesh> volume;  ///< soft only; node i of the state is node i of this mesh
  std::shared_ptr<const TetMesh> authored;  ///< soft only: of the joint as it was given, whose nodes couplings number
  bool cells = false;           ///< soft only: elements are whole cells, five tetrahedra of the volume each
  int authoredTets = 0;         ///< soft only: of the part as it was given; whole cells have more
  int elements = 0;             ///< soft only: how many rotations the state has of it
  double mass = 0;              ///< kg
  int motion = -1;              ///< in scenario.motions: a fixed part that moves; −1: none
  std::vector<double> friction; ///< Coulomb's coefficient at each collision vertex; empty: friction is off
};

/// One spring of a coupling, for drawing and tables.
struct SpringView {
  int coupling;                 ///< in joint.couplings
  int objectA, objectB;
  VertexBinding a, b;           ///< both ends as points of their objects
  double stiffness;             ///< N/m
  double damping = 0;           ///< N·s/m
};

/// What became of one wish, and why; `reason` is a word for tr(), not a sentence.
struct EffectPlan {
  std::string name;    ///< "gravity", "couplings", "contact", "selfContact", "friction", "damping", "bursa", "haptics", …
  bool on = false;
  std::string reason;  ///< "asked-on", "asked-off", "nothing-to-act-on", "auto-present", "not-built"
};

struct StepModel;  ///< the numerical inside, private to step/

/// A scenario compiled for running: constant, shared between threads.
struct Model {
  Joint joint;  ///< with whole cells for volumes where parts run as cells
  Scenario scenario;
  std::vector<SceneObject> objects;
  std::vector<SpringView> springs;
  std::vector<int> couplingIslandOfObject;  ///< −1: fixed
  int couplingIslandCount = 0;
  std::vector<EffectPlan> effects;
  std::vector<std::shared_ptr<const CollisionSurface>> collisionSurfaces;  ///< one for each object
  std::vector<CollisionPair> collisionPairs;  ///< objects that may collide, ascending; surface i is object i's
  State start;
  std::string jointHash;
  std::shared_ptr<const StepModel> inside;

  bool effectOn(const std::string& name) const;
};

/// Fails with Unusable, UnknownId, TooFewSprings, BadElement … naming the part.
Result<std::shared_ptr<const Model>> compileModel(const Joint& joint, const Scenario& scenario);

}  // namespace glenoid
