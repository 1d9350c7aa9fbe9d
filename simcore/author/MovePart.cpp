// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MovePart.h"

#include <numbers>

#include "simcore/base/Turns.h"
#include "simcore/embed/Cells.h"

namespace glenoid {

PartMap partMap(const Part& part, const PartMove& move) {
  const Vec3 radians = move.turn_deg * (std::numbers::pi / 180);
  PartMap map;
  map.turn = (turnBy(radians.z() * Vec3::UnitZ()) * turnBy(radians.y() * Vec3::UnitY()) * turnBy(radians.x() * Vec3::UnitX())).toRotationMatrix();
  map.scale = move.scale;
  if (part.visual) map.about_W = boundsOf(*part.visual).center();
  map.shift_W = move.shift_W;
  map.onlyShifts = move.turn_deg.isZero(0) && move.scale == 1;
  return map;
}

Result<Part> movedPart(const Part& part, const PartMove& move) {
  if (!(move.scale > 0) || !std::isfinite(move.scale) || !move.turn_deg.allFinite() || !move.shift_W.allFinite())
    return Error{Fault::OutOfRange, {{}, {}, part.id, {}}, {std::to_string(move.scale), "0", "inf"}, "moving a part"};
  const PartMap map = partMap(part, move);
  const auto moved = [&](const Vec3& p) { return map.point(p); };
  const auto surface = [&](const TriMesh& mesh) {
    TriMesh out = mesh;
    for (Vec3& p : out.vertices) p = moved(p);
    return std::make_shared<const TriMesh>(std::move(out));
  };
  Part out = part;
  if (part.visual) out.visual = surface(*part.visual);
  if (part.collision) out.collision = part.collision == part.visual ? out.visual : surface(*part.collision);
  for (Landmark& landmark : out.landmarks) landmark.position_W = moved(landmark.position_W);
  out.dents = nullptr;
  if (!part.volume) return out;
  out.cellSize = move.scale * part.cellSize;
  if (part.elements == Elements::Cells) {
    auto cells = embedAlong(*out.visual, *out.collision, out.cellSize, GridAxes::World);
    if (!cells) {
      cells.error().place.part = part.id;
      return cells.error();
    }
    out.volume = std::make_shared<const TetMesh>(std::move(*cells));
    return out;
  }
  TetMesh volume = *part.volume;
  for (Vec3& node : volume.nodes) node = moved(node);
  out.volume = std::make_shared<const TetMesh>(std::move(volume));
  return out;
}

}  // namespace glenoid
