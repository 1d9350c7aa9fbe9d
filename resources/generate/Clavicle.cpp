// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/Bones.h"
#include "resources/generate/Flesh.h"
#include "resources/generate/Superficial.h"
#include "simcore/shape/Relax.h"

namespace glenoid::generate {
namespace {

constexpr double kJointSpace = 2.0;  ///< mm, acromioclavicular joint

}  // namespace

Surfaces clavicle(const Bones& bones) {
  // Lateral end and bend: measured landmarks times 1.0975, raised with the acromion; the scaled medial end
  // lies 15 mm farther in than a clavicle of the published length reaches. The medial two thirds bulge
  // forward, the lateral third backward and is flattened from above.
  const Field shaft = chain({{{56.5, 21, -138}, 9},
                             {{56, 21.7, -131}, 8.4},
                             {{52.5, 25, -116}, 6.8},
                             {{41.5, 30, -98}, 5.9},
                             {{25, 35, -77}, 5.7},
                             {{8.5, 39, -54}, 5.8},
                             {{-3, 41, -36}, 5.7},
                             {{-7.5, 42, -21}, 5.5}});
  // Drawn out forward and backward; its knots are placed so that they come to lie on the shaft's line.
  constexpr double kWider = 1.9;
  const Vec3 middle(-3, 41, -36), forward = Vec3(1, 0, 0.35).normalized();
  const auto drawnTo = [&](const Vec3& p) {
    return Vec3(p - (1 - 1 / kWider) * (p - middle).dot(forward) * forward);
  };
  const Field flat = stretched(chain({{drawnTo({25, 35, -77}), 1.6},
                                      {drawnTo({8.5, 39, -54}), 3.6},
                                      {drawnTo({-3, 41, -36}), 4.9},
                                      {drawnTo({-7.5, 42, -20}), 5.3}}),
                               middle, forward, kWider);
  const Field cap = sphere({56.5, 20.7, -139.5}, 9.4);
  const Field whole = smoothUnion({shaft, flat, cap}, 4);
  const Field scapula = bones.scapulaShape;
  const Field shape = [whole, scapula](const Vec3& p) {
    return std::max(whole(p), kJointSpace - scapula(p));
  };
  TriMesh fine = largestComponent(isosurface(shape, Box3(Vec3(-30, -5, -185), Vec3(90, 65, 5)), 1.5));
  relax(fine, shape, 3);
  return {simplified(fine, 1600), simplified(fine, 80)};
}

}  // namespace glenoid::generate
