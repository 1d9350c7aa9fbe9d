// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of capsule, glenohumeral ligaments, teres minor and portals, made round the bones that ship, against
// what is published of them. The lines of the table start with '|'.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "resources/generate/Bones.h"
#include "resources/generate/capsule/Capsule.h"
#include "resources/generate/capsule/Portals.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/spatial/TriangleTree.h"
#include "tests/resources/Measures.h"
#include "tests/resources/ShoulderSizes.h"

namespace glenoid::test {
namespace {

using generate::Bones;
using generate::CapsuleShapes;
using generate::Surfaces;

TriMesh visualOf(const char* id) {
  return inMillimetres(*partOf(shippedShoulder(), id).visual);
}

/// The bones that ship; making them anew takes half a minute.
const Bones& bones() {
  static const Bones made = [] {
    Bones b;
    b.humerusShape = generate::humerus::field(), b.scapulaShape = generate::scapula::field();
    b.humerus = {visualOf("humerus"), inMillimetres(*partOf(shippedShoulder(), "humerus").collision)};
    b.scapula = {visualOf("scapula"), inMillimetres(*partOf(shippedShoulder(), "scapula").collision)};
    b.humerusCoarse = generate::fieldOf(b.humerus.collision),
    b.scapulaCoarse = generate::fieldOf(b.scapula.collision);
    return b;
  }();
  return made;
}

const CapsuleShapes& shapes() {
  static const CapsuleShapes made = [] {
    generate::Field over = generate::fieldOf(visualOf("supraspinatus"));
    for (const char* id : {"infraspinatus", "subscapularis", "coracohumeral-ligament"})
      over = generate::unionOf(over, generate::fieldOf(visualOf(id)));
    return CapsuleShapes(bones(), {visualOf("labrum"), visualOf("labrum-tendon"), visualOf("biceps-tendon")}, over);
  }();
  return made;
}

void expectSound(const char* name, const Surfaces& surfaces, int genus) {
  for (const TriMesh* mesh : {&surfaces.visual, &surfaces.collision}) {
    const MeshHealth health = healthOf(*mesh);
    EXPECT_TRUE(health.healthy()) << name;
    EXPECT_EQ(health.components, 1) << name;
    EXPECT_EQ(health.genus, genus) << name;
    EXPECT_EQ(countSelfIntersections(*mesh), 0) << name;
  }
}

/// Middle of a stretch of a ligament's sheet near one end of it.
Vec3 middleOf(const TriMesh& visual, const std::vector<Region>& regions, const std::string& id) {
  Part part;
  part.visual = std::make_shared<TriMesh>(visual);
  for (const Region& region : regions)
    if (region.id == id) {
      Vec3 sum = Vec3::Zero();
      double area = 0;
      for (const int t : trianglesOf(region)) {
        const auto& v = visual.triangles[t];
        const Vec3 &a = visual.vertices[v[0]], &b = visual.vertices[v[1]], &c = visual.vertices[v[2]];
        const double twice = (b - a).cross(c - a).norm();
        sum += twice * (a + b + c) / 3, area += twice;
      }
      return sum / area;
    }
  return Vec3::Constant(1e9);
}

TEST(CapsuleShapes, areClosedAndDoNotCutThemselves) {
  expectSound("capsule", shapes().capsule(), 1);  // a sleeve is a ring
  expectSound("superior glenohumeral ligament", shapes().superior(), 0);
  expectSound("middle glenohumeral ligament", shapes().middle(), 0);
  expectSound("inferior glenohumeral ligament", shapes().inferior(), 0);
}

TEST(CapsuleShapes, capsuleIsAThinSleeveBetweenTheBones) {
  const TriMesh wall = shapes().capsule().visual;
  const MeshHealth health = healthOf(wall);
  // The reference body's shell holds 2105 mm3 between two sides 0.47 mm apart; its area times 1.0975 squared.
  expectMeasure("capsule, area of one side", health.area / 2, "mm2",
                {5390, 1080, "anatomy.json x 1.0975, a fifth"});
  expectMeasure("capsule, thickness", 2 * health.volume / health.area, "mm",
                {2.25, 0.75, "anatomy.md 1: 1.5 to 3"});
  const TriangleTree scapula(bones().scapula.visual), humerus(bones().humerus.visual);
  int inBone = 0;
  for (const Vec3& p : wall.vertices) inBone += scapula.inside(p) || humerus.inside(p);
  EXPECT_LE(inBone, int(wall.vertices.size() / 100));
}

TEST(CapsuleShapes, capsuleHangsInAPouchWhileTheArmHangs) {
  const TriMesh wall = shapes().capsule().visual;
  double lowest = 0;
  for (const Vec3& p : wall.vertices) lowest = std::min(lowest, p.y());
  const double rim = landmark(partOf(shippedShoulder(), "scapula"), "glenoid-inferior").y();
  expectMeasure("axillary pouch, below the glenoid's lower end", rim - lowest, "mm",
                {13, 6, "redundant in adduction"});
}

TEST(CapsuleShapes, ligamentsRunBetweenThePlacesOfTheReferenceBody) {
  struct Row {
    const char* id;
    Surfaces surfaces;
    Vec3 scapula, humerus;
    double length;
  };
  // Ends and lengths of the reference body times 1.0975.
  const Row rows[] = {{"superior", shapes().superior(), {-4.5, 15.7, -27.0}, {21.1, 9.8, 0}, 40.5},
                      {"middle", shapes().middle(), {0.5, 8.5, -30.0}, {23.3, 3.4, -4.6}, 36.2}};
  for (const Row& row : rows) {
    const std::vector<Region> regions = shapes().ligamentRegions(row.surfaces.visual, row.id);
    const std::string name = std::string(row.id) + " glenohumeral ligament";
    expectMeasure(name + ", end at the labrum from its place",
                  (middleOf(row.surfaces.visual, regions, "glenoid-end") - row.scapula).norm(), "mm",
                  {0, 9, "anatomy.md 2.6"});
    expectMeasure(name + ", end on the humerus from its place",
                  (middleOf(row.surfaces.visual, regions, "humeral-end") - row.humerus).norm(), "mm",
                  {0, 9, "anatomy.md 2.6"});
    const Extents extents = principalExtents(row.surfaces.visual);
    expectMeasure(name + ", length", extents.size[0], "mm",
                  {row.length, 0.2 * row.length, "anatomy.md 2.6 x 1.0975, a fifth"});
    expectMeasure(name + ", width", extents.size[1], "mm", {13, 4, "anatomy.md 2.6 x 1.0975"});
  }
  const MeshHealth hammock = healthOf(shapes().inferior().visual);
  expectMeasure("inferior glenohumeral ligament, thickness", 2 * hammock.volume / hammock.area, "mm",
                {1.5, 0.5, "with the wall 1.5 to 3"});
}

TEST(TeresMinor, measuresAsPublished) {
  const TriMesh above = visualOf("infraspinatus");
  const Surfaces muscle = generate::teresMinor(bones(), above);
  expectSound("teres minor", muscle, 0);
  expectMeasure("teres minor, volume", enclosedVolume(muscle.visual) / 1e3, "cm3",
                {37.5, 12.5, "anatomy.md 2.3 (25 to 30), 2.4 x 1.32 (50)"});
  expectMeasure("teres minor, length", principalExtents(muscle.visual).size[0], "mm",
                {156, 31, "anatomy.md 2.4 x 1.0975, a fifth"});
  const TriangleTree infraspinatus(above);
  int inside = 0;
  for (const Vec3& p : muscle.visual.vertices) inside += infraspinatus.inside(p);
  EXPECT_EQ(inside, 0);
}

Vec3 portal(const char* id) {
  for (const Landmark& l : generate::portals())
    if (l.id == id) return 1e3 * l.position_W;
  return Vec3::Constant(1e9);
}

TEST(Portals, lieWhereTheyAreCut) {
  const Part& scapula = partOf(shippedShoulder(), "scapula");
  const Vec3 angle = landmark(scapula, "acromial-angle"), posterior = portal("portal-posterior");
  expectMeasure("posterior portal, below the acromial angle", angle.y() - posterior.y(), "mm",
                {20, 10, "PMC7695594 and others: 15 to 30"});
  expectMeasure("posterior portal, medial of it", angle.z() - posterior.z(), "mm",
                {15, 5, "the same: 10 to 20"});
  const Vec3 anterior = portal("portal-anterior"), tip = landmark(scapula, "coracoid-tip");
  EXPECT_GT(anterior.z(), tip.z()) << "lateral of the coracoid";
  EXPECT_LT((anterior - tip).norm(), 25);
  const Vec3 lateral = portal("portal-lateral"), edge = landmark(scapula, "acromion-lateral");
  expectMeasure("lateral portal, below the side edge of the acromion", edge.y() - lateral.y(), "mm",
                {25, 10, "20 to 30"});
  EXPECT_GT(lateral.z(), edge.z() + 20);
}

TEST(Portals, theWayIntoTheJointIsFreeOfBone) {
  const Part& scapula = partOf(shippedShoulder(), "scapula");
  const Vec3 centre = landmark(scapula, "glenoid-centre"), top = landmark(scapula, "glenoid-superior"),
             bottom = landmark(scapula, "glenoid-inferior");
  const Vec3 up = (top - bottom).normalized(),
             out = (-centre).normalized();  // the head's centre is the origin
  const TriangleTree both[] = {TriangleTree(bones().scapula.visual), TriangleTree(bones().humerus.visual)};
  const Vec3 forward =
      (landmark(scapula, "glenoid-anterior") - landmark(scapula, "glenoid-posterior")).normalized();
  // From behind to the middle of the upper gap; from in front, past the head, to its front.
  const std::pair<const char*, Vec3> ways[] = {{"portal-posterior", centre + 3 * out + 12 * up},
                                               {"portal-anterior", centre + 6 * out + 12 * up + 6 * forward}};
  for (const auto& [id, gap] : ways) {
    const Vec3 way = gap - portal(id);
    for (const TriangleTree& bone : both)
      EXPECT_FALSE(bone.cast(portal(id), way.normalized(), way.norm()).has_value()) << id;
  }
}

}  // namespace
}  // namespace glenoid::test
