// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/TrialReplay.h"

#include "simcore/body/State.h"

namespace glenoid {
namespace {

/// A model that begins elsewhere. The first stays, since what is inside of both may look into it.
struct BeginsAt {
  std::shared_ptr<const Model> first;
  Model model;
};

std::shared_ptr<const Model> beginningAt(std::shared_ptr<const Model> first, const State& start) {
  auto both = std::make_shared<BeginsAt>(BeginsAt{first, *first});
  both->model.start = start;
  return std::shared_ptr<const Model>(both, &both->model);
}

}  // namespace

TrialReplay::TrialReplay(PlayLink& link, QObject* parent) : QObject(parent), m_link(link) {
  connect(&link, &PlayLink::guestChanged, this, &TrialReplay::changed);
  connect(&link, &PlayLink::snapshotChanged, this, [this] {
    if (!isShown() || m_told || !m_progress->ended.load()) return;
    m_told = true;
    m_link.pause();
    emit changed();
  });
}

std::optional<bool> TrialReplay::sameAsStudied() const {
  const int same = m_progress ? m_progress->same.load() : -1;
  return same < 0 ? std::nullopt : std::optional(same == 1);
}

bool TrialReplay::hasEnded() const { return m_progress && m_progress->ended.load(); }

void TrialReplay::start(TrialToReplay trial) {
  m_progress = std::make_shared<Progress>();
  m_trial = trial.id;
  m_steps = trial.steps;
  m_told = false;
  const auto model = beginningAt(trial.run.model, trial.run.start);
  const auto kept = std::make_shared<const TrialToReplay>(std::move(trial));
  m_link.playGuest(model, [kept, progress = m_progress, eye = m_link.meter().eye()](std::shared_ptr<const Model> own, const StepperOptions&) -> StepFunction {
    const auto stepper = std::make_shared<Stepper>(own, kept->run.stepper);
    const auto last = std::make_shared<StepReport>();
    return [kept, progress, eye, own, stepper, last](const Inputs&, State& state) -> const StepReport& {
      const long step = state.step - kept->run.start.step;
      if (step >= kept->steps) return *last;  // it stands still
      const double time = static_cast<double>(step) * own->scenario.dt;
      if (kept->run.push) kept->run.push(time, state);
      eye->before(*stepper);
      *last = stepper->step(kept->run.hands ? kept->run.hands(time) : Inputs{}, state);
      eye->after(*stepper, own, *last, state);
      if (step + 1 == kept->steps) {
        if (!kept->stateHash.empty()) progress->same = toHex(stateHash(state)) == kept->stateHash;
        progress->ended = true;
      }
      return *last;
    };
  });
}

}  // namespace glenoid
