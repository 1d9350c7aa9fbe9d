// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "simcore/collide/CollisionSurface.h"

namespace glenoid {

/// The two sides of a thin film, as pieces of collision surfaces: it is felt at the floor's vertices and rests
/// against the roof's triangles.
struct FilmSides {
  struct Vertex {
    int surface = 0, vertex = 0;
  };
  struct Triangle {
    int surface = 0, triangle = 0;
  };
  std::vector<Vertex> floor;
  std::vector<Triangle> roof;
};

/// A vertex of the floor that feels the roof. In `near`: a on the floor, b on the roof, the normal from roof to
/// floor, `pair` without meaning.
struct FilmTouch {
  Proximity near;
  int floor = 0;        ///< in FilmSides::floor
  int roofSurface = 0;
  double area = 0;      ///< of the floor around the vertex as the roof sees it, m²
};

/// Finds where the two sides of a film are near each other: of each floor vertex the nearest point of the roof, if
/// that faces it. Stateless between calls except for scratch.
/// Frames: W. Units: m. Answers ascend by floor vertex and so by key. One thread at a time. Positions that are not
/// finite give no touch.
class FilmSearch {
 public:
  /// Deeper in the roof than this a vertex feels nothing any more, m.
  static constexpr double kDepth = 4e-3;
  /// A film is looked for somewhat farther than it is thick, so that what closes in is felt in time; by this factor.
  static constexpr double kMargin = 1.5;

  /// Keys count on from `firstKey` by floor vertex; those of several films must not overlap. Surfaces are the ones
  /// that positions will be given for.
  FilmSearch(FilmSides sides, std::vector<std::shared_ptr<const CollisionSurface>> surfaces, double thickness, int firstKey);

  /// positions[s]: one for each vertex of surface s. Valid until the next call.
  const std::vector<FilmTouch>& find(std::span<const std::span<const Vec3>> positions);

 private:
  bool touch(std::span<const std::span<const Vec3>> positions, int floor, FilmTouch& touch) const;

  FilmSides m_sides;
  std::vector<std::shared_ptr<const CollisionSurface>> m_surfaces;
  double m_thickness;
  int m_firstKey;
  Box3 m_all;
  std::vector<Box3> m_boxes;  ///< of the roof's triangles, with the reach around them
  std::vector<FilmTouch> m_result;
};

}  // namespace glenoid
