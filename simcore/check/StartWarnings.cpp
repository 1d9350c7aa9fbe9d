// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/check/StartWarnings.h"

#include <algorithm>

#include "simcore/author/Overlaps.h"
#include "simcore/check/CheckParts.h"
#include "simcore/embed/Bind.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/scene/Start.h"

namespace glenoid {
namespace {

Problem warning(ProblemKind kind, const Part& part, double figure, double wanted) {
  Problem problem;
  problem.kind = kind;
  problem.severity = Severity::Warning;
  problem.part = part.id;
  problem.figure = figure;
  problem.wanted = wanted;
  return problem;
}

}  // namespace

std::vector<Problem> startWarnings(const Part& part, const std::vector<Vec3>& start_W) {
  std::vector<Problem> problems;
  const TriMesh& surface = *part.collision;
  const double thickness = 2 * enclosedVolume(surface) / healthOf(surface).area;
  double most = 0;
  const std::vector<VertexBinding> bound = bindToTets(*part.volume, surface.vertices);
  for (std::size_t v = 0; v < bound.size(); ++v)
    most = std::max(most, (boundPosition(bound[v], start_W) - boundPosition(bound[v], part.volume->nodes)).norm());
  if (most > thickness) problems.push_back(warning(ProblemKind::CageMovesFar, part, most, thickness));
  const check::CrushedTets squeezed = check::crushedTets(*part.volume, start_W, kSqueezedRatio);
  if (squeezed.below > 0 && squeezed.least >= kLeastVolumeRatio) {
    Problem problem = warning(ProblemKind::CageSqueezes, part, squeezed.least, kSqueezedRatio);
    problem.count = squeezed.below;
    problem.element = squeezed.worst;
    problems.push_back(std::move(problem));
  }
  return problems;
}

Result<std::vector<Problem>> startWarnings(const Joint& joint) {
  std::vector<Problem> problems;
  for (const Part& part : joint.parts) {
    if (part.kind != PartKind::Soft || !findCage(joint, part.id)) continue;
    const auto nodes = startNodes(joint, part);
    if (!nodes) return nodes.error();
    for (Problem& problem : startWarnings(part, *nodes)) problems.push_back(std::move(problem));
  }
  return problems;
}

}  // namespace glenoid
