// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/MeshoptStream.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstdint>

namespace glenoid {
namespace {

Error bad(const std::string& what) { return {Fault::BadMesh, {}, {"its packed data (EXT_meshopt_compression) " + what}, "meshoptimizer"}; }

/// The first byte of a stream: its kind in the upper half, its version in the lower.
struct Kind {
  unsigned header;
  unsigned newest;  ///< that meshoptimizer 0.18 reads
};

}  // namespace

Result<std::string> unpackMeshopt(std::string_view packed, const MeshoptStream& stream) {
  const bool attributes = stream.mode == "ATTRIBUTES", triangles = stream.mode == "TRIANGLES", indices = stream.mode == "INDICES";
  if (!attributes && !triangles && !indices) return bad("are of a kind that is not known (" + stream.mode.substr(0, 40) + ")");
  const bool goodStride = attributes ? stream.stride > 0 && stream.stride <= 256 && stream.stride % 4 == 0 : stream.stride == 2 || stream.stride == 4;
  if (!goodStride || stream.count < 0 || (triangles && stream.count % 3 != 0)) return bad("have a size that their kind cannot have");
  constexpr long long kMost = 1ll << 31;
  if (stream.count > kMost / stream.stride) return Error{Fault::FileTooLarge, {}, {std::to_string(stream.count) + " packed values", std::to_string(kMost / stream.stride)}, "meshoptimizer"};
  const Kind kind = attributes ? Kind{0xa0, 0} : triangles ? Kind{0xe0, 1} : Kind{0xd0, 1};
  if (packed.empty()) return bad("are empty");
  const unsigned first = static_cast<unsigned char>(packed[0]);
  if ((first & 0xf0u) == kind.header && (first & 0x0fu) > kind.newest)
    return bad("are of version " + std::to_string(first & 0x0fu) + ", newer than what is read here: write the file without compression, or with an older version of it");
  const auto count = static_cast<std::size_t>(stream.count), stride = static_cast<std::size_t>(stream.stride);
  std::string out(count * stride, '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
  const int failed = attributes  ? meshopt_decodeVertexBuffer(out.data(), count, stride, from, packed.size())
                     : triangles ? meshopt_decodeIndexBuffer(out.data(), count, stride, from, packed.size())
                                 : meshopt_decodeIndexSequence(out.data(), count, stride, from, packed.size());
  if (failed != 0) return bad("are damaged");
  if (stream.filter.empty() || stream.filter == "NONE") return out;
  if (!attributes) return bad("have a filter where none can be");
  if (stream.filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) meshopt_decodeFilterOct(out.data(), count, stride);
  else if (stream.filter == "QUATERNION" && stride == 8) meshopt_decodeFilterQuat(out.data(), count, stride);
  else if (stream.filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), count, stride);
  else return bad("have a filter that is not known (" + stream.filter.substr(0, 40) + ")");
  return out;
}

}  // namespace glenoid
