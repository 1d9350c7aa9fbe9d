// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "simcore/live/MarkForces.h"
#include "simcore/live/RestWatch.h"
#include "simcore/live/RunReport.h"
#include "simcore/scene/Recording.h"

namespace glenoid {

/// Collects a run step by step into a report. Private to live/.
class RunGather {
 public:
  RunGather(const Model& model, const Recording* input, long steps, Profile profile);

  /// `time`: at the beginning of the step; `v`: of the state at its end.
  void add(const StepReport& step, double time, const VecX& v);

  /// Said where contacts of some steps would have cost more than a step may; after the last step.
  std::optional<Notice> bounded() const;

  /// Fills everything that comes from the steps.
  void finish(RunReport& report);

 private:
  void addPaper(const PaperReport& paper, bool contact);

  const Model& m_model;
  RestWatch m_rest;
  double m_dt;
  ContactSolverSummary m_contactSolver;
  long m_steps = 0, m_rejected = 0, m_cut = 0, m_bounded = 0, m_deep = 0, m_refusedHands = 0, m_pivotsExhausted = 0, m_outerSteps = 0;
  std::optional<Notice> m_firstBounded;
  double m_contacts = 0, m_pressing = 0, m_residual = 0, m_complementarity = 0, m_outer = 0, m_wallMs = 0, m_cpuMs = 0;
  int m_contactMax = 0, m_pressingMax = 0, m_droppedMax = 0, m_islandsMax = 0;
  std::vector<float> m_step, m_wall;
  std::array<std::vector<float>, kStageCount> m_stages;
  MarkForces m_marks;
  bool m_paper;
  PaperSummary m_paperSummary;
};

}  // namespace glenoid
