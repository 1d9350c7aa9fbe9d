// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <deque>
#include <vector>

#include "simcore/live/StepMeter.h"

namespace glenoid {

/// What steps took over the last minutes, from all of them (StepMeter): half second by half second for a curve, and of the last second by
/// stage. Times without a step have NaN: a gap, and no line across it.
class StepSeries {
 public:
  static constexpr double kBucket = 0.5, kKept = 120, kRecent = 1.0;  ///< s by the clock

  struct Moment {
    double at = 0;             ///< s by the clock, middle of the half second
    double p50 = 0, p95 = 0;   ///< ms of thread CPU time a step; NaN: no step
  };
  struct Figures {
    double p50 = 0, p95 = 0;   ///< ms
  };

  /// `now`: s by the clock, ascending; the steps came since the last call.
  void add(double now, const StepMeter::Reading& reading);
  void clear();

  const std::deque<Moment>& moments() const { return m_moments; }
  /// Of the steps of the last second; NaN where there was none. Of several stages: of their sum, step by step.
  Figures step() const;
  Figures stages(const std::vector<Stage>& stages) const;
  bool hasSteps() const { return !m_recent.empty(); }

 private:
  struct Recent {
    double at;
    StepMeter::Step step;
  };
  void closeBucket();

  std::deque<Moment> m_moments;
  std::deque<Recent> m_recent;
  std::vector<float> m_bucket;
  double m_bucketEnd = -1;
};

}  // namespace glenoid
