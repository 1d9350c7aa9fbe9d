// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/RunGather.h"

#include <algorithm>

#include "simcore/live/EffectStages.h"

namespace glenoid {

RunGather::RunGather(const Model& model, const Recording* input, long steps, Profile profile)
    : m_model(model),
      m_rest(model, input),
      m_dt(model.scenario.dt),
      m_marks(model, input),
      m_paper(profile == Profile::Paper) {
  m_step.reserve(steps);
  m_wall.reserve(steps);
  for (auto& stage : m_stages) stage.reserve(steps);
}

void RunGather::add(const StepReport& step, double time, const VecX& v) {
  ++m_steps;
  if (!step.taken) ++m_rejected;
  if (step.parts > 1) ++m_cut;
  if (step.deepOverlaps > 0) ++m_deep;
  if (step.bounded.any()) {
    if (!m_firstBounded) m_firstBounded = Notice{NoticeKind::Bounded, "", "", 0, 0, time + m_dt, m_steps, {}};
    ++m_bounded;
  }
  m_refusedHands += step.refusedHands;
  m_contacts += step.contacts;
  m_pressing += step.pressing;
  m_contactMax = std::max(m_contactMax, step.contacts);
  m_pressingMax = std::max(m_pressingMax, step.pressing);
  m_droppedMax = std::max(m_droppedMax, step.droppedRows);
  m_islandsMax = std::max(m_islandsMax, step.contactIslands);
  m_pivotsExhausted += step.pivotsExhausted;
  m_contactSolver.pivoting += step.contactSolver.pivoting;
  m_contactSolver.impulses += step.contactSolver.impulses;
  m_contactSolver.velocities += step.contactSolver.velocities;
  m_contactSolver.convex += step.contactSolver.convex;
  m_contactSolver.newtonMax = std::max(m_contactSolver.newtonMax, step.contactSolver.newtonMax);
  m_contactSolver.rowsMax = std::max(m_contactSolver.rowsMax, step.contactSolver.rowsMax);
  m_residual = std::max(m_residual, step.residual);
  m_complementarity = std::max(m_complementarity, step.complementarity);
  m_rest.add(step, time, v);
  m_step.push_back(static_cast<float>(step.stepCpuMs));
  m_wall.push_back(static_cast<float>(step.stepWallMs));
  m_wallMs += step.stepWallMs;
  m_cpuMs += step.stepCpuMs;
  for (int s = 0; s < kStageCount; ++s) m_stages[s].push_back(static_cast<float>(step.cpuMs[s]));
  m_marks.add(step, time);
  if (m_paper) addPaper(step.paper, step.contacts > 0);
}

void RunGather::addPaper(const PaperReport& paper, bool contact) {
  PaperSummary& sum = m_paperSummary;
  if (contact) {
    if (paper.d == "node") ++sum.nodeSteps;
    if (paper.d == "object") ++sum.objectSteps;
    m_outer += paper.outerIterations;
    ++m_outerSteps;
  }
  sum.lambdaMax = std::max(sum.lambdaMax, paper.lambdaMax);
  sum.cgIterationsMax = std::max(sum.cgIterationsMax, paper.cgIterations);
  sum.cgResidualMax = std::max(sum.cgResidualMax, paper.cgResidual);
  sum.outerIterationsMax = std::max(sum.outerIterationsMax, paper.outerIterations);
  sum.outerResidualMax = std::max(sum.outerResidualMax, paper.outerResidual);
  sum.cgCappedSteps += paper.cgCapped;
  sum.outerCappedSteps += paper.outerCapped;
  sum.divergedSteps += paper.diverged;
}

std::optional<Notice> RunGather::bounded() const {
  std::optional<Notice> notice = m_firstBounded;
  if (notice) {
    notice->figure = static_cast<double>(m_bounded);
    notice->limit = static_cast<double>(m_steps);
  }
  return notice;
}

void RunGather::finish(RunReport& report) {
  const double n = std::max<long>(m_steps, 1);
  report.steps = m_steps;
  report.seconds = static_cast<double>(m_steps) * m_dt;
  report.rejectedSteps = m_rejected;
  report.cutSteps = m_cut;
  report.boundedSteps = m_bounded;
  report.deepOverlapSteps = m_deep;
  report.refusedHands = m_refusedHands;
  report.pivotsExhausted = m_pivotsExhausted;
  report.contactSolver = m_contactSolver;
  report.residual = m_residual;
  report.complementarity = m_complementarity;
  report.contactIslandsMax = m_islandsMax;
  report.contacts = {std::nullopt, std::nullopt, "", m_contacts / n, m_pressing / n, m_contactMax, m_pressingMax, m_droppedMax};
  if (const auto rest = m_rest.contacts()) {
    report.contacts.rest = rest->rows;
    report.contacts.pressingRest = rest->pressing;
  } else report.contacts.restReason = m_rest.reason();
  report.stepsPerSecond = m_wallMs > 0 ? 1000.0 * static_cast<double>(m_steps) / m_wallMs : 0;
  report.stepsPerCpuSecond = m_cpuMs > 0 ? 1000.0 * static_cast<double>(m_steps) / m_cpuMs : 0;

  std::vector<float> effect(m_step.size());
  for (const EffectPlan& plan : m_model.effects) {
    EffectReport entry{plan.name, plan.on ? "on" : "off", plan.reason, std::nullopt, ""};
    const EffectStages* found = stagesOfEffect(plan.name);
    if (!plan.on) {
      entry.ms = 0;  // off: no code of it runs
    } else if (found && !found->own.empty()) {
      std::fill(effect.begin(), effect.end(), 0.0f);
      for (const Stage stage : found->own)
        for (std::size_t i = 0; i < effect.size(); ++i) effect[i] += m_stages[static_cast<int>(stage)][i];
      entry.ms = timingOf(effect).median;
    } else if (found) {
      entry.timedWith = found->shared;
    }
    report.effects.push_back(entry);
  }
  // After the effects: this sorts the times in place.
  report.step = timingOf(m_step);
  report.stepWall = timingOf(m_wall);
  for (int s = 0; s < kStageCount; ++s) report.stages[s] = timingOf(m_stages[s]);
  report.marks = m_marks.reports();
  if (m_paper) {
    m_paperSummary.outerIterationsMean = m_outerSteps ? m_outer / static_cast<double>(m_outerSteps) : 0;
    report.diverged = m_paperSummary.divergedSteps > 0;
    report.paper = m_paperSummary;
  }
}

}  // namespace glenoid
