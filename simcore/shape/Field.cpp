// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/shape/Field.h"

#include <algorithm>
#include <cmath>

namespace glenoid::shape {

namespace {

double smoothMin(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * k * 0.25;
}

double coneDistance(const Knot& a, const Knot& b, const Vec3& p) {
  const Vec3 axis = b.at - a.at;
  const double t = std::clamp((p - a.at).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return (p - a.at - t * axis).norm() - (a.radius + t * (b.radius - a.radius));
}

double catmullRom(double a, double b, double c, double d, double t) {
  return 0.5 *
         (2 * b + t * (c - a) + t * t * (2 * a - 5 * b + 4 * c - d) + t * t * t * (3 * b - a - 3 * c + d));
}

/// Closed outline of a section, moved so that its middle lies where the section says.
std::vector<Vec2> outlineOf(const Section& s) {
  const auto corner = [](const Vec2& a, const Vec2& b, double full) { return Vec2(full * (a + b)); };
  std::vector<Vec2> curve = closedCurve(
      {s.right, corner(s.right, s.front, s.fullFront), s.front, corner(s.front, s.left, s.fullFront), s.left,
       corner(s.left, s.back, s.fullBack), s.back, corner(s.back, s.right, s.fullBack)},
      5);
  Vec2 middle = Vec2::Zero();
  double length = 0;
  for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) {
    const double l = (curve[i] - curve[j]).norm();
    middle += l * 0.5 * (curve[i] + curve[j]);
    length += l;
  }
  for (Vec2& p : curve) p += s.centre - middle / length;
  return curve;
}

/// Both distances as one, with a round edge between the two faces.
double rounded(double a, double b, double rounding) {
  a += rounding, b += rounding;
  return std::min(std::max(a, b), 0.0) + Vec2(std::max(a, 0.0), std::max(b, 0.0)).norm() - rounding;
}

}  // namespace

Field sphere(const Vec3& centre, double radius) {
  return [=](const Vec3& p) { return (p - centre).norm() - radius; };
}

Field ellipsoid(const Frame& frame, const Vec3& halfAxes) {
  return [=](const Vec3& p) {
    const Vec3 q = frame.toLocal(p);
    const double k0 = q.cwiseQuotient(halfAxes).norm();
    const double k1 = q.cwiseQuotient(halfAxes.cwiseProduct(halfAxes)).norm();
    return k1 < 1e-12 ? -halfAxes.minCoeff() : k0 * (k0 - 1) / k1;
  };
}

Field chain(const std::vector<Knot>& knots) {
  // A curve through the knots, fine enough that its corners do not show; radii go the same way.
  std::vector<Knot> fine;
  const int n = int(knots.size());
  for (int i = 0; i + 1 < n; ++i) {
    const Vec3 p0 = knots[std::max(i - 1, 0)].at, p1 = knots[i].at, p2 = knots[i + 1].at,
               p3 = knots[std::min(i + 2, n - 1)].at;
    const double r0 = knots[std::max(i - 1, 0)].radius, r1 = knots[i].radius, r2 = knots[i + 1].radius;
    const double r3 = knots[std::min(i + 2, n - 1)].radius;
    const int steps = n == 2 ? 1 : 6;
    for (int k = 0; k < steps; ++k) {
      const double t = double(k) / steps;
      fine.push_back({0.5 * (2 * p1 + t * (p2 - p0) + t * t * (2 * p0 - 5 * p1 + 4 * p2 - p3) +
                             t * t * t * (3 * p1 - p0 - 3 * p2 + p3)),
                      0.5 * (2 * r1 + t * (r2 - r0) + t * t * (2 * r0 - 5 * r1 + 4 * r2 - r3) +
                             t * t * t * (3 * r1 - r0 - 3 * r2 + r3))});
    }
  }
  fine.push_back(knots.back());
  Box3 box;
  for (const Knot& k : fine) {
    box.extend(k.at + Vec3::Constant(k.radius));
    box.extend(k.at - Vec3::Constant(k.radius));
  }
  return [fine, box](const Vec3& p) {
    const double far = box.exteriorDistance(p);
    if (far > 25) return far;  // no blend reaches that far, so the bound will do
    double d = coneDistance(fine[0], fine[1], p);
    for (std::size_t i = 2; i < fine.size(); ++i) d = std::min(d, coneDistance(fine[i - 1], fine[i], p));
    return d;
  };
}

Field stretched(Field field, const Vec3& origin, const Vec3& direction, double factor) {
  const Vec3 n = direction.normalized();
  return [=](const Vec3& p) {
    const double along = (p - origin).dot(n);
    return field(p + (along / factor - along) * n) * std::min(1.0, factor);
  };
}

Field plate(Plate shape) {
  return [shape = std::move(shape)](const Vec3& p) {
    const Vec3 q = shape.frame.toLocal(p);
    return rounded(
        polygonDistance(shape.outline, q.head<2>()),
        std::abs(q.z() - shape.height(q.x(), q.y())) - shape.taper(q.x(), q.y()) * shape.thickness / 2,
        shape.rounding);
  };
}

Field swept(const Frame& frame, const std::vector<Section>& sections, double rounding) {
  // Outlines every millimetre, between which a straight line will do.
  const int n = int(sections.size());
  const double bottom = std::min(sections.front().z, sections.back().z),
               top = std::max(sections.front().z, sections.back().z);
  const int steps = int(std::ceil(top - bottom));
  std::vector<std::vector<Vec2>> given, outlines(steps + 1);
  for (const Section& s : sections) given.push_back(outlineOf(s));
  const double sign = sections.back().z > sections.front().z ? 1 : -1;
  for (int k = 0; k <= steps; ++k) {
    const double z = bottom + (top - bottom) * k / steps;
    int i = 0;
    while (i + 2 < n && sign * (z - sections[i + 1].z) > 0) ++i;
    const double t = (z - sections[i].z) / (sections[i + 1].z - sections[i].z);
    // Slopes over unequal spans: finite differences (Catmull and Rom's for equal ones).
    const auto slope = [&](int j, std::size_t v) -> Vec2 {
      const int l = std::max(j - 1, 0), r = std::min(j + 1, n - 1);
      return (given[r][v] - given[l][v]) / (sections[r].z - sections[l].z) *
             (sections[i + 1].z - sections[i].z);
    };
    for (std::size_t v = 0; v < given[i].size(); ++v) {
      const Vec2 a = given[i][v], b = given[i + 1][v], m = slope(i, v), o = slope(i + 1, v);
      outlines[k].push_back((2 * t * t * t - 3 * t * t + 1) * a + (t * t * t - 2 * t * t + t) * m +
                            (3 * t * t - 2 * t * t * t) * b + (t * t * t - t * t) * o);
    }
  }
  return [=](const Vec3& p) {
    const Vec3 q = frame.toLocal(p);
    const double place = std::clamp((q.z() - bottom) / (top - bottom), 0.0, 1.0) * steps;
    const int k = std::min(int(place), steps - 1);
    const double t = place - k;
    static thread_local std::vector<Vec2> outline;
    outline.resize(outlines[k].size());
    for (std::size_t v = 0; v < outline.size(); ++v)
      outline[v] = (1 - t) * outlines[k][v] + t * outlines[k + 1][v];
    return rounded(polygonDistance(outline, q.head<2>()), std::max(bottom - q.z(), q.z() - top), rounding);
  };
}

Field turned(const Frame& frame, const std::vector<Vec2>& profile, double rounding) {
  // The profile's curve, closed across the axis, a little smaller than wanted and rounded back.
  const int n = int(profile.size());
  std::vector<Vec2> closed;
  for (int i = 0; i + 1 < n; ++i)
    for (int k = 0; k < 6; ++k) {
      const Vec2 &a = profile[std::max(i - 1, 0)], &b = profile[i], &c = profile[i + 1],
                 &d = profile[std::min(i + 2, n - 1)];
      closed.push_back(
          {catmullRom(a.x(), b.x(), c.x(), d.x(), k / 6.0), catmullRom(a.y(), b.y(), c.y(), d.y(), k / 6.0)});
    }
  closed.push_back(profile.back());
  for (Vec2& p : closed) p.y() -= rounding;
  const double first = closed.front().x() + rounding, last = closed.back().x() - rounding;
  for (Vec2& p : closed) p.x() = std::clamp(p.x(), std::min(first, last), std::max(first, last));
  closed.push_back({last, -5});
  closed.push_back({first, -5});
  return [=](const Vec3& p) {
    const Vec3 q = frame.toLocal(p);
    return polygonDistance(closed, Vec2(q.x(), q.tail<2>().norm())) - rounding;
  };
}

Field smoothUnion(std::vector<Field> fields, double blend) {
  return [fields = std::move(fields), blend](const Vec3& p) {
    double d = fields[0](p);
    for (std::size_t i = 1; i < fields.size(); ++i) d = smoothMin(d, fields[i](p), blend);
    return d;
  };
}

Field smoothSubtract(Field from, Field what, double blend) {
  return [=](const Vec3& p) { return -smoothMin(-from(p), what(p), blend); };
}

Field unionOf(Field a, Field b) {
  return [=](const Vec3& p) { return std::min(a(p), b(p)); };
}

double polygonDistance(const std::vector<Vec2>& polygon, const Vec2& p) {
  double best = (p - polygon[0]).squaredNorm();
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 a = polygon[i], edge = polygon[j] - a, w = p - a;
    const double t = std::clamp(w.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    best = std::min(best, (w - t * edge).squaredNorm());
    const bool crosses = (a.y() > p.y()) != (polygon[j].y() > p.y());
    if (crosses && p.x() < edge.x() * (p.y() - a.y()) / edge.y() + a.x()) inside = !inside;
  }
  return (inside ? -1.0 : 1.0) * std::sqrt(best);
}

std::vector<Vec2> closedCurve(const std::vector<Vec2>& points, int perSpan) {
  std::vector<Vec2> curve;
  const int n = static_cast<int>(points.size());
  for (int i = 0; i < n; ++i) {
    const Vec2 p0 = points[(i + n - 1) % n], p1 = points[i], p2 = points[(i + 1) % n],
               p3 = points[(i + 2) % n];
    for (int k = 0; k < perSpan; ++k) {
      const double t = double(k) / perSpan;
      curve.push_back(0.5 * (2 * p1 + t * (p2 - p0) + t * t * (2 * p0 - 5 * p1 + 4 * p2 - p3) +
                             t * t * t * (3 * p1 - p0 - 3 * p2 + p3)));
    }
  }
  return curve;
}

Vec3 gradient(const Field& field, const Vec3& p) {
  const double h = 0.05;
  Vec3 g;
  for (int i = 0; i < 3; ++i) g[i] = (field(p + h * Vec3::Unit(i)) - field(p - h * Vec3::Unit(i))) / (2 * h);
  return g;
}

double distance(const Field& field, const Vec3& p) {
  return field(p) / std::max(gradient(field, p).norm(), 0.3);
}

Vec3 project(const Field& field, Vec3 p, double offset) {
  for (int i = 0; i < 8; ++i) {
    const Vec3 g = gradient(field, p);
    const double value = field(p) - offset;
    if (std::abs(value) < 1e-4) break;
    Vec3 move = -value * g / std::max(g.squaredNorm(), 0.1);
    if (move.norm() > 1.5) move *= 1.5 / move.norm();
    p += move;
  }
  return p;
}

Vec3 settle(const Field& field, Vec3 p, const Vec3& direction, double clearance, double reach) {
  constexpr double kStep = 0.25;    // mm; thin bone is 3 mm, so no march steps over it
  constexpr double kWayOut = 22.0;  // mm; what is deeper than this came from the other side
  const bool clear = field(p) >= clearance;
  const double sign = clear ? -1 : 1, length = clear ? reach : kWayOut;
  for (double walked = 0; walked < length; walked += kStep) {
    const Vec3 next = p + walked * sign * direction;
    if ((field(next) >= clearance) == clear) continue;
    double low = walked - kStep, high = walked;
    for (int i = 0; i < 20; ++i) {
      const double middle = (low + high) / 2;
      ((field(p + middle * sign * direction) >= clearance) == clear ? low : high) = middle;
    }
    return p + (clear ? low : high) * sign * direction;
  }
  return p;
}

}  // namespace glenoid::shape
