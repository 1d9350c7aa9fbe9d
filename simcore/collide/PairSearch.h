// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/collide/FeatureOwners.h"
#include "simcore/collide/MovingSurface.h"
#include "simcore/collide/NormalCone.h"
#include "simcore/collide/ProximityFinder.h"
#include "simcore/collide/SelfFacing.h"
#include "simcore/collide/SelfRest.h"

namespace glenoid {

/// The search of one pair of surfaces, see README.md. Scratch is shared by all pairs of a finder; the result
/// is appended to. Used by ProximityFinder only.
class PairSearch {
 public:
  explicit PairSearch(const ProximityLimits& limits) : m_limits(limits) {}

  struct Settings {
    int pair = 0, motionCount = 0;
    double contactDistance = 0, dt = 0;
    std::span<const LastNormal> last;
  };
  void run(const Settings& settings, MovingSurface& a, const FeatureOwners& ownersA, MovingSurface& b,
           const FeatureOwners& ownersB, std::vector<Proximity>& out, ProximityFinder::Counts& counts);
  /// The same of a surface with itself. A vertex is always on the first side, the lower of two vertices or edges too.
  void runSelf(const Settings& settings, MovingSurface& surface, const FeatureOwners& owners, const SelfRest& rest,
               std::vector<Proximity>& out, ProximityFinder::Counts& counts);

 private:
  /// Sine of the angle by which a contact's normal may leave the cones of its features: bumps, and the facets that a
  /// curved surface is made of.
  static constexpr double kWidened = 0.03;
  /// The same where surfaces overlap, of both cones together: what is more is no way out.
  static constexpr double kOverlapped = 0.5;
  /// Share of the contact distance below which two points touch: the direction between them says nothing any more.
  static constexpr double kTouching = 1e-4;
  /// Share of the contact distance within which features count as just meeting: edges that overlap so little need no proof
  /// that they do, and a vertex so near a convex edge, but beside it, may rest on the edge.
  static constexpr double kShallow = 1e-2;

  /// A vertex that lies in the other surface.
  struct Inside {
    int vertex = -1;
    Vec3 outward = Vec3::Zero();  ///< its way out, unit
    Vec3 area_W = Vec3::Zero();   ///< a third of the triangles around it, along their normals, m²
    double area = 0;
    bool glued = false;           ///< nearest to what takes no part
  };
  /// Vertices of both surfaces that lie in each other in one place.
  struct Overlap {
    Vec3 way = Vec3::Zero();      ///< of the first surface out of the second, unit where `deep`
    double area = 0, astray = 0;  ///< m²; of it what would leave another way
    double across = 0, volume = 0;  ///< area seen along the way, m², and that times the way out, m³
    bool glued = false, deep = false;
  };
  /// A row of a deep overlap.
  struct Leaving {
    int root = 0;                 ///< its overlap
    std::array<long, 2> bin{};    ///< its place across the way
    Vec3 p_W = Vec3::Zero();
    Proximity row;
  };

  /// One of the two surfaces, with marks for each of its vertices; a mark holds while it equals m_mark.
  struct Side {
    MovingSurface* surface = nullptr;
    const FeatureOwners* owners = nullptr;
    std::vector<long> chainMark, queueMark;
    std::vector<int> chain;  ///< first result of this vertex; results of a vertex are linked by m_next
    std::vector<int> queue;  ///< vertices that may be inside the other surface
    std::vector<double> queueWithin;  ///< and no further from it than this, by vertex
    std::vector<Inside> inside;  ///< those that are
    std::vector<long> insideMark;
    std::vector<int> insideAt;   ///< in `inside`
    std::vector<long> meetingMark;
    std::vector<int> meetingAt;  ///< of a triangle that meets the other surface: its place in m_overlapOf
  };

  void prepare(Side& side, MovingSurface& surface, const FeatureOwners& owners);
  BoxTree::Sweep sweepOf(const MovingSurface& a, const MovingSurface& b);
  void trianglePair(int ta, int tb);
  bool liesIn(const MovingSurface& surface, const std::array<int, 3>& corners, const MovingSurface& plane, int t) const;

  // PairVertices.cpp
  void vertexNearTriangle(Side& mine, Side& other, int vertex, int triangle);
  void vertexTouches(Side& mine, Side& other, int vertex, int triangle, const Vec3& barycentric,
                     const MovingSurface::Feature& feature, const Vec3& apart);
  void acrossValleys(Side& mine, Side& other, int vertex, int triangle);
  void emitPlane(Side& mine, Side& other, int vertex, int triangle, double sine);
  bool nearestLocally(const Side& side, const MovingSurface::Feature& feature, const Vec3& foot,
                      const Vec3& away) const;
  /// Whether the vertex is a nearest point of its own surface to what it meets along the unit vector `outward` from it
  /// (the normal of the other's triangle): −outward lies in its normal cone, now or as it will have turned by the end of
  /// the step.
  bool facesItself(Side& mine, Side& other, int vertex, int triangle, const Vec3& outward);
  void emitVertex(Side& mine, Side& other, int vertex, int triangle, const Vec3& barycentric,
                  const MovingSurface::Feature& feature, const Vec3& outward, double gap);
  /// Whether the vertex is the contact's a. Of two of one surface the lower one is.
  bool isFirst(const Side& mine, int vertex, const MovingSurface::Feature& feature) const {
    return m_self ? feature.kind != FeatureKind::Vertex || vertex < feature.id : &mine == &m_a;
  }
  std::uint64_t vertexKey(const Side& mine, int vertex, const MovingSurface::Feature& feature) const;
  const Vec3* lastNormal(std::uint64_t key) const;

  // PairInside.cpp
  static constexpr double kAnyDistance = 1e300;
  /// `within`: a bound on its distance to the other surface, m.
  void suspect(Side& mine, int vertex, double within = kAnyDistance);
  void followInside(Side& mine, Side& other);
  void takeCone(Side& mine, int vertex);
  bool leavesCone(const Vec3& outward) const;

  // PairDeep.cpp
  /// A vertex that is inside; not of a surface with itself.
  void keepInside(Side& mine, int vertex, const Vec3& outward, bool glued);
  /// Its place among those of both surfaces.
  int insidePlace(const Side& side, int vertex) const { return (&side == &m_a ? 0 : static_cast<int>(m_a.inside.size())) + side.insideAt[vertex]; }
  int overlapOf(int i);
  void joinOverlaps();
  bool judgeOverlaps();
  bool measureOverlaps(double least);
  void binRows(double width);
  /// Replaces the rows of overlaps that are too deep for nearest ways, in results from `first` on.
  void partDeepOverlaps(std::size_t first);

  // PairSelf.cpp
  /// Whether a vertex that lies `depth` behind a triangle has come there from outside; always of another surface.
  bool mayBeInside(int vertex, int triangle, double depth) const;
  /// Below which gap they make a contact while nothing moves, m.
  double distanceOf(int vertex, int triangle) const;
  /// Whether a second layer of the body covers a place just in front of a point of the surface, `outward` being the way out
  /// of the body there: the surface goes round it. Tissue that is merely pressed thin, or turned inside out, is covered by none.
  bool covered(const Vec3& p, const Vec3& outward) const;
  bool covered(int vertex) { return covered(m_a.surface->x(vertex), m_a.surface->vertexNormal(vertex).stableNormalized()); }
  MovingSurface::Nearest nearestTo(Side& other, int vertex, const Vec3& p, double reach);
  bool sameCell(const FeaturePoint& a, const FeaturePoint& b) const { return m_self && m_self->sameCell(a, b); }

  // PairEdges.cpp
  double riseBeyond(const Side& side, int e, int end, const Vec3& n) const;
  void edgeNearEdge(int ea, int eb);
  bool facesAlong(const Side& side, int e, const Vec3& n) const;
  /// Whether point t of an edge of the other surface lies so deep in this one.
  bool inDepth(Side& side, int edge, double t, const Vec3& p, double depth);

  /// Whether points a of `first` and b of `second`, gap apart along the normal, come nearer than `distance` in one of the
  /// motions.
  bool near(double distance, double gap, const Vec3& normal, const MovingSurface& first, const FeaturePoint& a, const MovingSurface& second,
            const FeaturePoint& b) const;

  ProximityLimits m_limits;
  Settings m_settings;
  double m_touching = 0, m_shallow = 0, m_ahead = 0, m_edgeDepth = 0, m_swept = 0;  ///< of this pair, m
  Side m_a, m_b;
  NormalCone m_cone, m_against;
  const SelfRest* m_self = nullptr;  ///< of a surface with itself; null: two surfaces
  SelfFacing m_facing;
  Vec3 m_coneNormal = Vec3::Zero();                  ///< of the vertex whose way out is looked for
  std::vector<std::pair<Vec3, double>> m_coneWays;   ///< to its neighbours, and how far
  std::vector<int> m_next;
  std::vector<std::array<int, 2>> m_meeting;  ///< triangles of both surfaces that intersect
  std::vector<int> m_overlapOf;               ///< a forest of unions (joinOverlaps)
  std::vector<Overlap> m_overlaps;            ///< by root
  std::vector<Leaving> m_leaving;
  long m_mark = 0;
  std::vector<Proximity>* m_out = nullptr;
  ProximityFinder::Counts* m_counts = nullptr;
};

}  // namespace glenoid
