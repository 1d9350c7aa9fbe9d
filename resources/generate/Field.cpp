// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/Field.h"

#include <algorithm>
#include <cmath>

namespace glenoid::generate {

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
    const double side = polygonDistance(shape.outline, q.head<2>()) + shape.rounding;
    const double top = std::abs(q.z() - shape.height(q.x(), q.y())) - shape.thickness / 2 + shape.rounding;
    return std::min(std::max(side, top), 0.0) + Vec2(std::max(side, 0.0), std::max(top, 0.0)).norm() -
           shape.rounding;
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
  constexpr double kStep = 0.25;  // mm; thin bone is 3 mm, so no march steps over it
  const bool clear = field(p) >= clearance;
  const double sign = clear ? -1 : 1, length = clear ? reach : 40;
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

}  // namespace glenoid::generate
