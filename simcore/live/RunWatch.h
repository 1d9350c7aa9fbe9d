// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "simcore/body/SoftObject.h"
#include "simcore/live/RunReport.h"
#include "simcore/scene/Recording.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// Looks after every step for what no load may do: carry a part away by many times its own size, stretch tissue as no
/// tissue stretches, turn elements inside out or press them beyond what their law holds. Outside the step's time. The model
/// must outlive it.
class RunWatch {
 public:
  static constexpr double kSizesAway = 10;    ///< a part's middle went that many of its sizes (diagonal of its box at rest)
  static constexpr double kStretchMost = 3;   ///< an edge of a tetrahedron over its length at rest; tendons tear at 1.1, muscle below 2

  /// `stretchLaw`: as StepSettings.
  explicit RunWatch(const Model& model, bool stretchLaw = true);
  void look(const State& state);
  const std::vector<Notice>& notices() const { return m_notices; }  ///< one of each kind for a part, in the order they came
  /// Most elements of a free soft object in trouble at one look, each figure by itself; nothing of other objects.
  std::optional<TissueTrouble> troubleMost(int object) const;

 private:
  struct Watched {
    int object;
    Vec3 start_W;   ///< middle at the start
    double size;    ///< m
    std::vector<std::array<int, 2>> edges;  ///< soft: of its tetrahedra
    std::vector<double> longest2;           ///< square of kStretchMost lengths at rest
    bool away = false, stretched = false;
    TissueTrouble most;
  };
  void countElements(Watched& watched, const State& state);
  const Model& m_model;
  const bool m_stretchLaw;
  std::vector<Watched> m_watched;
  std::vector<Notice> m_notices;
};

/// What is known before a run, from the plan of its model: wishes that do nothing, effects with nothing to act on, and a
/// recording whose path Δt cuts short by more than the contact distance within the first `seconds`.
std::vector<Notice> noticesBefore(const Model& model, const Recording* input, double seconds);

/// Whether the net contact force on what a mark names, tool or part, stayed below 1 N during its whole length: what it was
/// recorded for did not happen. A mark that names neither is never missed.
bool isMissed(const MarkReport& mark);
Notice missedMark(const MarkReport& mark, double dt);

/// The missed marks of those that the run covers; nothing where contact is off.
std::vector<Notice> missedMarks(const RunReport& report);

}  // namespace glenoid
