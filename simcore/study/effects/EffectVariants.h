// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "simcore/step/LocalPublisher.h"
#include "simcore/study/accuracy/AccuracyTrace.h"

namespace glenoid {

enum class EffectChoice { Off, On, Auto };
inline constexpr int kEffectChoices = 3;
Wish wishOf(EffectChoice choice);

/// The wish of an effect by its name; null where there is none of that name.
Wish* wishNamed(Effects& effects, const std::string& name);

/// A scene compiled with one effect as chosen and all others as they are. Haptics is no part of the step:
/// what it adds is a player's.
Result<std::shared_ptr<const Model>> modelWith(const StudyScene& scene, const std::string& effect,
                                               EffectChoice choice);

/// Effects that one model has and the other lacks, but for `except`.
std::vector<std::string> effectsMissing(const Model& without, const Model& with, const std::string& except);

/// Runs one choice of one effect from windows' states.
class EffectPlayer {
 public:
  /// `judge`: as AccuracyPlayer's. `felt`: after every step the local problem of each hand is copied out, as
  /// a run in real time does.
  EffectPlayer(const std::shared_ptr<const Model>& base, const std::shared_ptr<const Model>& model,
               const std::shared_ptr<const Model>& judge, const Recording& input, bool felt);

  AccuracyPlayer& player() { return m_player; }
  /// One step from a state, with what the effect adds after it. Answers ms of thread CPU time, by one clock
  /// for all choices.
  double step(State& state);
  const StepReport& report() const { return *m_report; }

 private:
  AccuracyPlayer m_player;
  std::unique_ptr<LocalPublisher> m_publisher;  ///< null: not felt
  std::vector<int> m_hands;                     ///< tools that hands hold
  LocalProblem m_problem;
  const StepReport* m_report = nullptr;
};

}  // namespace glenoid
