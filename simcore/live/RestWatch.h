// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "simcore/scene/Recording.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// When a track's hand begins to move, s; nothing when it never does.
std::optional<double> firstMotion(const HandTrack& track);

/// Finds when a running scene is at rest, and how many contacts it then has. A step is at rest when the loads are whole
/// (Scenario::loadRise), no point of a part moves faster than kSlow, and no tool whose hand has begun to move has a contact. What
/// counts is the first stretch of such steps that lasts at least kLeast, and of that the last kMost. Parts that move by keys
/// count with the others; hands and tools in the air do not. Sees steps in order; the model must outlive it. SI units.
class RestWatch {
 public:
  static constexpr double kSlow = 1e-3;  ///< m/s: half a millimetre on the way through the longest stretch that is counted
  static constexpr double kLeast = 0.1;  ///< s: shorter, it may be the turn of a swing
  static constexpr double kMost = 0.5;   ///< s

  /// `input` may be null; it is read here only.
  RestWatch(const Model& model, const Recording* input);

  /// `time`: at the beginning of the step; `v`: of the state at its end.
  void add(const StepReport& step, double time, const VecX& v);

  /// The last step was at rest, and was but for touches; its loads were not whole yet.
  bool isAtRest() const { return m_atRest; }
  bool isSlow() const { return m_slow > 0; }
  bool loadsRise() const { return m_rise; }
  /// Of the fastest point of any part in the last step, m/s; an upper bound where a rigid part turns.
  double speed() const { return m_speed; }

  struct Contacts {
    double rows = 0, pressing = 0;  ///< means
  };
  /// Nothing where the run has not come to rest; then reason() says why.
  std::optional<Contacts> contacts() const;
  /// "loads-still-rise", "parts-still-move", "tools-touch", or empty.
  std::string reason() const;

 private:
  struct Part {
    int object;
    double reach;      ///< m: furthest point of its surface from its centre, of a driven part from the motion's centre
    int motion = -1;   ///< of the scenario; −1: free
  };
  double fastest(double time, const VecX& v) const;
  bool touches(const StepReport& step, double time) const;

  const Model& m_model;
  std::vector<Part> m_parts;
  std::vector<double> m_moves;  ///< by object: when its hand begins to move, s; infinite for parts and hands that never do
  std::deque<Contacts> m_stretch;
  bool m_over = false;          ///< m_stretch is what counts, and no longer grows
  bool m_atRest = false, m_rise = false, m_whole = false;
  double m_speed = 0;
  int m_slow = 0, m_slowMost = 0;  ///< steps in a row, touched or not
};

}  // namespace glenoid
