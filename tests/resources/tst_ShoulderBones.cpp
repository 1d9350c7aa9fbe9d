// SPDX-License-Identifier: GPL-3.0-or-later
// The two bones against published sizes. The lines of the table start with '|'.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/spatial/TriangleTree.h"
#include "tests/resources/Measures.h"
#include "tests/resources/ShoulderSizes.h"

namespace glenoid::test {
namespace {

double inDegrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

/// Thickness of the bone where a line first enters and last leaves it, within `reach` of a point.
double thicknessAlong(const TriangleTree& tree, const Vec3& p, const Vec3& direction, double reach) {
  const Vec3 d = direction.normalized();
  const auto down = tree.cast(p + reach * d, -d, 2 * reach), up = tree.cast(p - reach * d, d, 2 * reach);
  return down && up ? (down->point - up->point).dot(d) : 0;
}

TEST(Humerus, measuresAsPublished) {
  const Part& bone = partOf(shippedShoulder(), "humerus");
  const std::vector<Vec3> cartilage = verticesOf(bone, "head-cartilage");
  const Sphere head = fitSphere(cartilage);
  expectMeasure("humeral head radius", head.radius, "mm", {24, 2.1, "Iannotti 1992"});
  EXPECT_LT(head.centre.norm(), 1.0) << "the frame's origin is the head's centre";
  EXPECT_LT(head.rms, 0.3);
  const TriMesh surface = surfaceOf(bone, "head-cartilage");
  const Vec3 axis = (centroidOf(surface) - head.centre).normalized();
  // Archimedes: a cap of height h has the area 2πRh.
  expectMeasure("height of the head's cap", areaOf(surface) / (2 * std::numbers::pi * head.radius), "mm",
                {19, 2.4, "Iannotti 1992"});

  const Vec3 shaft = shaftAxis(*bone.visual, -215, -140);
  expectMeasure("neck-shaft angle", 180 - angleBetween(axis, shaft), "deg", {135, 5, "anatomy.md 2.3"});

  // Extreme points of the elbow to both sides; retroversion is seen along the shaft.
  Vec3 lateral = Vec3::Zero(), medial = Vec3::Zero();
  double low = 1e9, high = -1e9, top = -1e9;
  for (const Vec3& metres : bone.visual->vertices) {
    const Vec3 v = 1e3 * metres;
    if (v.y() < -260 && (lateral.isZero() || v.z() > lateral.z())) lateral = v;
    if (v.y() < -260 && (medial.isZero() || v.z() < medial.z())) medial = v;
    low = std::min(low, v.dot(shaft));
    high = std::max(high, v.dot(shaft));
    if (v.z() > 14) top = std::max(top, v.y());
  }
  const auto flat = [&](const Vec3& v) { return Vec3(v - v.dot(shaft) * shaft); };
  const Vec3 toMedial = flat(medial - lateral).normalized(), forward = shaft.cross(-toMedial);
  expectMeasure("retroversion of the head",
                inDegrees(std::atan2(-flat(axis).dot(forward), flat(axis).dot(toMedial))), "deg",
                {26, 11, "Matsumura 2014"});
  const Vec3 offset = flat(head.centre - shaftMiddle(*bone.visual, -140));
  expectMeasure("head medial of the shaft's axis", offset.dot(toMedial), "mm", tenth(6.9, "Boileau 1997"));
  expectMeasure("head behind the shaft's axis", -offset.dot(forward), "mm", tenth(2.6, "Boileau 1997"));
  expectMeasure("length of the humerus", high - low, "mm", tenth(320, "anatomy.md 2.3"));
  expectMeasure("width over the epicondyles", (lateral - medial).norm(), "mm",
                tenth(70.1, "reference x 1.0975"));
  EXPECT_LT(top, head.radius) << "the greater tubercle stays below the top of the head";
  EXPECT_GT(top, 0.55 * head.radius);
}

TEST(Humerus, grooveMeasuresAsPublished) {
  const Part& bone = partOf(shippedShoulder(), "humerus");
  double depth = 0, width = 0;
  for (const double y : {2.0, -2.0, -6.0}) {
    const GrooveCut cut = grooveAt(*bone.visual, y);
    depth += cut.depth / 3;
    width += cut.width / 3;
  }
  expectMeasure("depth of the bicipital groove", depth, "mm", {5, 0.7, "PMID 38259382"});
  expectMeasure("width of the groove at half depth", width, "mm", tenth(8, "oalib 3086089"));
  double length = 0;
  for (double y = 18; y > -34; y -= 1) length += grooveAt(*bone.visual, y).depth > 2.5;
  expectMeasure("length of the groove, at least half deep", length, "mm", {25.1, 3.3, "PMID 38259382"});
}

TEST(Scapula, glenoidMeasuresAsPublished) {
  const Part& bone = partOf(shippedShoulder(), "scapula");
  const Vec3 ts = landmark(bone, "trigonum-spinae"), ai = landmark(bone, "inferior-angle");
  const Vec3 up = (landmark(bone, "glenoid-superior") - landmark(bone, "glenoid-inferior")).normalized();
  const Vec3 across = landmark(bone, "glenoid-anterior") - landmark(bone, "glenoid-posterior");
  const Vec3 front = (across - across.dot(up) * up).normalized(), normal = front.cross(up);
  const std::vector<Vec3> socket = verticesOf(bone, "glenoid-cartilage");
  const double height = extentAlong(socket, up);
  double top = -1e9, deepest = 1e9, rim = 0;
  for (const Vec3& v : socket) top = std::max(top, v.dot(up)), deepest = std::min(deepest, v.dot(normal));
  std::vector<Vec3> upper;
  for (const Vec3& v : socket)
    if (std::abs(v.dot(up) - (top - height / 4)) < 2) upper.push_back(v);
  expectMeasure("height of the glenoid", height, "mm", {36, 4, "von Schroeder 2001"});
  expectMeasure("width of the glenoid", extentAlong(socket, front), "mm", {29, 3, "von Schroeder 2001"});
  expectMeasure("upper width of the glenoid", extentAlong(upper, front), "mm", tenth(19.5, "Chen 2023"));
  expectMeasure("radius of the glenoid, bone", fitSphere(socket).radius, "mm", {33.4, 3.3, "PMC12925909"});
  for (const char* id : {"glenoid-superior", "glenoid-inferior", "glenoid-anterior", "glenoid-posterior"})
    rim += landmark(bone, id).dot(normal) / 4;
  expectMeasure("depth of the glenoid, bone", rim - deepest, "mm", {4.0, 0.8, "PMC12925909"});

  const Vec3 axis = (landmark(bone, "glenoid-centre") - ts).normalized();
  const Vec3 bladeUp = ((ts - ai) - (ts - ai).dot(axis) * axis).normalized(), forward = bladeUp.cross(axis);
  expectMeasure("version of the glenoid", inDegrees(std::atan2(normal.dot(forward), normal.dot(axis))), "deg",
                {-8, 4, "von Schroeder 2001"});
  expectMeasure("inclination of the glenoid", inDegrees(std::atan2(normal.dot(bladeUp), normal.dot(axis))),
                "deg", {7.1, 4.1, "PMC12925909"});
  const Vec3 dorsal = -forward;
  expectMeasure("scapular plane to the coronal plane", angleBetween(dorsal, -Vec3::UnitX()), "deg",
                {35, 5, "anatomy.md 2.3"});
}

TEST(Scapula, measuresAsPublished) {
  const Part& bone = partOf(shippedShoulder(), "scapula");
  const TriMesh mesh = inMillimetres(*bone.visual);
  const TriangleTree tree(mesh);
  const Vec3 ts = landmark(bone, "trigonum-spinae"), ai = landmark(bone, "inferior-angle"),
             centre = landmark(bone, "glenoid-centre");
  expectMeasure("superior to inferior angle", (landmark(bone, "superior-angle") - ai).norm(), "mm",
                {155, 16, "von Schroeder 2001"});
  expectMeasure("trigonum to inferior angle", (ts - ai).norm(), "mm", tenth(125.1, "reference x 1.0975"));
  expectMeasure("trigonum to glenoid centre", (ts - centre).norm(), "mm", tenth(115.1, "reference x 1.0975"));
  expectMeasure("spine, trigonum to the acromion's edge", (ts - landmark(bone, "acromion-lateral")).norm(),
                "mm", {134, 12, "von Schroeder 2001"});
  const Vec3 x = (centre - ts).normalized(), y = ((ts - ai) - (ts - ai).dot(x) * x).normalized(),
             z = x.cross(y);
  const Vec3 lateral = 0.5 * (landmark(bone, "glenoid-inferior") + ai);
  double thick = 0, border = 0;
  for (double in = 1; in < 8; in += 1)
    thick = std::max(thick, thicknessAlong(tree, 0.5 * (ts + ai) + in * x, z, 20));
  expectMeasure("medial border of the blade", thick, "mm", {4, 1, "von Schroeder 2001"});
  for (double in = -12; in < 12; in += 0.5)
    border = std::max(border, thicknessAlong(tree, lateral + in * x, z, 20));
  expectMeasure("lateral border of the blade", border, "mm", tenth(8, "von Schroeder 2001"));
  // From the hollow in front to the crest behind.
  const auto spineAt = [&](double in) {
    const Cut cut = cutBy(mesh, ts + in * x, x);
    Vec3 crest = ts - 1e3 * z;
    for (const Vec3& p : cut.points)
      if ((p - ts).dot(z) > (crest - ts).dot(z) && std::abs((p - ts).dot(y)) < 40) crest = p;
    return (crest - ts).dot(z);
  };
  expectMeasure("height of the spine 1 cm from the medial edge", spineAt(10), "mm",
                tenth(7, "von Schroeder 2001"));
  expectMeasure("height of the spine 4 cm from the medial edge", spineAt(40), "mm",
                tenth(18, "von Schroeder 2001"));
  const double notch = spineAt((centre - ts).norm() - 26);
  expectMeasure("height of the spine at the notch", notch, "mm", tenth(46, "von Schroeder 2001"));
}

TEST(Scapula, processesMeasureAsPublished) {
  const Part& bone = partOf(shippedShoulder(), "scapula");
  const TriMesh mesh = inMillimetres(*bone.visual);
  const TriangleTree tree(mesh);
  const Vec3 angle = landmark(bone, "acromial-angle"), front = landmark(bone, "acromion-tip");
  const Vec3 along = (front - angle).normalized();
  const std::vector<Vec3> acromion = verticesOf(bone, "acromion"), coracoid = verticesOf(bone, "coracoid"),
                          socket = verticesOf(bone, "glenoid-cartilage");
  expectMeasure("length of the acromion", (front - angle).norm(), "mm", {48, 5, "von Schroeder 2001"});
  const Vec3 side = along.cross(Vec3::UnitY()).normalized(), up = side.cross(along);
  const Vec3 middle = 0.5 * (angle + front) - 9 * side * (side.z() > 0 ? 1 : -1);
  Cut cut = cutBy(mesh, middle, along, 22);
  std::erase_if(cut.points, [&](const Vec3& p) { return std::abs((p - middle).dot(up)) > 8; });
  expectMeasure("width of the acromion", extentAlong(cut.points, side), "mm", {22, 4, "von Schroeder 2001"});
  expectMeasure("thickness of the acromion", thicknessAlong(tree, middle, up, 14), "mm",
                {9, 1, "von Schroeder 2001"});

  const Vec3 tip = landmark(bone, "coracoid-tip");
  double gap = 1e9, toGlenoid = 1e9;
  for (const Vec3& v : acromion) {
    gap = std::min(gap, v.norm() - 24);
    for (const Vec3& rim : socket) toGlenoid = std::min(toGlenoid, (v - rim).norm());
  }
  // Free is what stands in front of the socket's upper end.
  TriMesh free;
  const TriMesh process = surfaceOf(bone, "coracoid");
  for (const auto& t : process.triangles) {
    const Vec3 p = (process.vertices[t[0]] + process.vertices[t[1]] + process.vertices[t[2]]) / 3;
    if (p.x() < landmark(bone, "glenoid-superior").x()) continue;
    const int first = int(free.vertices.size());
    for (const int v : t) free.vertices.push_back(process.vertices[v]);
    free.triangles.push_back({first, first + 1, first + 2});
  }
  const double reach = principalExtents(free).size[0];
  double toTip = 1e9;
  for (const Vec3& v : acromion) toTip = std::min(toTip, (v - tip).norm());
  Vec3 bend = tip;
  for (const Vec3& v : coracoid)
    if (v.y() > bend.y()) bend = v;
  expectMeasure("length of the coracoid's free part", reach, "mm", tenth(40.4, "Siriraj 2004"));
  const Vec3 hook = (Vec3(bend.x(), bend.y() - 5, bend.z()) - tip).normalized();
  const Cut section = cutBy(mesh, tip + 12 * hook, hook, 14);
  double widest = 0, thinnest = 1e9;
  const Vec3 u = hook.cross(Vec3::UnitZ()).normalized(), v = hook.cross(u);
  for (double a = 0; a < 180; a += 3) {
    const double r = a * std::numbers::pi / 180,
                 size = extentAlong(section.points, std::cos(r) * u + std::sin(r) * v);
    widest = std::max(widest, size);
    thinnest = std::min(thinnest, size);
  }
  expectMeasure("width of the coracoid", widest, "mm", tenth(14.6, "Siriraj 2004"));
  expectMeasure("thickness of the coracoid", thinnest, "mm", {11, 1, "von Schroeder 2001"});
  expectMeasure("acromion to humeral head", gap, "mm", {9.5, 0.95, "Petersson 1984"});
  // The source does not say between which points it measured. The shortest way from the socket's rim to the
  // roof is 16.4 mm on the scaled reference body, whose subacromial gap is 5 mm; the roof here is 4 mm higher
  // for a healthy gap.
  reportMeasure("acromion to the glenoid, shortest", toGlenoid, "mm", {16, 2, "von Schroeder 2001"},
                "the roof is raised to a healthy gap, and the source's points are not told");
  // Siriraj measured scapulae of 139 mm, this one has 167. The two landmarks cannot come as near: on the
  // scaled reference they lie 41.8 mm apart, and 43.7 mm once the acromion's tip is raised by the 3.2 mm that
  // a subacromial gap within its tolerance takes. Held within 4 mm of their places, the coracoid's tip gains
  // 4 mm straight on and the acromion's the 2.4 mm that are left to it sideways, of which 1.9 mm count: 37.8
  // mm at least, the roof's nearest vertex 2 mm less.
  reportMeasure("coracoid tip to acromion", toTip, "mm", {31, 4, "Siriraj 2004"},
                "no choice of landmarks within 4 mm meets it and the subacromial gap");
}

}  // namespace
}  // namespace glenoid::test
