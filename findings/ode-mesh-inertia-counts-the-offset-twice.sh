#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ODE 0.16.2 (Debian 12): dMassSetTrimesh gives a closed surface that does not stand on its own centre of mass an inertia
# in which the offset is counted twice: Ic + 2 m d^2 where Ic + m d^2 is right.
#
# Mass and centre are right, and so is everything for a mesh centred beforehand. Who then moves the mass to its
# centre, as dBodySetMass wants it, subtracts m d^2 once and keeps m d^2 too much, with no word: the tensor is positive
# definite and dMassCheck accepts it. dMassSetBox followed by dMassTranslate to the same place is right. A bone in the
# coordinates of its scan is far from the origin: the box below, 40 x 40 x 300 mm and 0.2 m away, turns about its long axis
# as if its inertia were some 150 times what it is.
#
# Guess before trying: the tensor is taken about the origin, offset once, so that moving it to the centre of mass gives Ic.
#
# Installs pinned public packages in a temporary folder, states what it saw, ends with 1 where that is no longer so.
set -euo pipefail
ode=2:0.16.2-1
ccd=2.1-2+b1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libode-dev=$ode" "libode8=$ode" "libccd2=$ccd" >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done

cat >inertia.cpp <<'CODE'
#include <ode/ode.h>
#include <cmath>
#include <cstdio>
static const double half[3] = {0.02, 0.02, 0.15}, density = 1800;
static const dTriIndex faces[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                    2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
static dMass ofMesh(const double* at) {
  float v[24];
  for (int i = 0; i < 24; ++i)
    v[i] = static_cast<float>(at[i % 3] + ((i / 3) >> (i % 3) & 1 ? half[i % 3] : -half[i % 3]));
  dTriMeshDataID data = dGeomTriMeshDataCreate();
  dGeomTriMeshDataBuildSingle(data, v, 3 * sizeof(float), 8, faces, 36, 3 * sizeof(dTriIndex));
  dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
  dMass m;
  dMassSetTrimesh(&m, density, mesh);
  dGeomDestroy(mesh);
  dGeomTriMeshDataDestroy(data);
  return m;
}
static dMass ofBox(const double* at) {
  dMass m;
  dMassSetBox(&m, density, 2 * half[0], 2 * half[1], 2 * half[2]);
  dMassTranslate(&m, at[0], at[1], at[2]);
  return m;
}
static bool near(double a, double b) { return std::fabs(a - b) <= 1e-4 * std::fabs(b); }
int main() {
  dInitODE();
  const double centred[3] = {0, 0, 0}, away[3] = {0.16, 0.12, 0};
  const dMass box = ofBox(away), mesh = ofMesh(away), mid = ofMesh(centred);
  const double ic = ofBox(centred).I[10], md2 = box.mass * (away[0] * away[0] + away[1] * away[1]);
  std::printf("exact: m %.4f kg, Ic %.6f, m d^2 %.6f kg m^2 (about z)\n", box.mass, ic, md2);
  std::printf("box moved 0.2 m:  m %.4f  c %.3f %.3f %.3f  Izz %.6f  Ixy %.6f\n", box.mass, box.c[0], box.c[1], box.c[2],
              box.I[10], box.I[1]);
  std::printf("mesh there:       m %.4f  c %.3f %.3f %.3f  Izz %.6f  Ixy %.6f\n", mesh.mass, mesh.c[0], mesh.c[1],
              mesh.c[2], mesh.I[10], mesh.I[1]);
  std::printf("mesh centred:     m %.4f  Izz %.6f\n", mid.mass, mid.I[10]);
  dMass moved = mesh, movedBox = box;
  dMassTranslate(&moved, -mesh.c[0], -mesh.c[1], -mesh.c[2]);
  dMassTranslate(&movedBox, -box.c[0], -box.c[1], -box.c[2]);
  std::printf("moved to its centre: box Izz %.6f, mesh Izz %.6f = %.0f times Ic; dMassCheck says %d\n", movedBox.I[10],
              moved.I[10], moved.I[10] / ic, dMassCheck(&moved));
  const bool rightElsewhere = near(box.I[10], ic + md2) && near(movedBox.I[10], ic) && near(mid.I[10], ic) &&
                              near(mesh.mass, box.mass) && near(mesh.c[0], 0.16) && near(mesh.c[1], 0.12);
  const bool twice = near(mesh.I[10], ic + 2 * md2) && near(mesh.I[1], 2 * box.I[1]) && near(moved.I[10], ic + md2) &&
                     dMassCheck(&moved) == 1;
  std::printf("expected of the mesh: Izz %.6f; seen: the offset counted %s\n", ic + md2, twice ? "twice" : "otherwise");
  return rightElsewhere && twice ? 0 : 1;
}
CODE
library=$PWD/usr/lib/x86_64-linux-gnu
c++ -std=c++17 -O1 -I usr/include inertia.cpp -o inertia -L "$library" -l:libode.so.8 -Wl,-rpath,"$library" \
  -Wl,-rpath-link,"$library"
echo "libode8 $ode"
LD_LIBRARY_PATH=$library ./inertia
