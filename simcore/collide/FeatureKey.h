// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cassert>
#include <cstdint>
#include <utility>

#include "simcore/collide/MovingSurface.h"

namespace glenoid {

/// Name of a constraint: pair (13 bits), kinds of both features (3 bits), their ids (24 bits each). The same
/// features of the same pair get the same key in every step; no two constraints of a step share one.
struct FeatureKey {
  static constexpr int kIdBits = 24, kKindBits = 3;
  static constexpr int kMaxPairs = (1 << (64 - 2 * kIdBits - kKindBits)) - 1;
  static constexpr int kFilm = kMaxPairs;  ///< in place of a pair: vertices that feel a film, after all pairs

  static std::uint64_t make(int pair, FeatureKind kindA, int idA, FeatureKind kindB, int idB) {
    assert(pair <= kFilm && idA < (1 << kIdBits) && idB < (1 << kIdBits));
    std::uint64_t key = static_cast<std::uint64_t>(pair);
    key = key << kKindBits | combination(kindA, kindB);
    key = key << kIdBits | static_cast<std::uint64_t>(idA);
    return key << kIdBits | static_cast<std::uint64_t>(idB);
  }

  /// The touch of a round tool, surface b of a pair, on what gives under it, surface a: after all features of the pair.
  static std::uint64_t makeTouch(int pair, int id) {
    assert(pair < kFilm && id < (1 << kIdBits));
    return ((static_cast<std::uint64_t>(pair) << kKindBits | kTouch) << kIdBits | static_cast<std::uint64_t>(id)) << kIdBits;
  }
  static bool isTouch(std::uint64_t key) { return (key >> 2 * kIdBits & ((1u << kKindBits) - 1)) == kTouch; }

  /// The pair in a key, and the feature of a.
  static int pairOf(std::uint64_t key) { return static_cast<int>(key >> (2 * kIdBits + kKindBits)); }
  static int idA(std::uint64_t key) { return static_cast<int>(key >> kIdBits & ((std::uint64_t{1} << kIdBits) - 1)); }
  /// The same features as those of another pair; `swapped`: its a is this key's b.
  static std::uint64_t renamed(std::uint64_t key, int pair, bool swapped) {
    constexpr std::uint64_t kIdMask = (std::uint64_t{1} << kIdBits) - 1;
    constexpr std::uint64_t kSwapped[] = {1, 0, 2, 4, 3, 5, 6, 7};
    std::uint64_t kinds = key >> 2 * kIdBits & ((1u << kKindBits) - 1), idA = key >> kIdBits & kIdMask, idB = key & kIdMask;
    if (swapped) {
      kinds = kSwapped[kinds];
      std::swap(idA, idB);
    }
    return ((static_cast<std::uint64_t>(pair) << kKindBits | kinds) << kIdBits | idA) << kIdBits | idB;
  }

 private:
  static constexpr std::uint64_t kTouch = 6;  ///< in place of a combination

  /// Only six of the nine combinations occur.
  static std::uint64_t combination(FeatureKind a, FeatureKind b) {
    if (a == FeatureKind::Vertex) return b == FeatureKind::Face ? 0 : (b == FeatureKind::Edge ? 3 : 5);
    if (a == FeatureKind::Face) return 1;
    return b == FeatureKind::Edge ? 2 : 4;
  }
};

}  // namespace glenoid
