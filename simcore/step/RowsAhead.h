// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/step/StepWork.h"

namespace glenoid {

/// The contacts of a tool as the step to come would find them, looked for after this one, where the tool will be a moment later if it goes on as it
/// does. A step finds its own with the tool where it began; whoever uses them a step or two later has normals of where the tool was
/// three steps ago. Leaves the stepper as it was, bit by bit.
/// In the thread that steps, between two steps; the contacts are valid until the next step or find().
class RowsAhead {
 public:
  /// `bodies`: objects that the hand moves.
  RowsAhead(Stepper& stepper, std::span<const int> bodies);

  /// `ahead`: s after the step's end. Nothing that is fixed or soft is moved on.
  void find(const State& state, double ahead);

  const std::vector<StepContact>& contacts() const { return m_contacts; }
  const IslandRows& rows(std::size_t island) const { return m_rows[island]; }
  /// By how much a body was moved on: of its origin, m, and a rotation vector, rad.
  const Vec6& moved(std::size_t body) const { return m_moved[body]; }

 private:
  Stepper& m_stepper;
  std::vector<int> m_bodies;
  std::unique_ptr<ProximityFinder> m_finder;   ///< of pairs with one of the bodies
  std::vector<int> m_pairOf, m_ownOf;          ///< the stepper's pair of each of its own, and the other way; −1: none
  std::vector<char> m_used;                    ///< objects that some such pair names
  Stepper::Work::Surfaces m_positions;
  Stepper::Work::Spans m_spans;
  State m_state;
  std::vector<LastNormal> m_last;
  std::vector<Proximity> m_found;
  std::vector<StepContact> m_contacts;
  std::vector<std::array<int, 2>> m_sides;
  std::vector<Touch> m_touches;
  std::vector<int> m_touchOf;
  std::vector<IslandRows> m_rows;
  std::vector<Vec6> m_moved;
};

}  // namespace glenoid
