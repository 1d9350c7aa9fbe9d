// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/file/JsonValue.h"
#include "simcore/reading/SurfaceField.h"
#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"

/// What can be read off a running scene: plain functions of (Model, State, report) that change nothing, for files, tests
/// and whoever wants to check the simulation against something it did not make. README.md has the definitions.
/// Frame W, SI units. Not for use inside a step: they allocate.
namespace glenoid {

/// A part or tool as a whole. Mass, centre, inertia, velocity and turn are those of the dynamics (its mass matrix), so
/// that mass · velocity is its momentum and inertia · angularVelocity its angular momentum about the centre.
struct PartReading {
  std::string id;
  bool rigid = true, tool = false, fixed = false;
  double mass = 0;                              ///< kg
  Vec3 centre_W = Vec3::Zero();                 ///< m, of mass
  Vec3 velocity_W = Vec3::Zero();               ///< m/s, of the centre
  Quat q_WB = Quat::Identity();                 ///< from rest (of a tool: from its own frame); soft: best fit by mass
  Vec3 angularVelocity_W = Vec3::Zero();        ///< rad/s; soft: inertia⁻¹ · angular momentum
  Mat3 inertia_W = Mat3::Zero();                ///< kg·m² about the centre
  std::vector<Vec3> nodes_W;                    ///< m, soft only, in the order of its tetrahedral mesh
  struct Peak {
    Quantity quantity;
    FieldPeak most;
  };
  std::vector<Peak> peaks;                      ///< of its visual surface, where they were asked for (addPeaks)
};

/// Of the last step (of its last part where it was cut).
struct ContactReading {
  std::string a, b;                             ///< ids
  Vec3 point_W = Vec3::Zero();                  ///< m
  Vec3 normal_W = Vec3::UnitY();                ///< unit, from b to a
  double gap = 0;                               ///< m, before the step
  double force = 0;                             ///< N along the normal on a, ≥ 0
  Vec3 friction_W = Vec3::Zero();               ///< N on a
  bool film = false;                            ///< soft pressure of a bursa
};

/// A force, N, and the torque, N·m, that goes with it about a point, m.
struct Wrench {
  Vec3 point_W = Vec3::Zero(), force_W = Vec3::Zero(), torque_W = Vec3::Zero();
};

/// What the springs of a coupling do to part a, about the mean of their ends on a by stiffness: the centroid of the region or nodes as the
/// part carries it. On b acts the opposite.
struct CouplingReading {
  std::string id, a, b;
  int springs = 0;
  Wrench onA;
};

/// What a hold, load, pressure or support does to its part.
struct ActionReading {
  std::string part, region;                     ///< region: of pressures and supports
  Wrench onPart;
};

struct SceneReading {
  double time = 0;                              ///< s
  long step = 0;
  std::vector<PartReading> parts;               ///< parts in the joint's order, then tools in the scenario's
  std::vector<ContactReading> contacts;
  std::vector<CouplingReading> couplings;       ///< those with springs, in the joint's order
  std::vector<ActionReading> holds, loads, pressures, supports;  ///< in the scenario's order; nothing for fixed parts
};

PartReading readPart(const Model& model, const State& state, int object);
std::vector<ContactReading> readContacts(const Model& model, const std::vector<ContactView>& contacts);
/// Spring and damper at the state's positions and velocities: what acted in the step that led there, to the order of its
/// linearisation (exact for soft parts, and at rest).
std::vector<CouplingReading> readCouplings(const Model& model, const State& state);
SceneReading readScene(const Model& model, const State& state, const std::vector<ContactView>& contacts);

/// The largest value of each quantity on each part's visual surface, and where (SurfaceField). Contact only where something
/// presses. `reading`: of the same state.
void addPeaks(const Model& model, const State& state, const std::vector<ContactView>& contacts, bool stretchLaw, SceneReading& reading);

/// As resources/schemas/run-state.schema.json describes. `scenario`: what was asked for.
JsonValue toJson(const SceneReading& reading, const std::string& scenario);

}  // namespace glenoid
