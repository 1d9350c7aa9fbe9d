// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "resources/generate/capsule/Sleeve.h"
#include "simcore/scene/Part.h"

/// The capsule of the shoulder and the three glenohumeral ligaments that thicken it on its inner side.
/// Millimetres, frame W. Sources: thickness 1.5 to 3 mm; the ligaments run between the places that the
/// reference body has them at (times 1.0975), which are 37, 33 and 29 mm long and 12, 12 and 9 mm wide there;
/// the inferior one is a hammock, two bands with the axillary pouch between them (O'Brien 1990), of which the
/// reference body has the anterior band alone.
namespace glenoid::generate {

inline constexpr double kCapsuleThickness = 1.8;

/// A stretch of the sleeve's inner side that a ligament covers, by the turns of its middle and of half its
/// width at both ends.
struct Band {
  double middleFrom = 0, middleTo = 0, halfFrom = 0, halfTo = 0;
  double room = 1;                        ///< width of the hollow that the wall leaves for it, over its own
  double thickness = 1.6;                 ///< mm along its middle
  double border = 1.6;                    ///< mm along its two borders
  int across = 8, along = 20;             ///< cells of its visual sheets
  int coarseAcross = 2, coarseAlong = 6;  ///< of its collision sheets

  double middleAt(double way) const;
  double halfAt(double way) const;
  double thicknessAt(double aside) const;  ///< `aside`: −1 to 1 across
};

/// A tendon that the wall is one with where it lies on it: id and name of the region, negative inside.
struct TendonOver {
  std::string id, name;
  Field tendon;
};

/// What the joint is lined with.
class CapsuleShapes {
 public:
  /// `inside`: what lies in the joint besides the head: labrum, biceps anchor and, last, the biceps tendon. `over`: the tendons
  /// that lie over it; the wall's inner side keeps below them, so that none is seen from inside.
  CapsuleShapes(const Bones& bones, const std::vector<TriMesh>& inside, Field over);

  Surfaces capsule() const;
  Surfaces superior() const { return surfacesOf(m_superior); }
  Surfaces middle() const { return surfacesOf(m_middle); }
  Surfaces inferior() const { return surfacesOf(m_inferior); }

  /// Regions of the capsule: both ends, the pouch, and, for each named muscle, where its tendon lies on the
  /// wall.
  std::vector<Region> capsuleRegions(const TriMesh& visual, const std::vector<TendonOver>& tendons) const;
  /// Regions of a ligament ("superior", "middle" or "inferior"): both ends and the side that the wall
  /// carries.
  std::vector<Region> ligamentRegions(const TriMesh& visual, const std::string& which) const;

 private:
  Surfaces surfacesOf(const Band& band) const;
  TriMesh bandMesh(const Band& band) const;
  TriMesh wall(int around, int along) const;
  TriMesh coarse(const std::vector<SleevePlace>& places, double inwards, double thickness, int across,
                 bool closed, double clearance) const;

  const Bones& m_bones;
  Field m_tendon, m_over;
  Band m_superior, m_middle, m_inferior;
  Sleeve m_sleeve;
};

}  // namespace glenoid::generate
