// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/CarryState.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "simcore/collide/FeatureKey.h"
#include "simcore/step/StepModel.h"

namespace glenoid {
namespace {

template <class T>
bool sameContent(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && *a == *b);
}

/// Where the rotations of each object's elements begin in State::rotations, and their end.
std::vector<int> rotationOffsets(const Model& model) {
  std::vector<int> offsets{0};
  for (const SceneObject& object : model.objects)
    offsets.push_back(offsets.back() + 4 * object.elements);
  return offsets;
}

/// For each object of `to` the one of `from` whose motion it takes over; −1: none.
std::vector<int> sourcesOf(const Model& from, const Model& to) {
  std::vector<int> sources;
  for (const SceneObject& target : to.objects) {
    const auto found = std::find_if(from.objects.begin(), from.objects.end(), [&](const SceneObject& object) {
      return object.tool == target.tool && object.id == target.id;
    });
    const bool carries = found != from.objects.end() && found->layout.rigid == target.layout.rigid &&
                         found->layout.qSize == target.layout.qSize &&
                         (target.layout.rigid || (found->cells == target.cells && sameContent(found->volume, target.volume)));
    sources.push_back(carries ? static_cast<int>(found - from.objects.begin()) : -1);
  }
  return sources;
}

/// The mass centre of a rigid object in the frame in which its surface is drawn.
Vec3 centreOf(const SceneObject& object) { return object.visual.mesh->vertices[0] - object.visual.vertices[0].r_B; }

/// How the mass centre has moved in the object's own frame; zero to the last bit where nothing that it depends on changed.
Vec3 centreShift(const SceneObject& from, const SceneObject& to) {
  if (sameContent(from.visual.mesh, to.visual.mesh)) return from.visual.vertices[0].r_B - to.visual.vertices[0].r_B;
  return centreOf(to) - centreOf(from);
}

void carryObject(const SceneObject& from, const State& old, const State& oldStart, const SceneObject& to, State& carried) {
  const ObjectLayout &a = from.layout, &b = to.layout;
  if (!b.free && (a.free || old.q.segment(a.qOffset, a.qSize) == oldStart.q.segment(a.qOffset, a.qSize))) return;
  carried.q.segment(b.qOffset, b.qSize) = old.q.segment(a.qOffset, a.qSize);
  if (a.vSize == b.vSize) carried.v.segment(b.vOffset, b.vSize) = old.v.segment(a.vOffset, a.vSize);
  if (!b.rigid || !from.visual.mesh || !to.visual.mesh) return;
  const Vec3 shift_B = centreShift(from, to);
  if (shift_B.isZero(0)) return;
  Pose pose = poseAt(carried.q, b.qOffset);
  const Vec3 shift_W = pose.q_WB * shift_B;
  pose.p_WB += shift_W;
  setPoseAt(carried.q, b.qOffset, pose);
  if (a.vSize == b.vSize && b.vSize == 6) {
    const Vec3 omega_W = carried.v.segment<3>(b.vOffset + 3);
    carried.v.segment<3>(b.vOffset) += omega_W.cross(shift_W);
  }
}

void carryHands(const Model& from, const State& old, const Model& to, State& carried) {
  for (std::size_t tool = 0; tool < to.scenario.tools.size(); ++tool) {
    const int source = findTool(from.scenario, to.scenario.tools[tool].id);
    const int at = 7 * static_cast<int>(tool), last = 7 * source;
    if (source < 0 || last + 7 > old.hands.size() || at + 7 > carried.hands.size()) continue;
    carried.hands.segment<7>(at) = old.hands.segment<7>(last);
  }
}

/// What a pair of the old model is called in the new one.
struct NewName {
  int pair = -1;  ///< −1: its impulses are dropped
  bool swapped = false;
};

std::vector<NewName> newNames(const Model& from, const Model& to, const std::vector<int>& sources) {
  std::map<std::array<int, 2>, int> pairOf;  // by objects of `to`
  for (std::size_t p = 0; p < to.collisionPairs.size(); ++p)
    pairOf[{to.collisionPairs[p].surfaceA, to.collisionPairs[p].surfaceB}] = static_cast<int>(p);
  std::vector<int> heir(from.objects.size(), -1);
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (sources[i] >= 0 && sameContent(from.objects[sources[i]].collision.mesh, to.objects[i].collision.mesh))
      heir[sources[i]] = static_cast<int>(i);
  std::vector<NewName> names;
  for (const CollisionPair& pair : from.collisionPairs) {
    const int a = heir[pair.surfaceA], b = heir[pair.surfaceB];
    NewName& name = names.emplace_back();
    if (a < 0 || b < 0) continue;
    for (const bool swapped : {false, true})
      if (swapped && a == b)
        continue;  // of a part with itself there is but one order
      else if (const auto found = pairOf.find(swapped ? std::array{b, a} : std::array{a, b}); found != pairOf.end())
        name = {found->second, swapped};
  }
  return names;
}

/// Places on the floor of a bursa by what stays: the bursa's id, the object's id and the vertex.
using FilmPlace = std::tuple<std::string, std::string, int>;
std::map<FilmPlace, int> filmKeys(const Model& model) {
  std::map<FilmPlace, int> keys;
  if (!model.inside) return keys;
  for (const FilmModel& film : model.inside->films)
    for (std::size_t i = 0; i < film.sides.floor.size(); ++i) {
      const FilmSides::Vertex& vertex = film.sides.floor[i];
      keys[{film.id, model.objects[vertex.surface].id, vertex.vertex}] = film.firstKey + static_cast<int>(i);
    }
  return keys;
}

/// The new key of each old place of a film.
std::map<int, int> filmNames(const Model& from, const Model& to, const std::vector<int>& sources) {
  std::map<int, int> names;
  const std::map<FilmPlace, int> old = filmKeys(from), now = filmKeys(to);
  for (const auto& [place, key] : now) {
    const auto found = old.find(place);
    if (found == old.end()) continue;
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (!to.objects[i].tool && to.objects[i].id == std::get<1>(place) && sources[i] >= 0 &&
          sameContent(from.objects[sources[i]].collision.mesh, to.objects[i].collision.mesh))
        names[found->second] = key;
  }
  return names;
}

void carryImpulses(const Model& from, const State& old, const Model& to, const std::vector<int>& sources, State& carried) {
  if (old.impulses.empty()) return;
  const std::vector<NewName> names = newNames(from, to, sources);
  std::optional<std::map<int, int>> films;
  for (const State::Impulse& impulse : old.impulses) {
    const int pair = FeatureKey::pairOf(impulse.key);
    if (pair == FeatureKey::kFilm) {
      if (!films) films = filmNames(from, to, sources);
      const auto found = films->find(FeatureKey::idA(impulse.key));
      if (found == films->end()) continue;
      carried.impulses.push_back({FeatureKey::make(FeatureKey::kFilm, FeatureKind::Vertex, found->second, FeatureKind::Face, 0),
                                  impulse.value, impulse.friction_W, impulse.normal_W});
    } else if (pair < static_cast<int>(names.size()) && names[pair].pair >= 0) {
      const bool swapped = names[pair].swapped;  // friction is what a feels
      carried.impulses.push_back({FeatureKey::renamed(impulse.key, names[pair].pair, swapped), impulse.value,
                                  swapped ? Vec3(-impulse.friction_W) : impulse.friction_W,
                                  swapped ? Vec3(-impulse.normal_W) : impulse.normal_W});
    }
  }
  std::sort(carried.impulses.begin(), carried.impulses.end(),
            [](const State::Impulse& a, const State::Impulse& b) { return a.key < b.key; });
}

}  // namespace

State carryState(const Model& from, const State& state, const Model& to) {
  State carried = to.start;
  carried.time = state.time;
  // A step ends at its number times Δt, so another Δt counts from another number.
  carried.step = from.scenario.dt == to.scenario.dt ? state.step : std::lround(state.time / to.scenario.dt);
  const std::vector<int> sources = sourcesOf(from, to), oldRotations = rotationOffsets(from), newRotations = rotationOffsets(to);
  for (std::size_t i = 0; i < to.objects.size(); ++i) {
    if (sources[i] < 0) continue;
    carryObject(from.objects[sources[i]], state, from.start, to.objects[i], carried);
    const int count = newRotations[i + 1] - newRotations[i], source = oldRotations[sources[i]];
    if (count > 0 && to.objects[i].layout.free) carried.rotations.segment(newRotations[i], count) = state.rotations.segment(source, count);
  }
  carryHands(from, state, to, carried);
  carryImpulses(from, state, to, sources, carried);
  return carried;
}

}  // namespace glenoid
