// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/ProximityFinder.h"

#include <algorithm>
#include <cassert>
#include <memory>

#include "simcore/base/ThreadClock.h"
#include "simcore/collide/FeatureKey.h"
#include "simcore/collide/MovingSurface.h"
#include "simcore/collide/PairSearch.h"

namespace glenoid {

struct ProximityFinder::Work {
  std::vector<std::shared_ptr<const CollisionSurface>> surfaces;
  std::vector<CollisionPair> pairs;
  ProximityLimits limits;
  std::vector<std::array<FeatureOwners, 2>> owners;  ///< by pair
  std::vector<std::unique_ptr<const SelfRest>> rests;  ///< by pair; null where it is of two surfaces
  std::vector<char> used;                            ///< surfaces that some pair names
  std::vector<MovingSurface> moving;
  PairSearch search;
  std::vector<Proximity> result;
  Counts counts;
};

ProximityFinder::ProximityFinder(std::vector<std::shared_ptr<const CollisionSurface>> surfaces,
                                 std::vector<CollisionPair> pairs, const ProximityLimits& limits)
    : m_work(std::make_unique<Work>(
          Work{std::move(surfaces), std::move(pairs), limits, {}, {}, {}, {}, PairSearch(limits), {}, {}})) {
  Work& w = *m_work;
  assert(static_cast<int>(w.pairs.size()) <= FeatureKey::kMaxPairs);
  w.used.assign(w.surfaces.size(), 0);
  for (const CollisionPair& pair : w.pairs) {
    w.used[pair.surfaceA] = w.used[pair.surfaceB] = 1;
    w.owners.push_back({assignOwners(*w.surfaces[pair.surfaceA], pair.skipTriangleA),
                        assignOwners(*w.surfaces[pair.surfaceB], pair.skipTriangleB)});
    w.rests.push_back(pair.self() ? std::make_unique<const SelfRest>(w.surfaces[pair.surfaceA], pair.cellOfVertex) : nullptr);
  }
  for (const auto& surface : w.surfaces) w.moving.emplace_back(surface);
  w.result.reserve(512);
}

ProximityFinder::~ProximityFinder() = default;
ProximityFinder::ProximityFinder(ProximityFinder&&) noexcept = default;
ProximityFinder& ProximityFinder::operator=(ProximityFinder&&) noexcept = default;

const std::vector<Proximity>& ProximityFinder::find(std::span<const std::span<const Vec3>> positions,
                                                    std::span<const std::span<const Vec3>> velocities,
                                                    double contactDistance, double dt, std::span<const LastNormal> last) {
  return findAlong(positions, std::span<const Motion>(&velocities, velocities.empty() ? 0 : 1), contactDistance, dt, last);
}

const std::vector<Proximity>& ProximityFinder::findAlong(std::span<const std::span<const Vec3>> positions,
                                                         std::span<const Motion> motions, double contactDistance,
                                                         double dt, std::span<const LastNormal> last) {
  Work& w = *m_work;
  assert(positions.size() == w.surfaces.size());
  assert(motions.size() <= kMotionsMost);
  const int motionCount = static_cast<int>(motions.size());
  w.result.clear();
  w.counts = {};
  for (std::size_t s = 0; s < w.moving.size(); ++s) {
    if (!w.used[s]) continue;
    std::array<std::span<const Vec3>, kMotionsMost> velocities;
    for (int m = 0; m < motionCount; ++m) velocities[m] = motions[m][s];
    w.moving[s].update(positions[s], {velocities.data(), motions.size()}, contactDistance, dt);
  }
  for (std::size_t p = 0; p < w.pairs.size(); ++p) {
    const CollisionPair& pair = w.pairs[p];
    const PairSearch::Settings settings{static_cast<int>(p), motionCount, contactDistance, dt, last};
    if (pair.self()) {
      const double begin = threadCpuMs();
      w.search.runSelf(settings, w.moving[pair.surfaceA], w.owners[p][0], *w.rests[p], w.result, w.counts);
      w.counts.selfMs += threadCpuMs() - begin;
    } else {
      w.search.run(settings, w.moving[pair.surfaceA], w.owners[p][0], w.moving[pair.surfaceB], w.owners[p][1], w.result, w.counts);
    }
  }
  std::sort(w.result.begin(), w.result.end(), [](const Proximity& a, const Proximity& b) {
    return a.key != b.key ? a.key < b.key : a.gap < b.gap;
  });
  // Two vertices nearest to each other are found from both sides.
  const auto end = std::unique(w.result.begin(), w.result.end(),
                               [](const Proximity& a, const Proximity& b) { return a.key == b.key; });
  w.result.erase(end, w.result.end());
  return w.result;
}

const std::vector<CollisionPair>& ProximityFinder::pairs() const {
  return m_work->pairs;
}
const std::vector<std::shared_ptr<const CollisionSurface>>& ProximityFinder::surfaces() const {
  return m_work->surfaces;
}
const ProximityFinder::Counts& ProximityFinder::counts() const {
  return m_work->counts;
}

}  // namespace glenoid
