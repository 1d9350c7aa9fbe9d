// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "simcore/step/Model.h"
#include "simcore/step/PaperSettings.h"

namespace glenoid {

/// What comes from outside in one step: where each hand wants its tool, by the scenario's tool order.
struct Inputs {
  std::vector<Pose> hands;  ///< W; empty: the hands stay at home
};

/// One contact of a step, for drawing and metrics.
struct ContactView {
  int objectA = -1, objectB = -1;
  Vec3 point_W = Vec3::Zero();   ///< midway, m
  Vec3 normal_W = Vec3::UnitY(); ///< from b to a
  double gap = 0;                ///< m, before the step
  double force = 0;              ///< N, λ/Δt; > 0: active
  Vec3 friction_W = Vec3::Zero();  ///< N, on a; zero where friction is off
  bool film = false;             ///< the soft pressure of a bursa; its gap may be as wide as the bursa is thick
};

/// How far the tip of a tool lies in the surface of a soft part beyond what the part's tetrahedra gave: the surface there
/// is to be drawn and counted that much lower, less with the distance as exp(−r²/(2 radius²)).
struct DentView {
  int object = -1, tool = -1;    ///< objects
  Vec3 point_W = Vec3::Zero();   ///< middle of the pressed place on the surface, m
  Vec3 normal_W = Vec3::UnitY(); ///< unit, out of the part
  double depth = 0;              ///< m, > 0
  double radius = 0;             ///< m
  bool operator==(const DentView&) const = default;
};

/// The stages whose time is taken.
enum class Stage { Assemble, Factor, Unconstrained, Surfaces, Collide, SelfContact, Islands, Delassus, Contact, Friction, Bursa, Dent, Integrate, Count };
inline constexpr int kStageCount = static_cast<int>(Stage::Count);
const char* stageName(Stage stage);

/// How the splitting of the `paper` profile went.
struct PaperReport {
  std::string d;             ///< "node" or "object": which blocks D held in the last step
  double lambdaMax = 0;      ///< estimated largest eigenvalue of D⁻¹A
  int cgIterations = 0;      ///< most of any coupling island
  double cgResidual = 0;     ///< worst relative residual ‖b − A v‖/‖b‖
  int outerIterations = 0;   ///< most of any contact island
  double outerResidual = 0;  ///< ‖Av − b − Jᵀλ‖/‖b‖ over all islands at the end
  bool cgCapped = false, outerCapped = false, diverged = false;
};

/// Which method solved how many contact islands of a step: the program chooses by rows and what lies behind them.
struct ContactSolverCounts {
  int pivoting = 0;    ///< without friction: principal pivoting on W
  int impulses = 0;    ///< with friction, few rows: Newton on W (ImpulseSystem)
  int velocities = 0;  ///< many rows, with or without friction: Newton on the sparse A + Jᵀ G J (VelocitySystem)
  int convex = 0;      ///< of the last two, those that Newton on Coulomb's law left to the convex rounds
  int newtonMax = 0;   ///< most Newton steps of an island
  int rowsMax = 0;     ///< most rows of an island
};

/// What a step left undone so that its time has a bound (ContactBudget.h, README.md); all zero while a scene is well.
struct StepBounded {
  int rows = 0;      ///< contacts that no problem took in, of more than it can hold: the deepest of each pair stay
  int rounds = 0;    ///< problems that ended while contacts were violated
  int searches = 0;  ///< not made again, although something moved further than was foreseen
  int parts = 0;     ///< fewer than the step should have been cut into
  bool any() const { return rows > 0 || rounds > 0 || searches > 0 || parts > 0; }
};

/// What one step did. Valid until the next step of the same Stepper.
struct StepReport {
  bool taken = true;              ///< false: not finite, the last good state stayed
  int parts = 1;                  ///< into which it was cut, for what turns too far in one; contacts are the last part's
  int refusedHands = 0;           ///< inputs that were no pose of a hand (NaN, 1e30): the last pose stood for them
  int contacts = 0, active = 0;   ///< rows, and those with any force; those of a bursa's film are not counted here
  /// Rows whose force is at least 1 mN and a thousandth of the largest in their contact island: what carries something.
  int pressing = 0;
  int filmContacts = 0;           ///< vertices that feel a bursa
  int contactIslands = 0;         ///< with at least one contact
  int droppedRows = 0;            ///< contacts that nothing can move
  int pivotsExhausted = 0;        ///< contact islands whose answer is not right to the tolerance
  ContactSolverCounts contactSolver;
  int deepOverlaps = 0;           ///< places where surfaces lay so deep in each other that they were parted along one way
  StepBounded bounded;
  double contactWork = 0;         ///< what contacts cost, in products of 3×3 blocks
  double residual = 0;            ///< ‖Av − b − Jᵀλ‖/‖b‖ over all islands
  double complementarity = 0;     ///< worst distance of an impulse from its own projection, m/s
  std::array<double, kStageCount> cpuMs{};  ///< thread CPU time
  double stepCpuMs = 0, stepWallMs = 0;
  PaperReport paper;
  std::vector<ContactView> contactViews;
  std::vector<DentView> dents;    ///< one for each tool that presses a soft part; empty where the effect is off
  std::vector<Vec3> toolForces;   ///< contact force on each tool, N, W
};

struct StepperOptions {
  Profile profile = Profile::Direct;
  int threads = 1;
  bool portable = false;  ///< no SIMD kernels
  /// Called with the state after each part of a step and the part's length, s: for books that want every one.
  std::function<void(const State&, double)> afterPart = {};
  PaperSettings paper = {};  ///< what the `paper` profile adds to the published step
  PaperLimits paperLimits = {};  ///< and where its iterations end
};

/// The pure step: model, inputs and state in, state and report out. Owns scratch only; one per thread.
class Stepper {
 public:
  Stepper(std::shared_ptr<const Model> model, const StepperOptions& options);
  ~Stepper();
  const StepReport& step(const Inputs& inputs, State& state);
  const Model& model() const;
  struct Work;  ///< private to step/
  Work& work() { return *m_work; }

 private:
  std::unique_ptr<Work> m_work;
};

/// What solves the linear systems: "block-cholesky", the same "-dissected" where an island is so large that its blocks are
/// ordered by nested dissection, "cholmod", "conjugate-gradients".
const char* solverName(const Model& model, Profile profile);

/// "avx2-fma" or "portable": the instruction set of the kernels that would be used.
const char* kernelIsa(bool portable);

}  // namespace glenoid
