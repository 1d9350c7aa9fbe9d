// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/mesh/TetMesh.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// A place on a part's visual surface that a tip presses: the surface within `radius` of its middle that faces as the
/// middle does, under an even pressure along −normal.
struct TipPatch {
  Vec3 middle_W = Vec3::Zero(), normal_W = Vec3::UnitY();  ///< rest; the normal unit, outwards
  double radius = 0;                                       ///< m
  std::vector<Vec3> points_W;                              ///< samples of it
  std::vector<double> weights;                             ///< their shares of the force, sum 1
};

/// The patch round the surface point nearest to `near_W`. Its normal is that of the surface's mean over the patch.
TipPatch tipPatchAt(const TriMesh& surface, const Vec3& near_W, double radius);

/// Cells round a part that are `finest` within `core` of a place, grow with the distance by `growth` for each metre
/// and are `coarsest` far away; turned so that their third axis is the place's normal.
struct GradedCells {
  double finest = 0.5e-3, core = 2.5e-3, growth = 0.5, coarsest = 2e-3;  ///< m, m, 1, m
};
/// The tetrahedra of those cells that lie in the part, fitted to its visual surface. Fails as embedInCells does.
Result<TetMesh> embedGraded(const Part& part, const TipPatch& place, const GradedCells& cells);

/// The tetrahedra of `cells` that lie mostly inside a closed surface, their boundary moved onto it where they bear it:
/// what is filled is the body itself, no element by halves.
TetMesh fitToSurface(const TetMesh& cells, const TriMesh& surface);

/// Whether tetrahedra stand for the tissue in them (embedded cells, as a run has them) or are wholly tissue.
enum class TetFilling { Partial, Whole };

/// One soft part alone at rest as a linear elastic body: its materials, its couplings with their other ends fixed,
/// no gravity, no contact. It answers statically, by conjugate gradients behind an incomplete Cholesky factor, to a residual of 1e-3:
/// what is asked is an energy, so its error is of second order.
/// `mesh` stands in for the part's own tetrahedra, so the same question can be put to coarse and to fine ones.
/// Element: the stiffness of the running simulation (fem/CorotTet) at the rotation one. Frames: W at rest.
class StaticPart {
 public:
  /// Fails as deriveSprings and makeCorotTet do; Unusable where nothing holds the part.
  static Result<StaticPart> make(const Joint& joint, int part, std::shared_ptr<const TetMesh> mesh, TetFilling filling);
  ~StaticPart();
  StaticPart(StaticPart&&) noexcept;

  /// How far the patch gives along −normal for each newton on it: the mean of its displacement under its own
  /// pressure, m/N, > 0.
  double compliance(const TipPatch& patch) const;
  /// The same for patches round one place, less what the points of `back` move along the same way: how far the part is
  /// pressed together between the two, whatever it bends or moves as a whole. Without points as compliance(). Quicker than one by one, since what
  /// is far away answers alike.
  std::vector<double> compliances(std::span<const TipPatch> patches, const TipPatch& back) const;
  /// The same for a point that carries the whole force, such as a vertex of the collision surface.
  double compliance(const Vec3& point_W, const Vec3& normal_W) const;

 private:
  struct Inside;
  explicit StaticPart(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> m_inside;
};

}  // namespace glenoid
