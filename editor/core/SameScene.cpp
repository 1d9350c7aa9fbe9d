// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/SameScene.h"

#include <algorithm>

namespace glenoid {
namespace {

/// Ids of what is in one list and not the same in the other.
template <class T, class Same>
void collect(const std::vector<T>& from, const std::vector<T>& other, Same same, std::set<std::string>& ids) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const T& thing = from[i];
    if (i < other.size() && other[i].id == thing.id) {
      if (!same(thing, other[i])) ids.insert(thing.id);
      continue;
    }
    const auto found = std::find_if(other.begin(), other.end(), [&](const T& o) { return o.id == thing.id; });
    if (found == other.end() || !same(thing, *found)) ids.insert(thing.id);
  }
}

const auto kEqual = [](const auto& a, const auto& b) { return a == b; };

}  // namespace

bool sameMeshes(const Part& a, const Part& b) {
  return a.visual == b.visual && a.collision == b.collision && a.volume == b.volume;
}

bool samePart(const Part& a, const Part& b) {
  return sameMeshes(a, b) && a.id == b.id && a.number == b.number && a.name == b.name && a.kind == b.kind &&
         a.color == b.color && a.cellSize == b.cellSize && a.elements == b.elements && a.materials == b.materials && a.regions == b.regions &&
         a.landmarks == b.landmarks && (a.dents == b.dents || (a.dents && b.dents && *a.dents == *b.dents));
}

bool sameJoint(const Joint& a, const Joint& b) {
  return a.id == b.id && a.name == b.name && a.description == b.description && a.side == b.side && a.axes_W == b.axes_W && a.materials == b.materials && a.couplings == b.couplings &&
         a.exclusions == b.exclusions && a.bursae == b.bursae && a.cages == b.cages && a.startProof == b.startProof &&
         a.provenance == b.provenance &&
         std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(), samePart);
}

ChangeSet changesBetween(const Joint& before, const Joint& after) {
  ChangeSet changes;
  collect(before.parts, after.parts, samePart, changes.parts);
  collect(after.parts, before.parts, samePart, changes.parts);
  collect(before.materials, after.materials, kEqual, changes.materials);
  collect(after.materials, before.materials, kEqual, changes.materials);
  collect(before.couplings, after.couplings, kEqual, changes.couplings);
  collect(after.couplings, before.couplings, kEqual, changes.couplings);
  std::set<std::string> cages;
  collect(before.cages, after.cages, kEqual, cages);
  collect(after.cages, before.cages, kEqual, cages);
  for (const auto* joint : {&before, &after})
    for (const Cage& cage : joint->cages)
      if (cages.count(cage.id)) changes.parts.insert(cage.part);
  if (before.exclusions != after.exclusions)
    for (const auto* joint : {&before, &after})
      for (const Exclusion& exclusion : joint->exclusions) changes.parts.insert({exclusion.partA, exclusion.partB});
  changes.model = !sameJoint(before, after);
  return changes;
}

}  // namespace glenoid
