// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <vector>

#include "simcore/base/Math.h"

/// Implicit shapes that bones are modelled with: a field is negative inside, roughly a distance near
/// its surface, positive outside. Not for use in a step: std::function and finite differences.
/// Frame W of the joint, but in millimetres (whoever writes them turns to metres).
/// Source of the polynomial smooth minimum: Inigo Quilez, "Smooth minimum" (his formula, our code).
namespace glenoid::shape {

using Field = std::function<double(const Vec3&)>;

/// Point with a radius, a knot of a chain.
struct Knot {
  Vec3 at;
  double radius;
};

/// Right-handed axes with an origin; columns of `axes` are the local x, y, z in W.
struct Frame {
  Vec3 origin = Vec3::Zero();
  Mat3 axes = Mat3::Identity();
  Vec3 toLocal(const Vec3& p) const { return axes.transpose() * (p - origin); }
  Vec3 toWorld(const Vec3& q) const { return origin + axes * q; }
};

Field sphere(const Vec3& centre, double radius);
/// Ellipsoid with half-axes along the frame's axes; distance is approximate away from the surface.
Field ellipsoid(const Frame& frame, const Vec3& halfAxes);
/// Round tube along a Catmull–Rom curve through the knots.
Field chain(const std::vector<Knot>& knots);
/// The field drawn out by `factor` along `direction` about `origin` (> 1 makes it wider there).
Field stretched(Field field, const Vec3& origin, const Vec3& direction, double factor);

/// Plate over a polygon in the frame's xy plane, thickness along z, edges rounded by `rounding`;
/// `height(x, y)` bends its middle surface and `taper(x, y)` scales its thickness.
struct Plate {
  Frame frame;
  std::vector<Vec2> outline;  ///< counter-clockwise or clockwise, simple
  double thickness = 3, rounding = 1;
  std::function<double(double, double)> height = [](double, double) { return 0.0; };
  std::function<double(double, double)> taper = [](double, double) { return 1.0; };
};
Field plate(Plate shape);

/// Outline of a long bone's section in the frame's xy plane at a height z: its four extreme points about
/// `centre`, where the middle of the outline's length comes to lie, and how full its corners are to the +y
/// and the −y side (0.71: an ellipse; less: a ridge between flat faces).
struct Section {
  double z;
  Vec2 centre, left, right, front, back;
  double fullFront = 0.71, fullBack = 0.71;
};
/// Body through sections in order of z, which runs up or down; ends are rounded by `rounding`.
Field swept(const Frame& frame, const std::vector<Section>& sections, double rounding);

/// Turned on a lathe about the frame's x axis: (x, radius) from one end to the other, corners rounded by
/// `rounding`.
Field turned(const Frame& frame, const std::vector<Vec2>& profile, double rounding);

Field smoothUnion(std::vector<Field> fields, double blend);
Field smoothSubtract(Field from, Field what, double blend);
Field unionOf(Field a, Field b);

/// Signed distance to a closed polygon, negative inside.
double polygonDistance(const std::vector<Vec2>& polygon, const Vec2& p);
/// Closed curve through the points (Catmull–Rom), `perSpan` samples each.
std::vector<Vec2> closedCurve(const std::vector<Vec2>& points, int perSpan);

/// Central differences with a step of 0.05 mm.
Vec3 gradient(const Field& field, const Vec3& p);
/// Distance to the surface to first order: value over length of the gradient.
double distance(const Field& field, const Vec3& p);
/// Newton along the gradient to the level `offset`; a few iterations, bounded steps.
Vec3 project(const Field& field, Vec3 p, double offset = 0);

/// Moves p along +direction until the field is at least `clearance`, at most 22 mm, or, when it is already
/// clear, along −direction until it is down on it, at most `reach`; without a hit p stays. `direction` is a
/// unit vector.
Vec3 settle(const Field& field, Vec3 p, const Vec3& direction, double clearance, double reach);

}  // namespace glenoid::shape
