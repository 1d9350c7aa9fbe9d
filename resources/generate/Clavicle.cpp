// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/Bones.h"
#include "resources/generate/Flesh.h"
#include "resources/generate/Relax.h"
#include "resources/generate/Superficial.h"

namespace glenoid::generate {
namespace {

constexpr double kJointSpace = 2.0;  ///< mm, acromioclavicular joint

}  // namespace

Surfaces clavicle(const Bones& bones) {
  // Ends and the lateral bend: measured landmarks times 1.0975, raised with the acromion; the medial two thirds bulge
  // forward, the lateral third backward and is flattened from above.
  const Field shaft = chain({{{62, 19, -151}, 9.5}, {{60, 20, -143}, 8.5}, {{56, 23, -127}, 6.6}, {{43, 29, -103}, 5.9},
                             {{26, 35, -78}, 5.7}, {{10, 39, -54}, 6.2}, {{-2, 41, -36}, 6.8}, {{-7.5, 42, -21}, 7.0}});
  const Field flat = stretched(chain({{{10, 39, -54}, 5.2}, {{-2, 41, -36}, 5.4}, {{-7.5, 42, -20}, 5.4}}),
                               Vec3(0, 41, -36), Vec3(1, 0, 0.35).normalized(), 1.6);
  const Field cap = sphere({63.5, 18.5, -152.5}, 10.5);
  const Field whole = smoothUnion({shaft, flat, cap}, 4);
  const Field scapula = bones.scapulaShape;
  const Field shape = [whole, scapula](const Vec3& p) { return std::max(whole(p), kJointSpace - scapula(p)); };
  TriMesh fine = largestComponent(isosurface(shape, Box3(Vec3(-30, -5, -185), Vec3(90, 65, 5)), 1.5));
  relax(fine, shape, 3);
  return {simplified(fine, 1600), simplified(fine, 80)};
}

}  // namespace glenoid::generate
