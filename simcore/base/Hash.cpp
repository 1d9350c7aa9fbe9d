// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/base/Hash.h"

#include <xxhash.h>

#include <cstdio>

namespace glenoid {

Hash128 hashBytes(const void* data, std::size_t size, std::uint64_t seed) {
  const XXH128_hash_t hash = XXH3_128bits_withSeed(data, size, seed);
  return {hash.high64, hash.low64};
}

std::string toHex(const Hash128& hash) {
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high),
                static_cast<unsigned long long>(hash.low));
  return text;
}

}  // namespace glenoid
