#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# FCL 0.7.0 (Debian 12): computeMomentofInertia of one and the same body is that of density one for Box, and for BVHModel,
# but that of mass one for Convex. computeMomentofInertiaRelatedToCOM of Convex is then neither.
#
# The call is one virtual function of CollisionGeometry and its comment names no unit. Volume and centre of mass agree among
# the three. A bone replaced by its convex hull, its inertia multiplied by the density as for the mesh, becomes 1 / volume
# times too heavy to turn: 2083 times for the box below (metres), and too light in millimetres. About the
# centre of mass the shift is subtracted for density one from a tensor for mass one, so that almost nothing is subtracted of a
# body away from the origin, as bones in the coordinates of their scan are; dividing by the mass does not mend that.
#
# Guess before trying: right and of one convention for the mesh and the convex body, taken about the origin.
#
# Installs pinned public packages in a temporary folder, states what it saw, ends with 1 where that is no longer so.
set -euo pipefail
fcl=0.7.0-3+b1
ccd=2.1-2+b1
octomap=1.9.7+dfsg-3+b1
eigen=3.4.0-4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libfcl-dev=$fcl" "libfcl0.7=$fcl" "libccd-dev=$ccd" "libccd2=$ccd" "liboctomap-dev=$octomap" \
  "liboctomap1.9=$octomap" "libeigen3-dev=$eigen" >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done

cat >inertia.cpp <<'CODE'
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>
using V = fcl::Vector3d;
static const V half(0.02, 0.02, 0.15);
static const int corners[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
static std::vector<V> points(const V& at) {
  std::vector<V> p;
  for (int i = 0; i < 8; ++i)
    p.push_back(at + V(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z()));
  return p;
}
struct Seen {
  double volume, centre, origin, own;
};
static Seen look(const char* name, const fcl::CollisionGeometryd& g) {
  const Seen s{g.computeVolume(), g.computeCOM().x(), g.computeMomentofInertia()(2, 2),
               g.computeMomentofInertiaRelatedToCOM()(2, 2)};
  std::printf("%-20s volume %.6f  centre x %.2f  Izz about origin %.4e  about centre %.4e\n", name, s.volume, s.centre,
              s.origin, s.own);
  return s;
}
static Seen mesh(const char* name, const V& at) {
  fcl::BVHModel<fcl::OBBRSSd> m;
  std::vector<fcl::Triangle> t;
  for (const auto& c : corners) t.emplace_back(c[0], c[1], c[2]);
  m.beginModel();
  m.addSubModel(points(at), t);
  m.endModel();
  return look(name, m);
}
static Seen convex(const char* name, const V& at) {
  auto f = std::make_shared<std::vector<int>>();
  for (const auto& c : corners) f->insert(f->end(), {3, c[0], c[1], c[2]});
  return look(name, fcl::Convexd(std::make_shared<const std::vector<V>>(points(at)), 12, f));
}
static bool near(double a, double b) { return std::fabs(a - b) <= 1e-6 * std::fabs(b); }
int main() {
  const V none(0, 0, 0), away(0.2, 0, 0);
  const double volume = 8 * half.prod(), d2 = away.squaredNorm();
  const double ic = volume * (half.x() * half.x() + half.y() * half.y()) / 3;
  std::printf("expected, density 1: volume %.6f, Izz about the centre %.4e, about the origin from 0.2 m %.4e\n", volume, ic,
              ic + volume * d2);
  const Seen box = look("Box", fcl::Boxd(2 * half)), m0 = mesh("BVHModel centred", none), m1 = mesh("BVHModel at 0.2 m", away);
  const Seen c0 = convex("Convex centred", none), c1 = convex("Convex at 0.2 m", away);
  const bool density = near(box.origin, ic) && near(m0.origin, ic) && near(m1.origin, ic + volume * d2) &&
                       std::fabs(m1.own - ic) < 1e-3 * ic && near(c0.volume, volume) && near(c1.centre, 0.2);
  const bool mass = near(c0.origin, ic / volume) && near(c1.origin, ic / volume + d2) &&
                    near(c1.own, ic / volume + d2 - volume * d2);
  std::printf("seen: Box and BVHModel %s; Convex %s, about its centre at 0.2 m %.0f times its value at the origin\n",
              density ? "as of density 1" : "otherwise", mass ? "as of mass 1" : "otherwise", c1.own / c0.own);
  return density && mass ? 0 : 1;
}
CODE
library=$PWD/usr/lib/x86_64-linux-gnu
c++ -std=c++17 -O1 -I usr/include -I usr/include/eigen3 inertia.cpp -o inertia -L "$library" -l:libfcl.so.0.7 -l:libccd.so.2 \
  -Wl,-rpath-link,"$library"
echo "libfcl0.7 $fcl"
LD_LIBRARY_PATH=$library ./inertia
