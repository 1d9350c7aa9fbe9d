// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <vector>

#include "simcore/check/FindProblems.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {

inline const Problem* problemOf(const std::vector<Problem>& problems, ProblemKind kind, const std::string& part = {}) {
  const auto found = std::find_if(problems.begin(), problems.end(), [&](const Problem& p) {
    return p.kind == kind && (part.empty() || p.part == part);
  });
  return found == problems.end() ? nullptr : &*found;
}

inline bool has(const std::vector<Problem>& problems, ProblemKind kind, const std::string& part = {}) {
  return problemOf(problems, kind, part) != nullptr;
}

/// A copy of a mesh, changed, in the place of the shared one.
template <class Mesh, class Change>
void changeMesh(std::shared_ptr<const Mesh>& mesh, Change change) {
  Mesh copy = *mesh;
  change(copy);
  mesh = std::make_shared<const Mesh>(std::move(copy));
}

/// Bone – tissue – bone in a row, coupled at both faces, with contact switched off where they are glued: no fault in it.
inline Joint soundJoint() {
  Joint joint = scenes::figure4Joint();
  for (std::size_t a = 0; a < joint.parts.size(); ++a)
    for (std::size_t b = a + 1; b < joint.parts.size(); ++b)
      joint.exclusions.push_back({joint.parts[a].id, joint.parts[b].id, "glued"});
  return joint;
}

inline Part& softPart(Joint& joint) {
  return *std::find_if(joint.parts.begin(), joint.parts.end(), [](const Part& p) { return p.kind == PartKind::Soft; });
}

/// A cage of eight corners around the soft part, `margin` (m) outside of it.
inline Cage boxCage(const Part& part, double margin) {
  Box3 box = boundsOf(*part.visual);
  box.min().array() -= margin;
  box.max().array() += margin;
  const TriMesh surface = scenes::boxSurface(box.min(), box.max(), 1);
  return {part.id + "-cage", part.id, surface.triangles, surface.vertices, surface.vertices};
}

}  // namespace glenoid
