// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/Inflate.h"

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "simcore/file/ByteReader.h"

namespace glenoid {
namespace {

/// Little endian number of two or four bytes at a place; nothing beyond the end.
template <class T>
std::optional<T> numberAt(std::string_view bytes, std::size_t at) {
  if (at > bytes.size()) return std::nullopt;
  return ByteReader(bytes.substr(at)).take<T>(std::endian::little);
}

bool sameName(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

}  // namespace

std::optional<std::string> inflated(std::string_view packed, std::size_t limit, bool raw) {
  if (packed.size() > std::numeric_limits<uInt>::max()) return std::nullopt;
  z_stream stream{};
  if (inflateInit2(&stream, raw ? -MAX_WBITS : MAX_WBITS) != Z_OK) return std::nullopt;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string out;
  int state = Z_OK;
  // Grown as the bytes come, so that a lie about the size costs nothing.
  while (state == Z_OK) {
    const std::size_t have = out.size(), more = std::min<std::size_t>(std::max<std::size_t>(have, 1u << 16), 1u << 26);
    out.resize(have + more);
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + have);
    stream.avail_out = static_cast<uInt>(more);
    state = ::inflate(&stream, Z_NO_FLUSH);
    out.resize(have + more - stream.avail_out);
    if (out.size() > limit) state = Z_BUF_ERROR;
    if (state == Z_OK && stream.avail_in == 0 && stream.avail_out > 0) state = Z_BUF_ERROR;
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END) return std::nullopt;
  return out;
}

std::optional<std::string> zipMember(std::string_view zip, std::string_view name, std::size_t limit) {
  constexpr std::uint32_t kEnd = 0x06054b50, kEntry = 0x02014b50, kLocal = 0x04034b50;
  if (zip.size() < 22) return std::nullopt;
  // The end record is followed by a comment of at most 65535 bytes.
  std::size_t end = zip.size() - 22;
  for (const std::size_t lowest = end > 65535 ? end - 65535 : 0; numberAt<std::uint32_t>(zip, end) != kEnd; --end)
    if (end == lowest) return std::nullopt;
  const std::size_t entries = *numberAt<std::uint16_t>(zip, end + 10);
  std::size_t at = *numberAt<std::uint32_t>(zip, end + 16);
  for (std::size_t i = 0; i < entries; ++i) {
    const auto fixed = at <= zip.size() ? zip.substr(at) : std::string_view();
    if (fixed.size() < 46 || numberAt<std::uint32_t>(fixed, 0) != kEntry) return std::nullopt;
    const std::size_t nameSize = *numberAt<std::uint16_t>(fixed, 28);
    const std::size_t rest = *numberAt<std::uint16_t>(fixed, 30) + *numberAt<std::uint16_t>(fixed, 32);
    if (fixed.size() < 46 + nameSize) return std::nullopt;
    if (!sameName(fixed.substr(46, nameSize), name)) {
      at += 46 + nameSize + rest;
      continue;
    }
    const auto flags = *numberAt<std::uint16_t>(fixed, 8), method = *numberAt<std::uint16_t>(fixed, 10);
    const std::size_t packed = *numberAt<std::uint32_t>(fixed, 20), local = *numberAt<std::uint32_t>(fixed, 42);
    const auto from = local <= zip.size() ? zip.substr(local) : std::string_view();
    if ((flags & 1) || from.size() < 30 || numberAt<std::uint32_t>(from, 0) != kLocal) return std::nullopt;
    const std::size_t data = 30 + *numberAt<std::uint16_t>(from, 26) + *numberAt<std::uint16_t>(from, 28);
    if (data > from.size() || packed > from.size() - data) return std::nullopt;
    const std::string_view bytes = from.substr(data, packed);
    if (method == 0) return bytes.size() <= limit ? std::optional(std::string(bytes)) : std::nullopt;
    if (method == 8) return inflated(bytes, limit, true);
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace glenoid
