// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glenoid {

/// How a .vtp file packs its arrays, from the attributes of its first tag.
struct VtpPacking {
  bool bigEndian = false;
  bool wideHeader = false;   ///< UInt64 instead of UInt32 before each array
  bool zlib = false;
  bool appendedBase64 = false;
  std::string_view appended;  ///< what follows the underscore; empty when there is none
};

/// One DataArray as the file describes it.
struct VtpArray {
  std::string type;    ///< "Float32", "Int64" …
  std::string format;  ///< "ascii", "binary", "appended"
  std::string_view text;
  unsigned long long offset = 0;
};

/// The numbers of an array, no more than `most`; nothing when they cannot be made out. Integers beyond 2^53 lose
/// digits, which no index reaches.
std::optional<std::vector<double>> vtpNumbers(const VtpArray& array, const VtpPacking& packing, std::size_t most);

}  // namespace glenoid
