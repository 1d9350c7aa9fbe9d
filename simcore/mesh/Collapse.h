// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <queue>
#include <vector>

#include "simcore/mesh/TriMesh.h"
#include "simcore/mesh/TriangleOverlap.h"

namespace glenoid {

/// Σ of squared distances to weighted planes or points: error(x) = xᵀ A x − 2 bᵀ x + c.
struct Quadric {
  Mat3 A = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  double c = 0;
  void addPlane(const Vec3& normal, const Vec3& point, double weight);
  void addPoint(const Vec3& point, double weight);
  Quadric& operator+=(const Quadric& o);
  double error(const Vec3& x) const { return x.dot(A * x) - 2 * b.dot(x) + c; }
};

/// What a collapse must keep. Topology is always kept.
struct CollapseRules {
  double minTurn = 0.2;         ///< cosine by which a triangle's normal may turn at most
  double minShape = 0.15;       ///< 4√3·area/Σl² of new triangles, unless it was worse before
  double minDihedral = -0.6;    ///< cosine between neighbouring normals, unless it was worse before
  double maxVolumeLoss = 0.05;  ///< of the whole volume, lost or gained over all collapses
  bool allowCuts = false;       ///< new triangles may cut the rest of the surface
};

/// Edge collapse on a closed manifold, internal to simplify(). Works on a copy scaled to a unit diagonal.
/// The new vertex has the least error among the points that leave the enclosed volume as it was.
/// Source of that constraint: Lindstrom and Turk, "Fast and Memory Efficient Polygonal Simplification", 1998.
class Collapser {
 public:
  /// `importance`: factor of the cost of moving each vertex, or empty.
  explicit Collapser(const TriMesh& mesh, const std::vector<double>& importance = {});
  int triangles() const { return m_alive; }
  /// Collapses until at most `target` + 1 triangles are left or no edge is allowed under these rules.
  void run(int target, const CollapseRules& rules);
  /// What is left, in the scale of the input; vertices and triangles in their first order.
  TriMesh result() const;

 private:
  struct Candidate {
    double cost;
    int u, v;
    int stampU, stampV;
    int rank;  ///< how many better places were refused
    Vec3 at;
    double gain;  ///< six times the change of volume
    bool operator>(const Candidate& o) const {
      if (cost != o.cost) return cost > o.cost;
      return u != o.u ? u > o.u : v > o.v;
    }
  };
  using Queue = std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>>;

  Candidate candidate(int u, int v, int rank) const;
  void push(int u, int v, int rank = 0);
  bool topologyAllows(int u, int v) const;
  bool shapeAllows(const Candidate& candidate, const CollapseRules& rules) const;
  bool cutsSurface(const std::vector<int>& star, int u, int v, const Vec3& at) const;
  void collapse(const Candidate& candidate);
  std::vector<int> neighbours(int v) const;
  Triangle3 corners(int triangle) const;
  Triangle3 cornersAfter(int triangle, int u, int v, const Vec3& at) const;

  Vec3 m_centre = Vec3::Zero();
  double m_scale = 1;
  std::vector<Vec3> m_points;
  std::vector<std::array<int, 3>> m_triangles;
  std::vector<char> m_dead;                 ///< triangles
  std::vector<std::vector<int>> m_fans;     ///< live triangles of each vertex, ascending
  std::vector<double> m_importance;         ///< of each vertex; of a merged one the greater
  std::vector<int> m_stamps;                ///< raised when a vertex moves, so that older candidates lapse
  std::vector<Quadric> m_planes, m_spread;  ///< the surface that a vertex stands for: its planes, its points
  std::vector<int> m_liveList;              ///< triangles, some dead; swept when half are
  int m_alive = 0;
  double m_wanted = 0, m_gained = 0;  ///< six times the volume at the start, and its change since
  Queue m_queue;
};

}  // namespace glenoid
