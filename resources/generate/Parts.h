// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/shape/Tube.h"

/// The eleven parts' surfaces, frame W, millimetres. Triangle counts are those of Table 1 of the paper as
/// near as closed surfaces allow (an odd count cannot close). Collision surfaces of soft parts lie on the
/// bones' collision surfaces, not on their visual ones, so that coarse triangles of both sides stay apart.
namespace glenoid::generate {

using namespace shape;

struct Surfaces {
  TriMesh visual, collision;
};

/// Bones as surfaces and as fields: the shapes themselves, and signed distances to the coarse surfaces.
struct Bones {
  Surfaces scapula, humerus;
  Field scapulaShape, humerusShape;
  Field scapulaCoarse, humerusCoarse;
};
/// Made by the first call and kept.
const Bones& makeBones();

/// Signed distance to a closed surface as a field.
Field fieldOf(const TriMesh& closed);

/// Stations along the cuff muscles, from the medial border to the footprint.
std::vector<Station> supraspinatusPath();
std::vector<Station> infraspinatusPath();
std::vector<Station> subscapularisPath();
Surfaces supraspinatus(const Bones& bones);
Surfaces infraspinatus(const Bones& bones);
Surfaces subscapularis(const Bones& bones);
/// Below the infraspinatus, whose surface it keeps off.
std::vector<Station> teresMinorPath();
Surfaces teresMinor(const Bones& bones, const TriMesh& infraspinatus);

/// Middle of the long biceps tendon from its root to below the groove, and its half sizes.
std::vector<Vec3> bicepsPath();
inline constexpr double kBicepsHalfWidth = 3.5, kBicepsHalfThickness = 2.25;
/// Rim of the socket in W with the outward direction in its plane. `turn`: share of the way round, 0 above, a quarter behind,
/// a half below, three quarters in front.
struct RimPoint {
  Vec3 at, out;
};
RimPoint rimAt(double turn);

Surfaces bicepsTendon(const Bones& bones);
/// Its visual surface in so many rings of so many points; as few as in the published table unless asked for more.
inline constexpr int kAnchorAround = 8, kAnchorAlong = 8;
Surfaces labrumTendon(const Bones& bones, int around = kAnchorAround, int along = kAnchorAlong);
Surfaces labrum(const Bones& bones);

Surfaces coracoacromialLigament(const Bones& bones);
/// Both lie over the biceps tendon, whose surface they need.
Surfaces coracohumeralLigament(const Bones& bones, const TriMesh& biceps);
Surfaces transverseHumeralLigament(const Bones& bones, const TriMesh& biceps);

}  // namespace glenoid::generate
