// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace glenoid {

/// 128-bit XXH3 content hash, for naming blobs and comparing states; not a protection against forgery.
/// Source: xxHash, Yann Collet. Bytes are hashed as they lie in memory: little endian only.
struct Hash128 {
  std::uint64_t high = 0, low = 0;
  bool operator==(const Hash128&) const = default;
};

Hash128 hashBytes(const void* data, std::size_t size, std::uint64_t seed = 0);

inline Hash128 hashDoubles(std::span<const double> values, std::uint64_t seed = 0) {
  return hashBytes(values.data(), values.size_bytes(), seed);
}

/// 32 lower-case hexadecimal digits.
std::string toHex(const Hash128& hash);

}  // namespace glenoid
