// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "simcore/base/Error.h"

namespace glenoid {

/// How glTF's extension EXT_meshopt_compression describes a packed run of bytes.
struct MeshoptStream {
  std::string mode;    ///< "ATTRIBUTES", "TRIANGLES" or "INDICES"
  std::string filter;  ///< "NONE", "OCTAHEDRAL", "QUATERNION" or "EXPONENTIAL"
  long long count = 0, stride = 0;
};

/// The `count` × `stride` bytes that were packed, by the decoder of the meshoptimizer library, filter undone.
/// Fails with BadMesh (argument: what is wrong with it, a newer stream than the library knows among that) and FileTooLarge.
/// Source: Khronos, EXT_meshopt_compression.
Result<std::string> unpackMeshopt(std::string_view packed, const MeshoptStream& stream);

}  // namespace glenoid
