// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/vtk/Inflate.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace glenoid {

std::optional<std::string> inflated(std::string_view packed, std::size_t limit) {
  if (packed.size() > std::numeric_limits<uInt>::max()) return std::nullopt;
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return std::nullopt;
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

}  // namespace glenoid
