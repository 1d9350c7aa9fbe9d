// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "resources/generate/Bones.h"
#include "resources/generate/Coarse.h"
#include "resources/generate/Flesh.h"
#include "resources/generate/Parts.h"
#include "simcore/shape/Relax.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::generate {

namespace {

/// Where something lies on the bone: on the head and the tubercles the socket and the cuff, in the groove the
/// biceps tendon; the shaft and the elbow touch nothing.
double onHumerus(const Vec3& p) {
  if (p.y() < -50) return 0.01;
  if (p.y() < -22) return 0.1;
  double toGroove = 1e9;
  for (const Vec3& floor : humerus::groovePath()) toGroove = std::min(toGroove, (p - floor).norm());
  return toGroove < 7 ? 1.5 : 1;
}

/// The socket with its rim, under the acromion, and less what only muscles grow from.
Importance onScapula() {
  return [socket = scapula::glenoid(), rim = scapula::glenoidRim(),
          roof = scapula::acromionField()](const Vec3& p) {
    const Vec3 q = socket.toLocal(p);
    if (q.z() > -3 && polygonDistance(rim, q.head<2>()) < 1.5) return 1.0;
    return roof(p) < 2 ? 0.3 : 0.01;
  };
}

/// What is looked at closely gets more triangles, but nothing is left as coarse as for contact.
Importance seen(const Importance& touched) {
  return [touched](const Vec3& p) { return std::max(touched(p), 0.4); };
}

Bones madeBones();

}  // namespace

Field fieldOf(const TriMesh& closed) {
  const auto tree = std::make_shared<const TriangleTree>(closed);
  return [tree](const Vec3& p) { return tree->signedDistance(p); };
}

const Bones& makeBones() {
  static const Bones made = madeBones();
  return made;
}

namespace {

Bones madeBones() {
  Bones bones;
  bones.humerusShape = humerus::field();
  bones.scapulaShape = scapula::field();
  const auto fine = [](const Field& shape, const Box3& box, double h) {
    TriMesh mesh = largestComponent(isosurface(shape, box, h));
    relax(mesh, shape, 3);
    return mesh;
  };
  const TriMesh humerusFine = fine(bones.humerusShape, Box3(Vec3(-45, -320, -40), Vec3(45, 40, 105)), 1.6);
  const TriMesh scapulaFine = fine(bones.scapulaShape, Box3(Vec3(-100, -155, -130), Vec3(45, 60, 25)), 1.3);
  bones.humerus.visual = thinned(humerusFine, 5188, seen(onHumerus));
  bones.humerus.collision = coarseOf(bones.humerus.visual, bones.humerusShape, 116, onHumerus);
  bones.scapula.visual = thinned(scapulaFine, 10224, seen(onScapula()));
  bones.scapula.collision = coarseOf(bones.scapula.visual, bones.scapulaShape, 110, onScapula());
  bones.humerusCoarse = fieldOf(bones.humerus.collision);
  // Coarse triangles fill the socket a little: it keeps off the head, at least as far as the labrum's edge
  // needs.
  keepClear(bones.scapula.collision, bones.humerusCoarse, 1.8);
  bones.scapulaCoarse = fieldOf(bones.scapula.collision);
  return bones;
}

}  // namespace

}  // namespace glenoid::generate
