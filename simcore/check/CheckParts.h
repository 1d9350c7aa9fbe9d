// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/author/Overlaps.h"
#include "simcore/check/FindProblems.h"

/// The pieces of a check; private to this folder.
namespace glenoid::check {

/// What a check is about, and what it knows so far.
struct Work {
  const Joint& joint;
  const Scenario* scenario;    ///< null unless it fixes or holds something
  const CheckGoOn& goOn;
  CheckReport& report;
  std::vector<char> surfaces;  ///< of each part: both can be used
  std::vector<char> usable;    ///< of each part: surfaces and, where soft, tetrahedra can be used
  RigidAdviceMemory& advice;   ///< of earlier checks; what this one needs of it is moved to `adviceNow`
  RigidAdviceMemory adviceNow = {};
  bool stopped = false;

  bool goesOn() {
    if (!stopped && goOn && !goOn()) stopped = true;
    return !stopped;
  }
  Problem& add(ProblemKind kind, Severity severity, const std::string& part = {}) {
    Problem problem;
    problem.kind = kind;
    problem.severity = severity;
    problem.part = part;
    report.problems.push_back(std::move(problem));
    return report.problems.back();
  }
};

/// A surface that can be looked at: there, with indices inside and numbers that are finite.
bool isSound(const std::shared_ptr<const TriMesh>& mesh);

/// The joint with those parts alone that can be used, so that nothing trips over a broken one; `kept`: which they are.
Joint soundOnly(const Work& work, std::vector<std::size_t>& kept);

void checkSurface(Work& work, const SurfaceFindings& findings);
void checkVolume(Work& work, std::size_t part);
void checkMaterials(Work& work, const Part& part);
void checkUnits(Work& work);
void checkCouplings(Work& work);
void checkIslands(Work& work);
void checkWeight(Work& work);
void checkSteps(Work& work);
void checkAtStart(Work& work);

/// Least volume of a tetrahedron with its nodes at `start` over its volume at rest, and which one.
struct CrushedTets {
  double least = 1;
  long worst = -1;
  int below = 0;  ///< how many are below the limit
};
CrushedTets crushedTets(const TetMesh& mesh, const std::vector<Vec3>& start_W, double limit = kLeastVolumeRatio);
/// Longest part of the way from rest to where the handles stand that keeps kLeastVolumeRatio, in steps of 1/64; 0 when
/// none does.
double usableWay(const Joint& joint, const Cage& cage);

}  // namespace glenoid::check
