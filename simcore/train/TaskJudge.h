// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "simcore/train/BoundPlace.h"
#include "simcore/train/ToolTouch.h"

namespace glenoid {

enum class TaskOutcome { Waiting, Open, Done, Missed };  ///< Waiting: an earlier one comes first

/// How a task went, so far or in the end. Times in s of the run.
struct TaskRecord {
  TaskOutcome outcome = TaskOutcome::Waiting;
  std::optional<double> opened, ended;
  int errors = 0;
  int tool = -1;                      ///< object: who did it
  double progress = 0;                ///< 0…1
  double forceMax = 0, forceSum = 0;  ///< N on the task's part by the tool that does it, N·s
  double touchSeconds = 0;
  double seenSeconds = 0;             ///< Look: that its place was in view
  std::optional<double> distance;     ///< m, at the end, from the place: along the surface for Find, else straight
  std::optional<double> depth;        ///< m, Find: how far behind what was pressed the place lies, along the push
};

/// What a task sees of a step.
struct StepSeen {
  const Model& model;
  const StepReport& step;
  const State& state;
  double dt;                          ///< s
};

/// Judges one task step by step. A function of the steps alone, so that a run, its replay and the window agree.
/// The model must outlive it.
class TaskJudge {
 public:
  static constexpr double kBelow = 0.1;       ///< s below a force before passing it counts again
  static constexpr double kStill = 2e-3;      ///< m: a Find's answer stays within this of where it began
  static constexpr double kLeft = 5e-3;       ///< m: and the next begins beyond this of the last
  static constexpr double kNearRing = 3;      ///< radii: a Pass beside the ring but within this is an error

  /// Fails as BoundPlace::bind, or with UnknownId for a tool that is not there.
  static Result<TaskJudge> make(const Model& model, const Task& task);

  void open(double time);
  /// Only an open task is judged.
  void look(const StepSeen& seen);
  const TaskRecord& record() const { return m_record; }
  const Task& task() const { return *m_task; }
  const std::vector<BoundPlace>& places() const { return m_places; }
  /// Whether a tool that may do it presses on its place (not for Look, Follow, Find and Pass, which have no such moment).
  bool presses(const StepSeen& seen) const;

 private:
  TaskJudge(const Model& model, const Task& task) : m_model(&model), m_task(&task) {}
  void touch(const StepSeen& seen);
  void lookAt(const StepSeen& seen);
  void trace(const StepSeen& seen);
  void follow(const StepSeen& seen);
  void find(const StepSeen& seen);
  void pass(const StepSeen& seen);
  void tooHard(double force, double dt);
  void done(double time, std::optional<double> distance);
  int pressingTool(const StepSeen& seen, int part, ToolTouch& most) const;
  int touchingTool(const StepSeen& seen, ToolTouch& most, double& distance) const;
  Vec3 tip(const StepSeen& seen, int tool) const;

  const Model* m_model;
  const Task* m_task;
  std::vector<int> m_tools;           ///< objects that may do it
  std::vector<CarriedPoint> m_tips;   ///< as many
  std::vector<BoundPlace> m_places;
  TaskRecord m_record;

  double m_held = 0;                  ///< s
  bool m_hard = false;                ///< beyond forceMax now
  double m_below = kBelow;            ///< s since it was
  double m_along = 0;                 ///< Trace: m of the path done
  bool m_drawing = false;
  double m_followed = 0, m_near = 0;  ///< Follow: s since the tip came near, and near of these
  bool m_following = false;
  std::optional<Vec3> m_still_W, m_answered_W;  ///< Find: where the tip stands, and where it last answered
  bool m_asked = false;               ///< Find: has looked once since it opened
  std::size_t m_ring = 0;             ///< Pass: the next
  std::vector<Vec3> m_before_W;       ///< Pass: tips at the last step
};

/// 0…1: nothing unless done; less errorCost for each error; less in proportion where slower than timeGood.
double taskScore(const Task& task, const TaskRecord& record);

}  // namespace glenoid
