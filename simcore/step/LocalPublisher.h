// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <vector>

#include "simcore/contact/LocalProblem.h"
#include "simcore/linear/SparseRow.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

class IslandRows;
class RowsAhead;
struct StepContact;

/// Copies out of a step what a tool can touch next, for a loop that runs faster than the simulation (LocalProblem).
/// What the other sides give is that of their own coupling islands, Δt² J A⁻¹ Jᵀ of the step, without the tool's; the rows by
/// which they press on something else stay shut (a Schur complement over at most kOthers of them, the most loaded), so
/// tissue that lies on bone is as stiff as on bone. How they move on by themselves is what the last step's forces, still acting,
/// would have made of them in this one; a start or a step that was cut has no last one, and they then go on as they went.
/// Works with the profiles `direct` and `reference`; `paper` factors no matrix, so nothing is valid there.
/// With `stepsAhead` the rows are those that the tool meets so many steps after this one if it goes on as it does (RowsAhead.h), which is when they
/// are used; without, those of the step.
/// Normal forces only: what friction does to a tool is not in it.
/// In the thread that steps, after a step and before the next one.
class LocalPublisher {
 public:
  static constexpr int kOthers = 64;

  explicit LocalPublisher(Stepper& stepper, double stepsAhead = 0);
  ~LocalPublisher();

  /// Once after every step, before read(): keeps what the next step compares with.
  void stepped(const StepReport& report);
  /// The problem of a tool that a hand holds. Not valid for one that another tool carries, after a step that was not taken,
  /// and without contact. Leaves `stamp` to the caller. Of several tools carried by one only the first is a body of it.
  void read(const State& state, int tool, LocalProblem& out);

 private:
  struct Bodies;
  const std::vector<StepContact>& contacts() const;  ///< that rows are taken from
  const IslandRows& rowsOf(std::size_t island) const;
  void chooseRows(const Bodies& bodies);
  void chooseOthers(const Bodies& bodies);
  void fill(const Bodies& bodies, double h, LocalProblem& out);
  void condense(double h, LocalProblem& out);

  Stepper& m_stepper;
  bool m_taken = false, m_known = false;  ///< m_known: m_free is what m_last and this step make of the islands
  std::vector<VecX> m_last, m_free;       ///< by island: J^T λ of the last step; free velocities under it
  std::vector<std::unique_ptr<RowsAhead>> m_aheadOf;  ///< by tool, made when it is first asked for; empty: the step's own rows
  RowsAhead* m_ahead = nullptr;           ///< of the tool at hand
  double m_stepsAhead;
  std::vector<int> m_rows;                ///< of contacts()
  std::vector<int> m_given, m_others;     ///< of the step's contacts: the tool's that press, where rows are others; what else presses
  std::vector<int> m_slot, m_stepSlot;    ///< of each of contacts(), of each of the step's; −1: none
  std::vector<char> m_reached;            ///< islands on the other sides
  std::vector<SparseRow> m_islandRows;
  std::vector<int> m_ids;
  MatX m_G, m_X, m_C;
  VecX m_w;
};

}  // namespace glenoid
