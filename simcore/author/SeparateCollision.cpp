// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "simcore/author/BuildJoint.h"
#include "simcore/author/Overlaps.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

/// Pushes aim a little farther than asked, so that the approach to the goal ends.
constexpr double kAim = 1.1;

struct Edge {
  int a, b;
  Vec3 normal;  ///< mean of the two triangles', unit
  bool convex;
};

/// One part's collision surface while it is moved.
struct Body {
  const Part* part = nullptr;
  TriMesh mesh;
  std::vector<std::array<int, 4>> edgeLinks;  ///< ends, then the corners across
  double meanEdge = 0;
  int startCuts = 0;
  // Of this iteration:
  std::unique_ptr<TriangleTree> tree;
  Box3 box;
  std::vector<Edge> edges;
  std::vector<Vec3> vertexNormals;
  std::vector<Vec3> push;      ///< Σ push · |push|
  std::vector<double> weight;  ///< Σ |push|
};

struct Segments {
  double s, t;  ///< parameters of the nearest points
  Vec3 p, q;
};

/// Nearest points of two segments. Source: Ericson, "Real-Time Collision Detection", 2005, section 5.1.9.
Segments nearestOf(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const Vec3 u = p1 - p0, v = q1 - q0, r = p0 - q0;
  const double a = u.dot(u), e = v.dot(v), f = v.dot(r), c = u.dot(r), b = u.dot(v), den = a * e - b * b;
  double s = den > 1e-12 * a * e ? std::clamp((b * f - c * e) / den, 0.0, 1.0) : 0.0;
  double t = e > 0 ? (b * s + f) / e : 0;
  if (t < 0) t = 0, s = a > 0 ? std::clamp(-c / a, 0.0, 1.0) : 0;
  if (t > 1) t = 1, s = a > 0 ? std::clamp((b - c) / a, 0.0, 1.0) : 0;
  return {s, t, p0 + s * u, q0 + t * v};
}

Body bodyOf(const Part& part) {
  Body body;
  body.part = &part;
  body.mesh = *part.collision;
  std::vector<std::array<int, 4>> sides;  // low, high, corner across, 0
  for (const auto& t : body.mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t[(i + 2) % 3], 0});
    }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
    body.edgeLinks.push_back({sides[i][0], sides[i][1], sides[i][2], sides[i + 1][2]});
  for (const auto& l : body.edgeLinks)
    body.meanEdge += (body.mesh.vertices[l[0]] - body.mesh.vertices[l[1]]).norm() / body.edgeLinks.size();
  body.startCuts = countSelfIntersections(body.mesh);
  return body;
}

void refresh(Body& body) {
  const auto& x = body.mesh.vertices;
  body.tree = std::make_unique<TriangleTree>(body.mesh);
  body.box = boundsOf(body.mesh);
  body.push.assign(x.size(), Vec3::Zero());
  body.weight.assign(x.size(), 0);
  body.vertexNormals.assign(x.size(), Vec3::Zero());
  for (const auto& t : body.mesh.triangles)
    for (const int v : t) body.vertexNormals[v] += (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
  for (Vec3& n : body.vertexNormals) n.normalize();
  body.edges.clear();
  for (const auto& [a, b, c, d] : body.edgeLinks) {
    // Facing away from the corners across is outwards at a convex edge and inwards at a concave one.
    const Vec3 away = (x[a] + x[b]) - (x[c] + x[d]);
    const Vec3 out = body.vertexNormals[a] + body.vertexNormals[b];
    const Vec3 n1 = (x[b] - x[a]).cross(x[c] - x[a]).normalized(),
               n2 = (x[d] - x[a]).cross(x[b] - x[a]).normalized();
    const Vec3 sum = n1 + n2;
    const Vec3 normal = (sum.dot(out) < 0 ? Vec3(-sum) : sum).normalized();
    body.edges.push_back({a, b, normal, away.dot(normal) > 0});
  }
}

/// The soft one of a rigid and a soft part, else the one of higher number.
bool firstYields(const Part& a, const Part& b) {
  if (a.kind != b.kind) return a.kind == PartKind::Soft;
  return a.number > b.number;
}

/// Asks for a shift of the point Σ w x of the yielding surface by `shift`.
void ask(Body& body, const std::array<int, 3>& vertex, const Vec3& w, const Vec3& shift) {
  const double squares = w.squaredNorm(), size = shift.norm();
  for (int i = 0; i < 3; ++i) {
    if (w[i] <= 0) continue;
    body.push[vertex[i]] += w[i] / squares * shift * size;
    body.weight[vertex[i]] += size;
  }
}

void askFromVertices(Body& yielding, const Body& firm, double clearance) {
  const Box3 reach(firm.box.min().array() - clearance, firm.box.max().array() + clearance);
  for (int v = 0; v < static_cast<int>(yielding.mesh.vertices.size()); ++v) {
    const Vec3& x = yielding.mesh.vertices[v];
    if (!reach.contains(x)) continue;
    const auto near = firm.tree->closest(x);
    const double distance = firm.tree->inside(x) ? -near.distance : near.distance;
    if (distance >= clearance) continue;
    Vec3 out = (x - near.point) * (distance < 0 ? -1 : 1);
    if (near.distance < 1e-3 * clearance) {
      const auto& t = firm.mesh.triangles[near.triangle];
      const auto& y = firm.mesh.vertices;
      out = (y[t[1]] - y[t[0]]).cross(y[t[2]] - y[t[0]]);
    }
    ask(yielding, {v, v, v}, Vec3::UnitX(), out.normalized() * (kAim * clearance - distance));
  }
}

void askFromFaces(Body& yielding, const Body& firm, double clearance) {
  const Box3 reach(yielding.box.min().array() - clearance, yielding.box.max().array() + clearance);
  for (std::size_t v = 0; v < firm.mesh.vertices.size(); ++v) {
    const Vec3& x = firm.mesh.vertices[v];
    if (!reach.contains(x)) continue;
    const auto near = yielding.tree->closest(x);
    const double distance = yielding.tree->inside(x) ? -near.distance : near.distance;
    if (distance >= clearance) continue;
    Vec3 away = (near.point - x) * (distance < 0 ? -1 : 1);
    // A point that came through more than half of a thin part is nearer to the far side: back the way it
    // came.
    if (near.distance < 1e-3 * clearance || away.dot(firm.vertexNormals[v]) < 0) away = firm.vertexNormals[v];
    ask(yielding, yielding.mesh.triangles[near.triangle], near.barycentric,
        away.normalized() * (kAim * clearance - distance));
  }
}

void askFromEdges(Body& yielding, const Body& firm, double clearance) {
  const auto &x = yielding.mesh.vertices, &y = firm.mesh.vertices;
  // Deep crossings show as edges that are near each other on the wrong side: look farther than the clearance.
  const double look = std::max(2 * clearance, 0.25 * std::min(yielding.meanEdge, firm.meanEdge));
  for (const Edge& e : yielding.edges) {
    Box3 box(x[e.a]);
    box.extend(x[e.b]);
    box = Box3(box.min().array() - look, box.max().array() + look);
    if (!box.intersects(firm.box)) continue;
    for (const Edge& f : firm.edges) {
      Box3 other(y[f.a]);
      other.extend(y[f.b]);
      if (!f.convex || !box.intersects(other)) continue;
      const Segments near = nearestOf(x[e.a], x[e.b], y[f.a], y[f.b]);
      if (near.s <= 0 || near.s >= 1 || near.t <= 0 || near.t >= 1) continue;  // vertices take care of it
      const Vec3 gap = near.p - near.q;
      const double length = gap.norm();
      const bool through = gap.dot(f.normal) < 0;
      if (through ? length >= look || !firm.tree->inside(near.p) : length >= clearance) continue;
      Vec3 out = through ? Vec3(-gap) : gap;
      if (length < 1e-3 * clearance) out = f.normal;
      ask(yielding, {e.a, e.b, e.b}, Vec3(1 - near.s, near.s, 0),
          out.normalized() * (kAim * clearance + (through ? length : -length)));
    }
  }
}

/// Spreads what was asked for over all vertices within `radius`, so that thin parts move whole.
std::vector<Vec3> spread(const Body& body, double radius) {
  const auto& x = body.mesh.vertices;
  std::vector<Vec3> shift(x.size(), Vec3::Zero());
  for (std::size_t v = 0; v < x.size(); ++v) {
    double sum = 0;
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (body.weight[j] <= 0) continue;
      const double r = (x[v] - x[j]).norm() / radius;
      if (r >= 1) continue;
      const double share = (1 - r * r) * (1 - r * r);
      sum += share;
      shift[v] += share * body.push[j] / body.weight[j];
    }
    shift[v] /= std::max(sum, 1.0);
  }
  return shift;
}

/// Moves by what was asked for. Narrow dents come later; a move that would make the surface cut itself is
/// tried with a wider spread, and left out when that does not help either.
void move(Body& body, double radius) {
  for (const double wider : {1.0, 2.0, 4.0}) {
    const std::vector<Vec3> shift = spread(body, wider * radius);
    TriMesh moved = body.mesh;
    for (std::size_t v = 0; v < shift.size(); ++v) moved.vertices[v] += shift[v];
    const MeshHealth health = healthOf(moved);
    if (health.notFinite > 0 || health.degenerateTriangles > 0 || !(health.volume > 0)) continue;
    if (countSelfIntersections(moved) > body.startCuts) continue;
    body.mesh = std::move(moved);
    return;
  }
}

/// Least distance of two surfaces as far as it is below `limit`; 0 when they cut or one holds the other.
double distanceOf(const Body& a, const Body& b, double limit) {
  const Box3 reach(a.box.min().array() - limit, a.box.max().array() + limit);
  if (!reach.intersects(b.box)) return limit;
  double least = limit;
  for (const auto& [p, q] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Vec3& x : p->mesh.vertices) {
      const auto near = q->tree->closest(x, least);
      if (near.triangle >= 0) least = std::min(least, near.distance);
      if (q->box.contains(x) && q->tree->inside(x)) return 0;
    }
  const auto &x = a.mesh.vertices, &y = b.mesh.vertices;
  for (const Edge& e : a.edges) {
    Box3 box(x[e.a]);
    box.extend(x[e.b]);
    box = Box3(box.min().array() - least, box.max().array() + least);
    if (!box.intersects(b.box)) continue;
    for (const Edge& f : b.edges) {
      Box3 other(y[f.a]);
      other.extend(y[f.b]);
      if (!box.intersects(other)) continue;
      const Segments near = nearestOf(x[e.a], x[e.b], y[f.a], y[f.b]);
      least = std::min(least, (near.p - near.q).norm());
    }
  }
  return intersectingTriangles(a.mesh, b.mesh).empty() ? least : 0;
}

}  // namespace

Result<SeparationReport> separateCollision(Joint& joint, double clearance, int iterations) {
  if (!(clearance > 0) || !std::isfinite(clearance))
    return Error{
        Fault::OutOfRange, {}, {std::to_string(clearance), "0", "inf"}, "clearance of collision surfaces"};
  std::vector<Body> bodies;
  for (const Part& part : joint.parts) {
    if (!part.collision)
      return Error{Fault::BadMesh, {{}, {}, part.id, {}}, {"no collision surface"}, "separation"};
    if (const auto closed = requireClosed(*part.collision, part.id); !closed) return closed.error();
    bodies.push_back(bodyOf(part));
  }
  const int n = static_cast<int>(bodies.size());
  const std::vector<std::array<int, 2>> pairs = pairsThatMayCollide(joint);

  SeparationReport report;
  for (Body& body : bodies) refresh(body);
  for (; report.iterations < iterations; ++report.iterations) {
    for (const auto& [i, j] : pairs) {
      const bool first = firstYields(*bodies[i].part, *bodies[j].part);
      Body& yielding = bodies[first ? i : j];
      const Body& firm = bodies[first ? j : i];
      if (distanceOf(yielding, firm, clearance) >= clearance) continue;
      askFromVertices(yielding, firm, clearance);
      askFromFaces(yielding, firm, clearance);
      askFromEdges(yielding, firm, clearance);
    }
    // From two edges' length down to a quarter: first the part gives way as a whole, in the end it is dented.
    const double progress = static_cast<double>(report.iterations) / iterations;
    bool asked = false;
    for (Body& body : bodies) {
      if (std::none_of(body.weight.begin(), body.weight.end(), [](double w) { return w > 0; })) continue;
      asked = true;
      move(body, body.meanEdge * (2 - 1.75 * progress));
      refresh(body);
    }
    if (!asked) break;
  }
  for (const auto& [i, j] : pairs) {
    const double distance = distanceOf(bodies[i], bodies[j], clearance);
    const bool inOrder = bodies[i].part->number < bodies[j].part->number;
    if (distance < clearance)
      report.left.push_back({bodies[inOrder ? i : j].part->id, bodies[inOrder ? j : i].part->id, distance});
  }
  for (int i = 0; i < n; ++i) {
    const TriMesh& before = *joint.parts[i].collision;
    double most = 0;
    for (std::size_t v = 0; v < before.vertices.size(); ++v) {
      const double shift = (bodies[i].mesh.vertices[v] - before.vertices[v]).norm();
      report.movedVertices += shift > 0;
      most = std::max(most, shift);
    }
    report.maxShift = std::max(report.maxShift, most);
    if (most > 0) joint.parts[i].collision = std::make_shared<const TriMesh>(std::move(bodies[i].mesh));
  }
  return report;
}

}  // namespace glenoid
