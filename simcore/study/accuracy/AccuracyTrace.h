// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "simcore/live/PenetrationProbe.h"
#include "simcore/scene/Recording.h"
#include "simcore/study/accuracy/AccuracyWindows.h"

namespace glenoid {

/// What can be compared between runs of one scene in different cells and steps, at one moment. Places are those of the
/// visual surfaces, which all settings share; forces are means over the time since the last moment, since a contact's force of one
/// step says little about another step's. Objects are numbered as in the model: the same in every setting.
struct AccuracySample {
  std::vector<std::vector<Vec3>> places;  ///< of each object, chosen vertices of its visual surface, W, m; none of a fixed one
  std::vector<Vec3> pairForces;           ///< N, by object a · count + object b with a < b, on a, friction with it
  std::vector<Vec3> handForces;           ///< N, by tool: what its coupling does to the hand
};

/// One window under one setting.
struct AccuracyTrace {
  std::vector<AccuracySample> samples;  ///< one for each place of the grid
  std::vector<double> depths;           ///< m, by object pair as above: of the visual surfaces at the end
  double deepest = 0;                   ///< m, of the setting's own collision surfaces, over all samples
  std::string deepestWhere;
  long steps = 0, notTaken = 0, diverged = 0, capped = 0, unsolved = 0;  ///< unsolved: contact islands not right to the tolerance
  double contacts = 0;                  ///< mean rows of a step
  double cpuMs = 0;                     ///< thread CPU time of all steps: while they are looked at, not as they are timed
};

/// Plays windows of one setting. The model must hold the same objects in the same order as that of the windows' states.
class AccuracyPlayer {
 public:
  /// `base`: the model that the windows' states are of. `judge`: of whose pairs it is told how deep they lie
  /// in each other; without one the model's own, which are none where contact is off.
  AccuracyPlayer(std::shared_ptr<const Model> base, std::shared_ptr<const Model> model,
                 const StepperOptions& options, const Recording& input,
                 std::shared_ptr<const Model> judge = nullptr);

  /// The window's state in this model: cells are carried along (carryToRefined) where they differ.
  State begin(const AccuracyWindow& window) const;
  AccuracyTrace play(const AccuracyWindow& window, const WindowWishes& wishes);
  /// Hands of the step that starts from a state.
  const Inputs& inputsAt(const State& state);
  Stepper& stepper() { return m_stepper; }
  /// From now on places lie on the surface as it is drawn: sunk where a tip dents it.
  void countDents() { m_dents = true; }
  const Model& model() const { return *m_model; }

 private:
  std::shared_ptr<const Model> m_base, m_model, m_judge;
  const Recording& m_input;
  Stepper m_stepper;
  PenetrationProbe m_collision, m_visual;
  Inputs m_inputs;
  std::vector<std::vector<int>> m_vertices;  ///< of each object's visual surface that are compared
  std::vector<std::vector<Vec3>> m_surface;  ///< scratch
  bool m_sameCells, m_dents = false;
};

/// Lowers the vertices of an object's surface, W, by the dents that it has.
void sinkInto(std::span<const DentView> dents, int object, std::vector<Vec3>& positions);

/// What the coupling of each tool does to the hand that holds it, N, W, after a step with these hands that
/// started from hands `before` (State::hands). Zero for a tool that another carries.
std::vector<Vec3> handForces(const Model& model, const State& state, const std::vector<Pose>& hands,
                             const VecX& before);

}  // namespace glenoid
