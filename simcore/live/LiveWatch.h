// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <condition_variable>
#include <mutex>
#include <thread>

#include "simcore/live/MarkForces.h"
#include "simcore/live/RestWatch.h"
#include "simcore/live/StepWatch.h"

namespace glenoid {

/// Says about a run against the clock what a run without a window says in its report, by the same rules: RunWatch,
/// PenetrationProbe with its own limits, noticesBefore and missed marks. Depth and stretch cost a good part of a step, so a
/// thread of its own looks at copies of the newest state and takes no more than a third of a core: where the machine is busy,
/// steps in between go unseen (a run without a window sees every one). A depth is told again once it is a tenth deeper. A mark
/// is judged only when all hands kept to the recording from its beginning to its end.
class LiveWatch final : public StepWatch {
 public:
  static constexpr double kDeeper = 1.1;  ///< a depth over the one last told
  static constexpr int kRest = 2;         ///< times as long as a look took until the next

  LiveWatch(std::shared_ptr<const Model> model, std::shared_ptr<const Recording> input, std::function<void()> told);
  ~LiveWatch() override;

  void look(const StepReport& step, const State& state, bool onPath) override;
  void add(const Notice& notice) override;
  std::shared_ptr<const std::vector<Notice>> notices() const override;
  RestState rest() const override { return m_rest; }

 private:
  struct Seen {
    State state;  ///< q, time and step only
    std::vector<DentView> dents;
  };
  void judgeMarks(const StepReport& step, const State& state, bool onPath);
  void work();
  void tell();  ///< under m_mutex

  const std::shared_ptr<const Model> m_model;
  const std::shared_ptr<const Recording> m_input;
  const std::function<void()> m_told;

  // The thread that steps.
  MarkForces m_marks;
  RestWatch m_restWatch;
  RestState m_rest;
  std::vector<char> m_judged;  ///< by mark
  double m_onPathSince;        ///< s; infinite: they are not

  mutable std::mutex m_mutex;
  std::condition_variable m_wake;
  Seen m_newest;
  bool m_fresh = false, m_quit = false;
  std::vector<Notice> m_before, m_missed, m_found;
  std::shared_ptr<const std::vector<Notice>> m_notices;

  std::thread m_worker;  ///< last, so that all is there
};

/// The WatchMaker of a real run.
std::unique_ptr<StepWatch> makeLiveWatch(std::shared_ptr<const Model> model, std::shared_ptr<const Recording> input, std::function<void()> told);

}  // namespace glenoid
