// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "resources/generate/Parts.h"

/// Middle surface of the shoulder's capsule. Millimetres, frame W.
namespace glenoid::generate {

/// Place on the sleeve: share of the way round (0 above, a quarter behind, a half below, three quarters in front; any number, taken
/// modulo one), and of the way from the scapula (0) to the humerus (1).
struct SleevePlace {
  double turn = 0, way = 0;
};

/// A sleeve from the neck of the glenoid, medial of the labrum, to the anatomical neck of the humerus, drawn tight over the head,
/// labrum and biceps tendon with room for what lies on its inner side. Below, where both ends come near each other while the arm
/// hangs, it sags between them: the axillary pouch.
/// Sources: ring on the scapula 7 to 8 mm medial of the rim (Bain 2013); below it reaches past the cartilage's border down the neck.
class Sleeve {
 public:
  /// Thickness of what lies on the inner side at a place, mm.
  using Lining = std::function<double(const SleevePlace&)>;
  /// `inside`: what it contains besides the head, the biceps tendon last; `thickness` of the wall.
  Sleeve(const Bones& bones, const std::vector<TriMesh>& inside, double thickness, const Lining& lining);

  Vec3 at(const SleevePlace& place) const;
  /// Unit, away from the joint.
  Vec3 outward(const SleevePlace& place) const;
  /// Turns at which its two ends lie nearest to a place each.
  static std::pair<double, double> turnsNear(const Bones& bones, const Vec3& onScapula, const Vec3& onHumerus);

 private:
  std::vector<Vec3> m_points;
};

}  // namespace glenoid::generate
