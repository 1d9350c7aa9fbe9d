// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "simcore/live/RunReport.h"
#include "simcore/scene/Recording.h"

namespace glenoid {

/// What tools do to parts during the marks of a recording, step by step: N, s. The model must outlive it.
class MarkForces {
 public:
  static constexpr double kTouch = 1;  ///< N: a mark counts the time during which the net contact force was at least that

  /// `input` may be null: no marks. It is read here only.
  MarkForces(const Model& model, const Recording* input);

  /// `time`: at the beginning of the step, s.
  void add(const StepReport& step, double time);

  /// By mark of the recording.
  const std::vector<MarkReport>& reports() const { return m_reports; }

 private:
  const Model& m_model;
  std::vector<MarkReport> m_reports;
  std::vector<std::array<int, 2>> m_sides;  ///< tool and part of each mark, objects; −1: any
};

}  // namespace glenoid
