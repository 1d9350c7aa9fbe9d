// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/base/Math.h"

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

/// Six-directional spring that holds a rigid part in its rest pose (the arm's pose). It acts at the part's
/// material point that rests at the origin of W: the centre of the joint, so that a push on the head does not
/// turn the bone about its far-away mass centre.
struct Hold {
  std::string part;                 ///< id of a rigid part that is not fixed
  double stiffness = 2e4;           ///< N/m
  double angularStiffness = 50;     ///< N·m/rad
  double damping = 1e-2;            ///< s, times stiffness
  bool operator==(const Hold&) const = default;
};

/// Constant force and torque on a rigid part, such as the pull of muscles that are not modelled. It acts at the
/// part's material point that rests at the origin of W, as a hold does.
struct Load {
  std::string part;                 ///< id of a rigid part that is not fixed
  Vec3 force_W = Vec3::Zero();      ///< N
  Vec3 torque_W = Vec3::Zero();     ///< N·m
  bool operator==(const Load&) const = default;
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
  double contactDistance = 0.0015;   ///< m: pairs of features nearer than this make a contact
  double recoverySpeedMax = 0.1;     ///< m/s: cap on the speed at which penetration is undone
  std::vector<std::string> fixedParts;  ///< ids; they join no island
  std::vector<Hold> holds;
  std::vector<Load> loads;
  std::vector<Tool> tools;
  Effects effects;
  std::vector<Camera> cameras;       ///< first: default
  std::string input;                 ///< shipped recording, path relative to the file or "builtin:NAME"; may be empty
  unsigned seed = 1;
};

int findTool(const Scenario& scenario, const std::string& id);

}  // namespace glenoid
