// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "simcore/import/gltf/GltfFile.h"

namespace glenoid {

/// Where a glTF's nodes stand, and which of them are shown.
struct GltfNodes {
  std::vector<Eigen::Matrix4d> toRoot;  ///< by node
  std::vector<bool> shown;              ///< in the scene that is read: the named one or the first
  std::int64_t scene = -1;              ///< that scene; −1 where there is none
};

/// Fails with BadIndex, BadMesh (a transform that is none) and CyclicReference (argument: node).
Result<GltfNodes> placeNodes(const GltfFile& file, const std::string& path);

/// Where each point of a primitive stands, by the joints of a skin: Σ w · joint · inverse bind · point.
struct SkinnedPoints {
  Eigen::MatrixXd points;  ///< 3 × n, in the root's frame
  bool mirrored = false;   ///< most of them by a mirroring
};
/// Fails as GltfFile does, with BadIndex where a joint is none, and BadMesh where weights or joints are missing.
Result<SkinnedPoints> skinnedPoints(GltfFile& file, const GltfNodes& nodes, const JsonValue& skin, const JsonValue& attributes);

}  // namespace glenoid
