// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/check/Problem.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// What was seen of one surface, good or bad.
struct SurfaceFindings {
  std::string part;
  SurfaceKind kind = SurfaceKind::Visual;
  MeshHealth health;
  int cuts = 0;        ///< pairs of its own triangles that cut each other; 0 where an index is bad
  int firstCut = -1;   ///< a triangle of the first of them
};

/// Everything that a check looked at. `problems` come the worst first, then in the joint's order.
struct CheckReport {
  std::vector<Problem> problems;
  std::vector<SurfaceFindings> surfaces;
  int couplings = 0, springsMin = 0;
  int startPairs = 0;  ///< pairs of parts that may collide, all compared exactly

  int count(Severity severity) const;
  /// No error among them.
  bool holds() const { return count(Severity::Error) == 0; }
};

/// What was found to keep two rigid parts apart, by their visual and collision surfaces.
using RigidAdviceMemory = std::map<std::array<std::shared_ptr<const TriMesh>, 4>, RigidAdvice>;

/// Asked between pieces of work; false ends the check.
using CheckGoOn = std::function<bool()>;

/// Looks for problems, and remembers what it found about each mesh, so that looking again after an edit costs only what
/// the edit touched. One thread at a time.
class ProblemFinder {
 public:
  /// Never trips over a broken joint: a part whose meshes cannot be used is left out of what needs them. With a scenario
  /// that fixes or holds something, only that counts as staying; otherwise every rigid part does. Fails with Cancelled.
  Result<CheckReport> find(const Joint& joint, const Scenario* scenario = nullptr, const CheckGoOn& goOn = {});

 private:
  struct Seen {
    MeshHealth health;
    int cuts = 0, firstCut = -1;
  };
  std::map<std::shared_ptr<const TriMesh>, Seen> m_seen;
  RigidAdviceMemory m_advice;
};

/// The same once, without a memory.
std::vector<Problem> findProblems(const Joint& joint, const Scenario* scenario = nullptr);

}  // namespace glenoid
