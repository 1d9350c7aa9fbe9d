// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "simcore/body/SoftObject.h"
#include "simcore/embed/Cells.h"
#include "simcore/linear/BlockCholesky.h"
#include "simcore/scene/Scenario.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::truth {

/// A closed surface whose triangles carry a mark each, by which a problem says where it holds and pulls.
struct MarkedSurface {
  TriMesh mesh;
  std::vector<char> mark;
};

/// The body over a mapped quadrilateral (x, y)(s, t), s, t in [0, 1], from the first to the last of `levels`
/// (z, ascending). Marks: 'a' s = 0, 'b' s = 1, 'c' t = 0, 'd' t = 1, '-' below, '+' above; on 'd' between
/// levels `band` and band + 1: 'e'. The map must keep orientation.
MarkedSurface prism(const std::function<Vec2(double, double)>& map, int ns, int nt,
                    const std::vector<double>& levels, int band = -1);

/// A soft part alone as the simulation has it (embedded cells, fill, consistent mass), its stiffness at rest
/// as the step assembles it, for problems of linear elasticity with published answers. SI units or any other
/// consistent ones. Surfaces are held by stiff springs over their area, the way a scenario's supports are.
class EmbeddedBody {
 public:
  /// `axes`: of the grid; along a band cells have the size of cell.x (embedAlong).
  EmbeddedBody(MarkedSurface surface, const Vec3& cell, Elements elements, double young, double poisson,
               double density = 1, GridAxes axes = GridAxes::World);

  /// Nothing with one of these marks moves along an axis of W (0, 1, 2): springs of `stiff` E / cell for each
  /// area. Where such a face cuts through cells they must not be much stiffer than those: a field that is
  /// piecewise linear and zero on a face inside its elements has one slope there for all of them.
  void hold(std::string_view marks, int axis, double stiff = 1e5);
  /// As that, but towards a displacement of each place instead of none.
  void draw(std::string_view marks, int axis, double stiff,
            const std::function<double(const Vec3& x)>& towards);
  /// Traction (force for each area) on all triangles of a mark, of the place and its outward unit normal.
  void pull(char mark, const std::function<Vec3(const Vec3& x, const Vec3& normal)>& traction);
  void pull(char mark, const std::function<Vec3(const Vec3& normal)>& traction);

  /// Displacements under what was pulled.
  VecX solve() const;
  /// Displacements where every node that does not lie deeper than two cells in the body moves as `field` says
  /// of it: inside, a field that needs no body force is to come out again.
  VecX solveInside(const std::function<Vec3(const Vec3& x)>& field) const;
  /// The lowest natural frequencies, 1/s, ascending.
  std::vector<double> frequencies(int count, std::vector<VecX>* shapes = nullptr) const;
  /// Share of a shape's squares that points from the origin, over nodes more than a tenth of the body's reach
  /// away from it.
  double radialShare(const VecX& shape) const;

  /// The patch test: every node moves by x = F X. What is left of the forces on nodes that lie deeper than
  /// two cells in the body, over the largest force there is; and how far Σ f Xᵀ is from −V P, P the one
  /// stress that F asks for, over that. The larger of the two; zero but for round-off.
  double affineImbalance(const Mat3& F) const;

  Vec3 displacementAt(const VecX& u, const Vec3& x) const;
  std::vector<Vec3> displacementsAt(const VecX& u, std::span<const Vec3> places) const;
  /// Recovered as reading/StressRecovery.h says.
  Mat3 stressAt(const VecX& u, const Vec3& x) const;
  int nodes() const { return m_layout.nodeCount; }

 private:
  struct Spread {  ///< a place on the surface and its share of area
    Vec3 x;
    VertexBinding at;
    double area;
    Vec3 normal;
  };
  std::vector<Spread> spreadOver(std::string_view marks) const;
  BlockMatrix held() const;
  bool isDeep(const TriangleTree& surface, int node) const;

  MarkedSurface m_surface;
  double m_young, m_cell;
  Lame m_lame;
  std::shared_ptr<const TetMesh> m_mesh;
  ObjectLayout m_layout;
  std::unique_ptr<SoftObject> m_soft;
  State m_rest;
  std::shared_ptr<const BlockSymbolic> m_symbolic;
  std::vector<BlockEntry> m_entries;
  BlockMatrix assembled(double dt) const;  ///< M + Δt² K
  struct Held {
    Spread place;
    int axis;
    double stiff, towards;
  };
  std::vector<Held> m_held;
  VecX m_pull;
};

}  // namespace glenoid::truth
