// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/collide/SlowProximity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace glenoid {
namespace {

using Name = std::vector<int>;

struct Mesh {
  const TriMesh& mesh;
  std::map<std::array<int, 2>, std::vector<int>> edges;  ///< → triangles
  std::vector<std::set<int>> neighbours;                 ///< vertex → vertices

  explicit Mesh(const TriMesh& m) : mesh(m), neighbours(m.vertices.size()) {
    for (int t = 0; t < static_cast<int>(m.triangles.size()); ++t) {
      for (int k = 0; k < 3; ++k) {
        const int i = m.triangles[t][k], j = m.triangles[t][(k + 1) % 3];
        edges[{std::min(i, j), std::max(i, j)}].push_back(t);
        neighbours[i].insert(j);
        neighbours[j].insert(i);
      }
    }
  }
  const Vec3& x(int v) const { return mesh.vertices[v]; }
  Vec3 normal(int t) const {
    const auto& c = mesh.triangles[t];
    return (x(c[1]) - x(c[0])).cross(x(c[2]) - x(c[0])).normalized();
  }
  int opposite(int t, const std::array<int, 2>& edge) const {
    for (const int v : mesh.triangles[t]) {
      if (v != edge[0] && v != edge[1]) return v;
    }
    return -1;
  }
  Vec3 vertexNormal(int v) const {
    Vec3 n = Vec3::Zero();
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      const auto& c = mesh.triangles[t];
      for (int k = 0; k < 3; ++k) {
        if (c[k] != v) continue;
        const Vec3 p = (x(c[(k + 1) % 3]) - x(v)).normalized(), q = (x(c[(k + 2) % 3]) - x(v)).normalized();
        n += std::acos(std::clamp(p.dot(q), -1.0, 1.0)) * normal(t);
      }
    }
    return n.normalized();
  }
  bool inside(const Vec3& p) const {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
      const Vec3 u = x(t[0]) - p, v = x(t[1]) - p, w = x(t[2]) - p;
      const double lu = u.norm(), lv = v.norm(), lw = w.norm();
      sum += 2 * std::atan2(u.dot(v.cross(w)), lu * lv * lw + u.dot(v) * lw + v.dot(w) * lu + w.dot(u) * lv);
    }
    return sum > 2 * std::numbers::pi;
  }

  /// Twice the volume over the area, or the shortest side of the box.
  double thickness() const {
    double volume = 0, area = 0;
    for (const auto& t : mesh.triangles) {
      volume += x(t[0]).dot(x(t[1]).cross(x(t[2]))) / 6;
      area += (x(t[1]) - x(t[0])).cross(x(t[2]) - x(t[0])).norm() / 2;
    }
    return std::min(2 * volume / area, boundsOf(mesh).sizes().minCoeff());
  }
  /// Sine of the angle by which −outward leaves the normal cone of vertex v.
  double leavesCone(int v, const Vec3& outward) const {
    double most = outward.dot(vertexNormal(v));
    for (const int y : neighbours[v]) most = std::max(most, -outward.dot((x(y) - x(v)).normalized()));
    return most;
  }

  /// Sine of the steepest edge that leaves a vertex forwards and over the plane with the normal n; 0: none does.
  double dips(int vertex, const Vec3& forwards, const Vec3& n) const {
    double most = 0;
    for (const auto& [edge, triangles] : edges) {
      if (edge[0] != vertex && edge[1] != vertex) continue;
      const Vec3 way = (x(edge[0] == vertex ? edge[1] : edge[0]) - x(vertex)).normalized();
      if (way.dot(forwards) > 0 && way.dot(n) > 0.03) most = std::max(most, way.dot(n));
    }
    return most;
  }
  /// The two faces rise from the edge toward each other.
  bool valley(const std::array<int, 2>& edge) const {
    const std::vector<int>& t = edges.at(edge);
    const Vec3 away = x(opposite(t[1], edge)) - x(edge[0]);
    return normal(t[0]).dot(away) > 1e-3 * away.norm();
  }
  /// By the face's inside and its three sides.
  double distanceTo(int t, const Vec3& p) const {
    const auto& c = mesh.triangles[t];
    const Vec3 n = normal(t), q = p - n * n.dot(p - x(c[0]));
    bool within = true;
    double nearest = 1e30;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &from = x(c[k]), d = x(c[(k + 1) % 3]) - from;
      within &= n.dot(d.cross(q - from)) > 0;
      const double s = std::clamp(d.dot(p - from) / d.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (from + s * d - p).norm());
    }
    return within ? (q - p).norm() : nearest;
  }

  struct Foot {
    Name feature;  ///< ascending vertices
    Vec3 point, outward;
  };
  /// Feet of p on every feature beside which nothing is nearer; outward is that of a point outside.
  std::vector<Foot> feet(const Vec3& p) const {
    std::vector<Foot> result;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      const auto& c = mesh.triangles[t];
      const Vec3 n = normal(t), q = p - n * n.dot(p - x(c[0]));
      bool within = true;
      for (int k = 0; k < 3; ++k) within &= n.dot((x(c[(k + 1) % 3]) - x(c[k])).cross(q - x(c[k]))) > 0;
      Name name(c.begin(), c.end());
      std::sort(name.begin(), name.end());
      if (within) result.push_back({name, q, n});
    }
    for (const auto& [edge, triangles] : edges) {
      const Vec3 d = x(edge[1]) - x(edge[0]);
      const double s = d.dot(p - x(edge[0])) / d.squaredNorm();
      const Vec3 q = x(edge[0]) + s * d;
      bool nearest = s > 0 && s < 1;
      for (const int t : triangles) nearest &= (p - q).dot(x(opposite(t, edge)) - q) <= 0;
      if (nearest) result.push_back({{edge[0], edge[1]}, q, (p - q).normalized()});
    }
    for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
      bool nearest = true;
      for (const int w : neighbours[v]) nearest &= (p - x(v)).dot(x(w) - x(v)) <= 0;
      if (nearest) result.push_back({{v}, x(v), (p - x(v)).normalized()});
    }
    return result;
  }
  Foot nearestFoot(const Vec3& p) const {
    const auto all = feet(p);
    return *std::min_element(all.begin(), all.end(), [&](const Foot& f, const Foot& g) {
      return (f.point - p).norm() < (g.point - p).norm();
    });
  }
};

Name join(const Name& a, const Name& b) {
  Name name = a;
  name.push_back(-1);
  name.insert(name.end(), b.begin(), b.end());
  return name;
}

}  // namespace

Name featureName(const Proximity& contact) {
  const auto sorted = [](const FeaturePoint& point) {
    Name name(point.vertex.begin(), point.vertex.begin() + point.count);
    std::sort(name.begin(), name.end());
    return name;
  };
  return join(sorted(contact.a), sorted(contact.b));
}

std::map<Name, SlowContact> slowProximities(const TriMesh& meshA, const TriMesh& meshB,
                                            double contactDistance, const ProximityLimits& limits,
                                            const std::vector<bool>& deforms) {
  std::map<Name, SlowContact> found;
  const Mesh a(meshA), b(meshB);
  const double edgeDepth = limits.edgeDepth * std::min(a.thickness(), b.thickness());
  const auto vertices = [&](const Mesh& mine, const Mesh& other, bool first) {
    const double depthMost = limits.depth * other.thickness();
    const auto put = [&](int v, const Name& feature, const Vec3& outward, double gap) {
      found[first ? join({v}, feature) : join(feature, {v})] = {gap, first ? outward : Vec3(-outward)};
    };
    // The plane of a face on the other side of a valley, if sliding by the contact distance could reach it.
    const auto addPlane = [&](int v, int t, double sine) {
      const auto& c = other.mesh.triangles[t];
      const Vec3 &p = mine.x(v), n = other.normal(t);
      const double gap = n.dot(p - other.x(c[0]));
      const double beside = other.distanceTo(t, p), along = std::sqrt(std::max(0.0, beside * beside - gap * gap));
      if (gap > contactDistance * sine || along > contactDistance || gap < -depthMost) return;
      if (mine.leavesCone(v, n) > 0.03) return;
      Name name(c.begin(), c.end());
      std::sort(name.begin(), name.end());
      put(v, name, n, gap);
    };
    const auto add = [&](int v, const Mesh::Foot& foot, const Vec3& outward, double gap) {
      if (foot.feature.size() == 2 && other.valley({foot.feature[0], foot.feature[1]})) {
        for (const int t : other.edges.at({foot.feature[0], foot.feature[1]})) addPlane(v, t, 1);
        return;
      }
      put(v, foot.feature, outward, gap);
      if (foot.feature.size() < 3) return;
      for (const auto& edge : {std::array{foot.feature[0], foot.feature[1]}, std::array{foot.feature[1], foot.feature[2]},
                               std::array{foot.feature[0], foot.feature[2]}}) {
        if (!other.valley(edge)) continue;
        const std::vector<int>& both = other.edges.at(edge);
        const double sine = other.normal(both[0]).cross(other.normal(both[1])).norm();
        for (const int t : both)
          if (other.opposite(t, edge) != foot.feature[0] && other.opposite(t, edge) != foot.feature[1] &&
              other.opposite(t, edge) != foot.feature[2])
            addPlane(v, t, sine);
      }
    };
    for (int v = 0; v < static_cast<int>(mine.mesh.vertices.size()); ++v) {
      const Vec3& p = mine.x(v);
      const bool inside = other.inside(p);
      if (inside) {
        Mesh::Foot foot = other.nearestFoot(p);
        double depth = (foot.point - p).norm();
        Vec3 outward = foot.feature.size() == 3 ? foot.outward : Vec3((foot.point - p) / depth);
        if (depth < depthMost && mine.leavesCone(v, outward) > 0.5) {
          // Out through the nearest face that its own surface looks at, if there is one.
          double nearest = std::min(depthMost, std::max(3 * depth, contactDistance));
          for (const Mesh::Foot& way : other.feet(p)) {
            const double far = (way.point - p).norm();
            if (way.feature.size() < 3 || way.outward.dot(way.point - p) < 0 || far >= nearest) continue;
            if (mine.leavesCone(v, way.outward) > 0.5) continue;
            nearest = depth = far;
            foot = way;
            outward = way.outward;
          }
        }
        if (depth < depthMost) add(v, foot, outward, -depth);
      }
      for (const Mesh::Foot& foot : other.feet(p)) {
        const double gap = (p - foot.point).norm();
        if (foot.outward.dot(p - foot.point) < 0 || gap >= contactDistance) continue;
        if (foot.feature.size() < 3 && inside && foot.feature == other.nearestFoot(p).feature) continue;
        if (mine.leavesCone(v, foot.outward) > 0.03) continue;
        // A point behind its edge or vertex lies in a reflex corner; then the pseudo-normal says inside.
        Vec3 pseudo = Vec3::Zero();
        if (foot.feature.size() == 2) {
          for (const int t : other.edges.at({foot.feature[0], foot.feature[1]})) pseudo += other.normal(t);
        } else if (foot.feature.size() == 1) {
          pseudo = other.vertexNormal(foot.feature[0]);
        } else {
          pseudo = foot.outward;
        }
        if (pseudo.dot(p - foot.point) < 0) continue;
        add(v, foot, foot.outward, gap);
      }
    }
  };
  vertices(a, b, true);
  vertices(b, a, false);

  // How the two faces beside an edge bend, and whether they bound a plane with the normal n through it.
  enum class Bend { Flat, Convex };
  const auto bendOf = [](const Mesh& m, const std::array<int, 2>& edge, const std::vector<int>& triangles) {
    const Vec3 away = m.x(m.opposite(triangles[1], edge)) - m.x(edge[0]);
    if (m.normal(triangles[0]).dot(away) >= -1e-3 * away.norm()) return Bend::Flat;
    return Bend::Convex;
  };
  const auto steepest = [](const Mesh& m, const std::vector<int>& triangles, const Vec3& n) {
    return std::min(m.normal(triangles[0]).dot(n), m.normal(triangles[1]).dot(n));
  };
  const auto under = [&](const Mesh& m, const std::array<int, 2>& edge, const std::vector<int>& triangles, Bend bend, const Vec3& n) {
    if (bend == Bend::Flat) return steepest(m, triangles, n) > 0.85;
    double highest = -1e30;  // sine of the steepest way up from the edge in one of its faces
    const Vec3 along = (m.x(edge[1]) - m.x(edge[0])).normalized();
    for (const int t : triangles) {
      const Vec3 away = m.x(m.opposite(t, edge)) - m.x(edge[0]);
      highest = std::max(highest, n.dot((away - away.dot(along) * along).normalized()));
    }
    return highest <= 0.03;
  };
  for (const auto& [ea, ta] : a.edges) {
    const Bend bendA = bendOf(a, ea, ta);
    for (const auto& [eb, tb] : b.edges) {
      const Bend bendB = bendOf(b, eb, tb);
      const bool bothConvex = bendA != Bend::Flat && bendB != Bend::Flat;
      const bool dents = (bendA == Bend::Convex && bendB == Bend::Flat && deforms[1]) ||
                         (bendB == Bend::Convex && bendA == Bend::Flat && deforms[0]);
      if (!bothConvex && !dents) continue;
      const Vec3 da = a.x(ea[1]) - a.x(ea[0]), db = b.x(eb[1]) - b.x(eb[0]);
      if (da.cross(db).norm() <= 1e-3 * da.norm() * db.norm()) continue;
      // Least squares for the points of the two lines that are nearest to each other.
      Eigen::Matrix<double, 3, 2> lines;
      lines << da, -db;
      const Vec2 st = lines.colPivHouseholderQr().solve(b.x(eb[0]) - a.x(ea[0]));
      const Vec2 on = st.cwiseMax(0.0).cwiseMin(1.0);
      const double past = std::max(std::abs(st[0] - on[0]) * da.norm(), std::abs(st[1] - on[1]) * db.norm());
      const Vec3 pa = a.x(ea[0]) + on[0] * da, pb = b.x(eb[0]) + on[1] * db;
      for (const double sign : {1.0, -1.0}) {
        const Vec3 n = sign * da.cross(db).normalized();
        const double gap = n.dot(pa - pb);
        if (gap >= contactDistance || gap < -edgeDepth) continue;
        // Beyond an end only where the line of edges dips there.
        const double slide = std::max(1e-4 * contactDistance, -gap);
        if (past > std::min(contactDistance, slide)) continue;
        const auto reached = [&](double rise) { return rise > 0 && gap < slide * rise; };
        if (st[0] != on[0] && !reached(a.dips(on[0] > 0 ? ea[1] : ea[0], on[0] > 0 ? da : Vec3(-da), -n))) continue;
        if (st[1] != on[1] && !reached(b.dips(on[1] > 0 ? eb[1] : eb[0], on[1] > 0 ? db : Vec3(-db), n))) continue;
        if (!under(b, eb, tb, bendB, n) || !under(a, ea, ta, bendA, -n)) continue;
        if (gap < 0) {
          const bool inA = steepest(a, ta, -n) > 0.4, inB = steepest(b, tb, n) > 0.4;
          if (!inA && !inB) continue;
          if (inB && !(b.inside(pa) && (b.nearestFoot(pa).point - pa).norm() >= -0.4 * gap)) continue;
          if (inA && !(a.inside(pb) && (a.nearestFoot(pb).point - pb).norm() >= -0.4 * gap)) continue;
        }
        found[join({ea[0], ea[1]}, {eb[0], eb[1]})] = {gap, n};
      }
    }
  }
  return found;
}

}  // namespace glenoid
