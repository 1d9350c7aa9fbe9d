// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "simcore/train/TrainingReport.h"
#include "simcore/train/Trail.h"

namespace glenoid {

/// Follows a run step by step and judges the scenario's training: which tasks are open, done or missed, what tools did, which
/// limits were passed. Changes nothing of the run; a function of its steps, so that a run, its replay and the window give the same.
/// Once no task is left nothing more is counted. The model must outlive it; one thread.
class TrainingWatch {
 public:
  static constexpr double kTouch = 0.1;   ///< N: less is no touch in the metrics
  static constexpr double kOnRegion = 2e-3;  ///< m from a limit's region: a contact on it

  /// Of a scenario that has tasks. `raw`: keep what the metrics are made of (csv()).
  /// Fails with UnknownId where a task's place or tool is not in the model.
  static Result<TrainingWatch> make(const Model& model, bool raw = false);

  /// After every step.
  void add(const StepReport& step, const State& state);

  /// So far; after the last step the final one.
  TrainingReport report() const;

  TrainingReport tasksSoFar() const;  ///< the same without metrics and score, so at little cost
  bool finished() const { return m_finished; }
  /// By task, as they stand.
  const std::vector<TaskJudge>& judges() const { return m_judges; }

  /// A table with a header line and a row for the start and each counted step: time; of each tool that a hand holds
  /// TOOL.x y z (tip, m), TOOL.ax ay az (view, arthroscopes), TOOL.fx fy fz (force on it, N); of each limit LIMIT.force (N);
  /// of each task TASK.outcome (0 waiting, 1 open, 2 done, 3 missed), TASK.errors and TASK.seen (s). Numbers read back as they were.
  std::string csv() const;

 private:
  struct ToolTrail {
    int object = -1;
    CarriedPoint tip;
    bool scope = false;
    std::vector<Vec3> tips, axes;    ///< W, the start and every counted step
    double forceMax = 0, forceSum = 0, touchSeconds = 0, straight = 0;
    Vec3 from_W = Vec3::Zero();      ///< where its last task ended
  };
  struct LimitWatch {
    BoundPlace place;
    double force = 0, forceMax = 0, touchSeconds = 0, tooHardSeconds = 0, below = TaskJudge::kBelow;
    int tooHard = 0;
  };

  explicit TrainingWatch(const Model& model) : m_model(&model) {}
  void openTasks(double time);
  void takeUp(const StepSeen& seen);
  void watchOrder(const StepSeen& seen);
  void watchLimits(const StepSeen& seen);
  void addTrails(const StepSeen& seen);
  void addRow(double time, const StepSeen* seen);
  std::vector<Metric> metrics() const;

  const Model* m_model;
  std::vector<TaskJudge> m_judges;
  std::vector<ToolTrail> m_trails;
  std::vector<LimitWatch> m_limits;  ///< by limit
  std::vector<int> m_doneOrder;      ///< tasks in the order they were done
  std::vector<char> m_early;         ///< by task: was pressed before its turn
  std::vector<char> m_pressed;       ///< by task that waits: was pressed in the last step
  int m_orderErrors = 0;
  double m_begin = 0, m_end = 0;
  bool m_finished = false, m_raw = false;
  std::vector<double> m_rows;
  int m_columns = 0;
};

}  // namespace glenoid
