// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <vector>

#include "simcore/body/ContactObject.h"
#include "simcore/collide/FilmSearch.h"
#include "simcore/coupling/SpringAssembly.h"
#include "simcore/scene/DentTable.h"
#include "simcore/spatial/TriangleTree.h"
#include "simcore/step/Model.h"
#include "simcore/tool/PoseSpring.h"
#include "simcore/tool/ToolBalls.h"

namespace glenoid {

/// A rigid body pulled toward a pose: the hold of an arm (tool −1) or a hand's coupling to its tool.
struct BoundPoseSpring {
  int object = 0, base = 0, tool = -1;
  PoseSpring spring;
  PoseTarget rest;  ///< target of a hold
  std::array<BlockEntry, 3> entries;
};

/// A constant force on an object, at a material point or spread over the whole as its weight is; on a rigid one also a torque.
struct BoundLoad {
  int object = 0, base = 0;
  bool spread = false;
  MaterialPoint point;
  Vec3 force_W = Vec3::Zero(), torque_W = Vec3::Zero();
};

/// A pressure on a region, taken at the start of a step: −p ∫ n dA over the flat triangles, a third of each at each corner.
struct BoundPressure {
  int object = 0, base = 0, pressure = 0;     ///< pressure: in scenario.pressures
  double value = 0;                           ///< Pa
  std::vector<MaterialPoint> points;
  std::vector<std::array<int, 3>> triangles;  ///< of points
};

/// One spring of a support, from a material point to where that rests.
struct BoundSupport {
  const ContactObject* object = nullptr;
  int base = 0, support = 0;         ///< support: in scenario.supports
  MaterialPoint point;
  Vec3 rest_W = Vec3::Zero();        ///< m
  Vec3 stiffness = Vec3::Zero();     ///< along the axes of W, N/m
  Vec3 damping = Vec3::Zero();       ///< N·s/m
  std::vector<BlockEntry> entries;   ///< lower triangle over the point's terms, row by row
};

/// A fixed object whose motion is prescribed.
struct DrivenObject {
  int object = 0, motion = 0;        ///< motion: in scenario.motions
  std::vector<Vec3> rest_W;          ///< m: mass centre of a rigid one, start nodes of a soft one
};

/// A coupling island compiled: which objects, where their blocks start, pattern and forces.
struct CouplingIslandModel {
  std::vector<int> objects;                      ///< ascending
  std::vector<int> base;                         ///< first block of each
  std::vector<std::vector<BlockEntry>> entries;  ///< of each object
  std::vector<BoundSpring> springs;              ///< an end may be fixed
  std::vector<BoundPoseSpring> poseSprings;
  std::vector<BoundLoad> loads;
  std::vector<BoundPressure> pressures;
  std::vector<BoundSupport> supports;
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

class StaticResponse;

/// What a soft object gives under a round tool beyond its own elements.
struct DentModel {
  DentField field;                                            ///< empty: it gives nothing more
  double cell = 0;                                            ///< edge of a cell of its own elements, m
  std::shared_ptr<const TriangleTree> surface;                ///< its collision surface at rest, which the search for contacts knows
  std::vector<int> tissue;                                    ///< of each of its triangles: which use of a material
  std::shared_ptr<const StaticResponse> own;                  ///< what its elements give; null: nothing, it is fixed
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
  std::vector<std::vector<ToolBall>> balls;  ///< of each object that is a round tool, in its body frame; empty where no part has dents
  std::vector<DrivenObject> driven;
  std::vector<int> drivenOfObject;   ///< in `driven`; −1: not driven
  bool contact = false, friction = false;
};

}  // namespace glenoid
