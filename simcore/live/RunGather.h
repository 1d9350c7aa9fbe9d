// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "simcore/live/MarkForces.h"
#include "simcore/live/RunReport.h"
#include "simcore/scene/Recording.h"

namespace glenoid {

/// First moment at which a hand of the recording moves, s; nothing when none does.
std::optional<double> firstMotion(const Recording* input);

/// Window [begin, end) in s over which contacts at rest are averaged: the half second before the first motion,
/// or before the end where nothing moves, after one second of settling. Empty (begin ≥ end) when there is none.
struct RestWindow {
  double begin = 0, end = 0;
};
RestWindow restWindow(std::optional<double> motion, double runSeconds);

/// Collects a run step by step into a report. Private to live/.
class RunGather {
 public:
  RunGather(const Model& model, const Recording* input, long steps, Profile profile);

  /// `time`: at the beginning of the step.
  void add(const StepReport& step, double time);

  /// Fills everything that comes from the steps.
  void finish(RunReport& report);

 private:
  void addPaper(const PaperReport& paper, bool contact);

  const Model& m_model;
  RestWindow m_rest;
  double m_dt;
  ContactSolverSummary m_contactSolver;
  long m_steps = 0, m_rejected = 0, m_cut = 0, m_refusedHands = 0, m_pivotsExhausted = 0, m_restSteps = 0, m_outerSteps = 0;
  double m_restContacts = 0, m_restPressing = 0, m_contacts = 0, m_pressing = 0, m_residual = 0, m_complementarity = 0, m_outer = 0, m_wallMs = 0, m_cpuMs = 0;
  int m_contactMax = 0, m_pressingMax = 0, m_droppedMax = 0, m_islandsMax = 0;
  std::vector<float> m_step, m_wall;
  std::array<std::vector<float>, kStageCount> m_stages;
  MarkForces m_marks;
  bool m_paper;
  PaperSummary m_paperSummary;
};

}  // namespace glenoid
