// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "simcore/live/SimulationThread.h"
#include "simcore/step/IslandViews.h"

namespace glenoid {

/// Keeps what every step of a run took, for who looks now and then: a view of snapshots would miss most steps. While nobody
/// wants it nothing is kept, and steps do not look at their islands. Steps are looked at in the thread that takes them; the rest may
/// be called from any other.
class StepMeter {
 public:
  struct Step {
    double time = 0;                          ///< s, simulated, at its end
    float cpuMs = 0, wallMs = 0;
    std::array<float, kStageCount> stages{};  ///< thread CPU time, ms
    int contacts = 0;
  };
  /// Since the last one was taken.
  struct Reading {
    std::vector<Step> steps;             ///< in order; the newest kMost where nobody came for longer
    std::shared_ptr<const Model> model;  ///< of the last of them; null: there was none
    IslandViews islands;                 ///< likewise
  };
  static constexpr std::size_t kMost = 4096;

  StepMeter();
  /// Makes the steps of a real run (makeStepperStep) and looks at each; may outlive the meter.
  StepMaker maker() const;
  /// The same for who steps by himself: before and after a step of a real run.
  class Eye;
  std::shared_ptr<Eye> eye() const { return m_eye; }

  void setWanted(bool wanted);
  bool isWanted() const;
  Reading take();

 private:
  std::shared_ptr<Eye> m_eye;
};

class StepMeter::Eye {
 public:
  void before(Stepper& stepper) { watchIslands(stepper, m_wanted.load(std::memory_order_relaxed)); }
  /// `model`: the stepper's.
  void after(Stepper& stepper, const std::shared_ptr<const Model>& model, const StepReport& report, const State& state);

 private:
  friend class StepMeter;
  std::atomic<bool> m_wanted{false};
  std::mutex m_mutex;
  Reading m_reading;
};

}  // namespace glenoid
