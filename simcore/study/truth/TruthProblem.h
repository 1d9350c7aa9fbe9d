// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "simcore/base/Error.h"
#include "simcore/study/truth/TruthBlocks.h"

namespace glenoid::truth {

/// What a problem is solved with.
struct TruthSetup {
  Elements elements = Elements::Tetrahedra;
  Profile profile = Profile::Direct;
  double stiffness =
      1;  ///< times Young's modulus of what is solved, not of what is known: a study that cannot tell is none
};

/// What was found, and how far it is from what is known, as a share of that.
struct TruthValue {
  double value = 0, error = 0;
};

/// What an error may be at the finest size of the full and of the quick form, and the least order at which
/// errors must fall (0: not asked). A bar is at or above what was measured when the problem was written, and
/// not so wide that a wrong element would pass, but for the contact patches with cells, which do not pass that test: their bars only say how far off they are.
struct TruthBar {
  double full = 0, quick = 0, order = 0;
};

/// One problem whose answer is known from elsewhere: a closed form, a published figure.
struct TruthProblem {
  const char* id;
  const char* title;
  const char* quantity;  ///< what is compared
  const char* unit;      ///< of it; "" where it is a number
  double known;  ///< in that unit; 0 where what is compared is an error itself, which would be nothing
  const char* source;
  const char* refined;        ///< what gets smaller: "cell", "step", "angle"
  const char* refinedUnit;    ///< of the sizes
  std::vector<double> sizes;  ///< from coarse to fine, SI
  std::size_t quick;          ///< the quick form takes so many of them, from the first
  bool byElements;  ///< whether the elements make a difference: it is then solved with tetrahedra and with
                    ///< cells
  TruthBar tetrahedra, cells;
  std::function<Result<TruthValue>(const TruthSetup&, double size)> solve;
  std::function<TruthScene(const TruthSetup&, double size)>
      scene;                 ///< the same as a user can open it; empty: it cannot be said in a scenario
  const char* noScene = "";  ///< and why
};

/// All of them, for `glenoid study truth` and for the tests.
std::span<const TruthProblem> truthProblems();
/// By its id, or null.
const TruthProblem* findTruthProblem(std::string_view id);

/// Their groups, each in a file of its own.
std::vector<TruthProblem> elasticProblems();  ///< static and free vibration of embedded bodies
std::vector<TruthProblem> motionProblems();   ///< whole steps without contact
std::vector<TruthProblem> contactProblems();  ///< whole steps with contact and friction

}  // namespace glenoid::truth
