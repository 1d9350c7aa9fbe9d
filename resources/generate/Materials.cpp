// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/Materials.h"

namespace glenoid::generate {

namespace {

constexpr double kMPa = 1e6;
const char* const kScaled =
    "A tool pushes with a few newtons through a coupling of some hundred N/m: tissue much stiffer than this "
    "feels the "
    "same in the hand and only spoils the conditioning of coarse elements. The order of the tissues is kept.";

Material tissue(const char* id, const char* name, Appearance appearance, double density, double literature, double used,
                double poisson, const char* source) {
  Material m;
  m.id = id;
  m.name = name;
  m.appearance = appearance;
  m.density = density;
  m.youngsModulus = used * kMPa;
  m.poissonRatio = poisson;
  m.friction = 0.01;
  m.stiffnessDamping = 1e-3;
  m.source = source;
  if (literature != used) {
    m.literatureYoungsModulus = literature * kMPa;
    m.reason = kScaled;
  }
  return m;
}

}  // namespace

std::vector<Material> shoulderMaterials() {
  std::vector<Material> list{
      tissue("cortical-bone", "Cortical bone", Appearance::Bone, 1900, 15000, 15000, 0.3,
             "Couteau 2001 (scapula 16 GPa), Clavert 2006 (humerus 12 GPa)"),
      tissue("cartilage", "Articular cartilage", Appearance::Cartilage, 1100, 10, 10, 0.4,
             "Büchler 2002, neo-Hookean C10 = 1.79 MPa"),
      tissue("muscle-relaxed", "Muscle, relaxed", Appearance::Muscle, 1060, 0.025, 0.025, 0.45,
             "Shear-wave speed 2.2–3.3 m/s of the deltoid at rest; density Ward and Lieber 2005"),
      tissue("cuff-tendon", "Tendon of the rotator cuff", Appearance::Tendon, 1120, 200, 5, 0.45,
             "Matsuhashi 2014 (592 and 218 MPa); Cronje 2025 (60–67 MPa)"),
      tissue("coracoacromial", "Coracoacromial ligament", Appearance::Ligament, 1120, 100, 4, 0.45,
             "Soslowsky 1996; modulus from 80 N/mm, 34 mm, 25 mm²"),
      tissue("coracohumeral", "Coracohumeral ligament", Appearance::Ligament, 1120, 30, 3.5, 0.45,
             "Boardman 1996, 36.7 N/mm; modulus from 40 mm, 50 mm²"),
      tissue("transverse-humeral", "Transverse humeral ligament", Appearance::Ligament, 1120, 30, 30, 0.45,
             "As the coracohumeral ligament; the part is rigid"),
      tissue("labrum", "Glenoid labrum", Appearance::Cartilage, 1100, 25, 3, 0.4,
             "Smith 2008, J Anat 212:49 (22.8 ± 11.4 MPa in tension)"),
      tissue("biceps-anchor", "Biceps anchor", Appearance::Tendon, 1120, 60, 3, 0.45, "As the biceps tendon"),
      tissue("biceps-tendon", "Tendon of the long head of the biceps", Appearance::Tendon, 1120, 60, 60, 0.45,
             "Hohmann 2019 (fresh-frozen 55.3 MPa); the part is rigid"),
  };
  for (Material& m : list)
    if (m.id == "muscle-relaxed") {
      m.literatureYoungsModulus = 0.025 * kMPa;
      m.reason =
          "The modulus is the literature's. Poisson's ratio is 0.45 instead of 0.49, because linear "
          "tetrahedra lock near 0.5.";
    }
  return list;
}

std::vector<MaterialUse> materialsOf(const std::string& id) {
  if (id == "scapula") return {{"cortical-bone", ""}, {"cartilage", "glenoid-cartilage"}};
  if (id == "humerus") return {{"cortical-bone", ""}, {"cartilage", "head-cartilage"}};
  if (id == "supraspinatus" || id == "infraspinatus" || id == "subscapularis" || id == "teres-minor")
    return {{"muscle-relaxed", ""}, {"cuff-tendon", "tendon"}};
  if (id == "coracoacromial-ligament") return {{"coracoacromial", ""}};
  if (id == "coracohumeral-ligament") return {{"coracohumeral", ""}};
  if (id == "transverse-humeral-ligament") return {{"transverse-humeral", ""}};
  if (id == "labrum") return {{"labrum", ""}};
  if (id == "labrum-tendon") return {{"biceps-anchor", ""}};
  return {{"biceps-tendon", ""}};
}

}  // namespace glenoid::generate
