// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simcore/base/Math.h"
#include "simcore/scene/Elements.h"
#include "simcore/scene/training/Training.h"

namespace glenoid {

/// How one step is solved (design: the same step three ways).
enum class Profile { Paper, Direct, Reference };

/// What the scene's author wishes; the compiled plan says on or off with the reason.
enum class Wish { Auto, On, Off };

/// Effects that the step knows. `Auto` is on exactly when the scene holds something the effect acts on.
struct Effects {
  Wish gravity = Wish::Auto;
  Wish couplings = Wish::Auto;
  Wish contact = Wish::Auto;
  Wish selfContact = Wish::Auto;
  Wish friction = Wish::Auto;
  Wish damping = Wish::Auto;
  Wish bursa = Wish::Auto;
  Wish dent = Wish::Auto;
  Wish haptics = Wish::Auto;
  bool operator==(const Effects&) const = default;
};

/// Directions of W along which, or about which, something acts.
struct Axes {
  bool x = true, y = true, z = true;
  Vec3 mask() const { return {x ? 1.0 : 0.0, y ? 1.0 : 0.0, z ? 1.0 : 0.0}; }
  bool any() const { return x || y || z; }
  bool operator==(const Axes&) const = default;
};

/// Six-directional spring that holds a rigid part in its rest pose (the arm's pose). It acts at the part's
/// material point that rests at the origin of W: the centre of the joint, so that a push on the head does not
/// turn the bone about its far-away mass centre. With no stiffness it holds the orientation alone. `axes` leaves it the
/// chosen directions (a guide along one axis), `angularAxes` the chosen components of the turn's rotation vector, which
/// are turns about these axes only while they are small.
struct Hold {
  std::string part;                 ///< id of a rigid part that is not fixed
  double stiffness = 2e4;           ///< N/m, ≥ 0
  double angularStiffness = 50;     ///< N·m/rad, ≥ 0; one of the two is above 0
  double damping = 1e-2;            ///< s, times stiffness
  Axes axes, angularAxes;
  bool operator==(const Hold&) const = default;
};

/// Constant force and torque in W, such as the pull of a muscle that is not modelled. The force acts at a material point
/// given where it rests. Without a point: on a rigid part at the one that rests at the origin of W, as a hold does; on a
/// soft part spread over it as its weight is. Only a rigid part takes a torque. A part may have many.
struct Load {
  std::string part;                 ///< id of a part that is not fixed
  Vec3 force_W = Vec3::Zero();      ///< N
  Vec3 torque_W = Vec3::Zero();     ///< N·m
  std::optional<Vec3> point_W = std::nullopt;      ///< m, at rest; of a soft part inside its tetrahedra
  bool operator==(const Load&) const = default;
};

/// Pressure of a fluid on a region: −p ∫ n dA with the outward normals of the region as it lies now (it follows the
/// part). Negative: suction.
struct Pressure {
  std::string part, region;         ///< ids; the part is not fixed
  double pressure = 0;              ///< Pa
  bool operator==(const Pressure&) const = default;
};

/// Springs spread evenly over a region, each from a material point to where that rests, along chosen axes of W alone: a
/// roller or a plane of symmetry (one axis), a guide (two), a bed (three).
struct Support {
  std::string part, region;         ///< ids; the part is not fixed
  Axes axes;
  double stiffnessPerArea = 0;      ///< N/m per m², > 0
  double damping = 1e-2;            ///< s, times stiffness
  bool operator==(const Support&) const = default;
};

/// Where a part is wanted at a moment. Between keys the displacement goes linearly, the turn by slerp; before the first
/// and after the last key the part rests there.
struct MotionKey {
  double time = 0;                  ///< s
  Vec3 displacement_W = Vec3::Zero();  ///< m, of the motion's centre
  Quat turn_W = Quat::Identity();   ///< unit, from rest
  bool operator==(const MotionKey& other) const {
    return time == other.time && displacement_W == other.displacement_W && turn_W.coeffs() == other.turn_W.coeffs();
  }
};

/// Prescribed motion of a fixed part: what rests at x is at centre + displacement + turn (x − centre). Nothing pushes it
/// back; what touches it or is coupled to it feels its velocity.
struct Motion {
  std::string part;                 ///< id of a fixed part
  Vec3 centre_W = Vec3::Zero();     ///< m, at rest: the point about which it turns
  std::vector<MotionKey> keys;      ///< ascending in time, at least one
  bool operator==(const Motion&) const = default;
};

enum class ToolKind { Probe, Arthroscope, Finger, Ball, Bar };

/// A tool: a free rigid body with a mass, pulled by a virtual coupling toward the pose of the hand.
/// Tool frame: origin at the tip, +Z from the tip along the shaft to the handle. The surface is a shaft of
/// this length and radius with a rounded tip (probe: with a hook toward +X). A ball has its radius at the tip
/// only and hangs on a thin shaft; a bar is square, and its radius is half of its side. The coupling pulls at
/// the tip.
struct Tool {
  std::string id;                    ///< slug, unique in the scenario
  std::string name;                  ///< shown to people
  ToolKind kind = ToolKind::Probe;
  double length = 0.16, radius = 0.0015;  ///< m
  double mass = 0.05;                ///< kg
  double stiffness = 800;            ///< virtual coupling, N/m
  double angularStiffness = 2;       ///< N·m/rad
  double dampingRatio = 1.0;         ///< of the coupling against the tool's mass, 1 = critical
  double forceMax = 10;              ///< N, the coupling's pull is clamped here
  double lens = 0;                   ///< rad, arthroscope: how far its view is turned from −Z, toward +X unless lensTurn says otherwise
  double lensTurn = 0;               ///< rad, arthroscope: how far the light post has turned the lens about the shaft, from +X toward +Y
  double fieldOfView = 1.222;        ///< rad, arthroscope: whole angle seen in water. 70°: a high-definition arthroscope, as in PMID 41101332
  bool inAir = false;                ///< arthroscope: the joint is not filled, and the field is wider
  double friction = 0.1;             ///< Coulomb coefficient of this side; a pair uses the geometric mean
  Pose home;                         ///< hand pose at the start, W
  std::vector<std::string> perforates;  ///< parts that the shaft passes through without contact
  std::string link;                  ///< id of the tool that carries this one in place of a hand; empty: a hand does
  double linkStiffness = 2000;       ///< N/m: of the springs by which it is carried, in all
};

/// A named view of the scene.
struct Camera {
  std::string id, name;
  Vec3 eye_W = Vec3(0.3, 0.1, 0.3), target_W = Vec3::Zero(), up_W = Vec3::UnitY();  ///< m
  double fieldOfView = 0.6;  ///< vertical, rad
};

/// Tools, effects and settings around a joint. A joint becomes something that runs only through one.
struct Scenario {
  std::string id, name, description;
  std::string joint;                 ///< path relative to the scenario's file, or "builtin:NAME"
  double dt = 0.005;                 ///< s, in (0, 0.1]
  Vec3 gravity_W = Vec3(0, -9.81, 0);  ///< m/s²
  Profile profile = Profile::Direct;
  std::optional<Elements> elements;  ///< of all soft parts; without it each part has its own (Part::elements)
  double contactDistance = 0.0015;   ///< m: pairs of features nearer than this make a contact; 0: SceneScale.h
  double recoverySpeedMax = 0.1;     ///< m/s: cap on the speed at which penetration is undone; 0: SceneScale.h
  std::vector<std::string> fixedParts;  ///< ids; they join no island
  std::vector<Hold> holds;
  std::vector<Load> loads;
  double loadRise = 0;               ///< s over which loads rise evenly from nothing at the start; 0: whole at once
  std::vector<Pressure> pressures;
  std::vector<Support> supports;
  std::vector<Motion> motions;       ///< one for each part at most
  std::vector<Tool> tools;
  Effects effects;
  /// Ids of parts that may fold onto themselves; of a rigid or a fixed one nothing follows. With the effect on and no part
  /// named, all soft parts that move may; with `auto` those named here.
  std::vector<std::string> selfContactParts;
  std::vector<Camera> cameras;       ///< first: default
  Training training;                 ///< what is to be done; without tasks nothing is
  std::string input;                 ///< shipped recording, path relative to the file or "builtin:NAME"; may be empty
  unsigned seed = 1;
};

int findTool(const Scenario& scenario, const std::string& id);

/// Share of the loads that acts at a time, s: what has risen by then.
double loadShareAt(const Scenario& scenario, double time);

/// Pose that brings the part from rest to where it is at a time: x_W = pose · x at rest. Needs a key.
Pose motionAt(const Motion& motion, double time);

/// Takes out whatever acts on a part: holds, loads, pressures, supports, its motion, its contact with itself; of a region only
/// what names that.
void dropActionsOn(Scenario& scenario, const std::string& part, const std::string& region = {});

}  // namespace glenoid
