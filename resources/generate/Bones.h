// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/shape/Field.h"

/// The two bones as implicit shapes, and where things are on them. Frame W, millimetres. Landmarks and sizes:
/// measured positions of one adult man scaled so that the head radius is 24 mm (mean of Iannotti 1992), the
/// acromion raised by 4 mm to a subacromial gap of 9 mm (Petersson 1984), sizes otherwise from the literature
/// (glenoid: von Schroeder 2001; groove: PMID 38259382; head: Iannotti 1992). The shapes are our own.
namespace glenoid::generate {

using namespace shape;

namespace humerus {
inline constexpr double kHeadRadius = 24;
inline constexpr double kNeckShaftAngle = 133, kRetroversion = 26;  ///< degrees
/// Unit, from the head's centre through the middle of its cartilage.
Vec3 headAxis();
/// Point of the canal axis at a height, and the axis itself (unit, proximal).
Vec3 canalAt(double y);
Vec3 canalAxis();
/// Floor of the bicipital groove from top to bottom.
std::vector<Vec3> groovePath();
/// Epicondyles.
Vec3 lateralEpicondyle();
Vec3 medialEpicondyle();
Field field();
/// The same without the groove, for what bridges it.
Field filledField();
}  // namespace humerus

namespace scapula {
/// Bone of the socket: 33.4 ± 3.3 in PMC12925909; its deepest point leaves the head room for two cartilages.
inline constexpr double kSocketRadius = 32, kSocketDepth = 27.2;
/// Height of the socket's surface over its deepest point, in the glenoid frame.
double socketHeight(double x, double y);
/// Blade frame: origin at the trigonum spinae (TS), x lateral toward the glenoid, y up along the medial
/// border, z dorsal; the blade lies near z = 0.
Frame blade();
/// Glenoid frame: origin at the deepest point of the socket, x anterior, y superior, z lateral (toward the
/// head).
Frame glenoid();
/// Acromion frame: origin in its middle, x forward along it, y medial, z up.
Frame acromion();
/// Rim of the socket in the glenoid frame, (x, y); counter-clockwise from the top.
std::vector<Vec2> glenoidRim();
/// Point of the blade surface's middle, from coordinates in its plane.
Vec3 onBlade(double x, double y, double dorsal);
/// Knots along the coracoid from its root to its tip.
std::vector<Knot> coracoid();
Field field();
/// Acromion alone: the roof that the cuff keeps away from.
Field acromionField();
Field coracoidField();
}  // namespace scapula

}  // namespace glenoid::generate
