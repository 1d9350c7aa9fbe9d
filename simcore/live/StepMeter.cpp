// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/StepMeter.h"

#include <utility>

namespace glenoid {

StepMeter::StepMeter() : m_eye(std::make_shared<Eye>()) {}

StepMaker StepMeter::maker() const {
  return [eye = m_eye](std::shared_ptr<const Model> model, const StepperOptions& options) -> StepFunction {
    const auto stepper = std::make_shared<Stepper>(model, options);
    return [eye, model, stepper](const Inputs& inputs, State& state) -> const StepReport& {
      eye->before(*stepper);
      const StepReport& report = stepper->step(inputs, state);
      eye->after(*stepper, model, report, state);
      return report;
    };
  };
}

void StepMeter::setWanted(bool wanted) {
  const std::lock_guard lock(m_eye->m_mutex);
  m_eye->m_wanted.store(wanted, std::memory_order_relaxed);
  if (wanted) return;
  m_eye->m_reading = {};
}

bool StepMeter::isWanted() const { return m_eye->m_wanted.load(std::memory_order_relaxed); }

StepMeter::Reading StepMeter::take() {
  const std::lock_guard lock(m_eye->m_mutex);
  return std::exchange(m_eye->m_reading, {});
}

void StepMeter::Eye::after(Stepper& stepper, const std::shared_ptr<const Model>& model, const StepReport& report, const State& state) {
  const IslandViews* islands = islandViews(stepper);
  if (!islands) return;
  Step step;
  step.time = state.time;
  step.cpuMs = static_cast<float>(report.stepCpuMs);
  step.wallMs = static_cast<float>(report.stepWallMs);
  for (std::size_t s = 0; s < step.stages.size(); ++s) step.stages[s] = static_cast<float>(report.cpuMs[s]);
  step.contacts = report.contacts;
  const std::lock_guard lock(m_mutex);
  if (!m_wanted.load(std::memory_order_relaxed)) return;  // a step that was under way when nobody looked any more
  if (m_reading.model != model) m_reading.steps.clear();  // another scene's figures
  if (m_reading.steps.size() >= kMost) m_reading.steps.erase(m_reading.steps.begin(), m_reading.steps.begin() + kMost / 2);
  m_reading.steps.push_back(step);
  m_reading.model = model;
  m_reading.islands = *islands;
}

}  // namespace glenoid
