// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MakeCollision.h"

#include "simcore/mesh/Simplify.h"
#include "simcore/repair/Untangled.h"

namespace glenoid {

Result<TriMesh> makeCollision(const TriMesh& visual, int triangles) {
  auto simple = simplify(visual, triangles);
  if (!simple) return simple;
  return untangled(std::move(*simple));
}

}  // namespace glenoid
