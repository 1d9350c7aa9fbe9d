// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/mesh/Cleanup.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/repair/Diagnose.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

using shapes::box;
using shapes::joined;
using shapes::sphere;

TriMesh shifted(TriMesh mesh, const Vec3& by) {
  for (Vec3& v : mesh.vertices) v += by;
  return mesh;
}

/// Repairs and answers the mesh; the change of the last step goes to `change`.
TriMesh mended(const TriMesh& mesh, const std::vector<RepairStep>& steps, RepairChange* change = nullptr) {
  auto outcome = repair(mesh, steps);
  EXPECT_TRUE(outcome.ok()) << (outcome ? "" : toLogLine(outcome.error()));
  if (!outcome) return {};
  EXPECT_EQ(outcome->changes.size(), steps.size());
  if (change) *change = outcome->changes.back();
  return std::move(outcome->mesh);
}

TEST(Repair, aSoundSurfaceStaysAsItIs) {
  const TriMesh ball = sphere(0.07);
  for (const RepairKind kind : {RepairKind::Weld, RepairKind::DropDegenerate, RepairKind::DropDuplicates, RepairKind::SplitNonManifold, RepairKind::Orient,
                                RepairKind::Outwards, RepairKind::FillHoles, RepairKind::KeepLargest, RepairKind::DropSmall, RepairKind::DropSheets,
                                RepairKind::RemoveSelfIntersections}) {
    RepairChange change;
    EXPECT_EQ(mended(ball, {{kind}}, &change), ball) << repairName(kind);
    EXPECT_EQ(change.changed, 0) << repairName(kind);
    EXPECT_EQ(change.left, 0) << repairName(kind);
  }
}

TEST(Repair, weldJoinsWithinItsDistanceOnly) {
  TriMesh soup;
  const TriMesh whole = box({0, 0, 0}, {1, 1, 1});
  for (const auto& t : whole.triangles)
    for (const int v : t) soup.vertices.push_back(whole.vertices[v] + Vec3::Constant(1e-5 * static_cast<double>(soup.vertices.size() % 3)));
  for (int i = 0; i < 36; i += 3) soup.triangles.push_back({i, i + 1, i + 2});
  EXPECT_EQ(healthOf(mended(soup, {{RepairKind::Weld, 1e-4}})).openEdges, 0);
  EXPECT_GT(healthOf(mended(soup, {{RepairKind::Weld, 1e-7}})).openEdges, 0);
  RepairChange change;
  mended(soup, {{RepairKind::Weld, 1e-4}}, &change);
  EXPECT_EQ(change.changed, 28);
}

TEST(Repair, flatFacesGoWithoutLeavingCracks) {
  // A needle: a vertex doubled along an edge; a cap: a point on the side of its neighbour.
  TriMesh ball = sphere(0.07);
  const int extra = static_cast<int>(ball.vertices.size());
  const auto t = ball.triangles[500];
  ball.vertices.push_back((ball.vertices[t[0]] + ball.vertices[t[1]]) / 2);
  // The triangle gets the point on its side, a flat face fills the crack to the neighbour.
  ball.triangles[500] = {t[0], extra, t[2]};
  ball.triangles.push_back({extra, t[1], t[2]});
  ball.triangles.push_back({t[0], t[1], extra});
  ASSERT_EQ(healthOf(ball).openEdges, 0);
  ASSERT_EQ(healthOf(ball).degenerateTriangles, 1);
  RepairChange change;
  const TriMesh mendedBall = mended(ball, {{RepairKind::DropDegenerate}}, &change);
  EXPECT_TRUE(healthOf(mendedBall).healthy());
  EXPECT_EQ(change.changed, 1);
  EXPECT_EQ(change.left, 0);
  EXPECT_NEAR(enclosedVolume(mendedBall), enclosedVolume(ball), 1e-12);
}

TEST(Repair, aSurfaceOfTwoSidesKeepsOneAndAFinGoes) {
  // A disc of n triangles, each in both directions; between two cones that meet at its rim it is a wall inside a body.
  const int n = 24;
  TriMesh disc;
  for (int i = 0; i < n; ++i) disc.vertices.push_back({std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 0});
  disc.vertices.insert(disc.vertices.end(), {Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)});
  TriMesh cones = disc;
  for (int i = 0; i < n; ++i) {
    disc.triangles.push_back({n, i, (i + 1) % n});
    disc.triangles.push_back({n, (i + 1) % n, i});
    cones.triangles.push_back({n + 1, i, (i + 1) % n});
    cones.triangles.push_back({n + 2, (i + 1) % n, i});
  }
  RepairChange change;
  const TriMesh one = mended(disc, {{RepairKind::DropDuplicates}, {RepairKind::Orient}}, &change);
  EXPECT_EQ(one.triangles.size(), static_cast<std::size_t>(n));
  const SurfaceDiagnosis found = diagnose(one);
  EXPECT_TRUE(std::any_of(found.findings.begin(), found.findings.end(), [](const Finding& f) { return f.kind == FindingKind::Sheets; }));
  EXPECT_EQ(found.shells, 1);
  TriMesh walled = cones;
  walled.triangles.insert(walled.triangles.end(), disc.triangles.begin(), disc.triangles.end());
  const TriMesh free = mended(walled, {{RepairKind::DropDuplicates}});
  EXPECT_EQ(free.triangles.size(), cones.triangles.size());
  EXPECT_TRUE(healthOf(free).healthy());
  // A closed surface twice, the second time inside out, encloses as much as one of them.
  TriMesh twice = cones, back = reversed(cones);
  twice.triangles.insert(twice.triangles.end(), back.triangles.begin(), back.triangles.end());
  const TriMesh single = mended(twice, {{RepairKind::DropDuplicates}, {RepairKind::Orient}, {RepairKind::Outwards}});
  EXPECT_TRUE(healthOf(single).healthy());
  EXPECT_NEAR(enclosedVolume(single), enclosedVolume(cones), 1e-12);
}

TEST(Repair, contraryWindingsAndInsideOutShells) {
  TriMesh wrong = reversed(sphere(0.07));
  for (int t = 0; t < 600; t += 3) std::swap(wrong.triangles[t][0], wrong.triangles[t][2]);
  EXPECT_TRUE(healthOf(mended(wrong, {{RepairKind::Orient}, {RepairKind::Outwards}})).healthy());
  // A cavity is turned inwards, a part in it outwards again.
  const TriMesh nested = mended(joined(joined(reversed(sphere(0.07)), sphere(0.05)), sphere(0.02)), {{RepairKind::Outwards}});
  const double v = enclosedVolume(sphere(1));
  EXPECT_NEAR(enclosedVolume(nested), v * (std::pow(0.07, 3) - std::pow(0.05, 3) + std::pow(0.02, 3)), 1e-9);
}

TEST(Repair, aMoebiusBandIsSaidToBeLeft) {
  TriMesh band;
  const int n = 24;
  for (int i = 0; i < n; ++i) {
    const double u = 2 * M_PI * i / n;
    for (const double s : {-0.01, 0.01}) band.vertices.push_back({(0.05 + s * std::cos(u / 2)) * std::cos(u), s * std::sin(u / 2), (0.05 + s * std::cos(u / 2)) * std::sin(u)});
  }
  for (int i = 0; i < n; ++i) {
    const bool last = i == n - 1;
    const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : 2 * i + 2, d = last ? 0 : 2 * i + 3;
    band.triangles.push_back({a, c, b});
    band.triangles.push_back({b, c, d});
  }
  RepairChange change;
  mended(band, {{RepairKind::Orient}}, &change);
  EXPECT_GT(change.left, 0);
}

TEST(Repair, holesAreFilledUpToALength) {
  TriMesh open = sphere(0.07);
  std::vector<std::array<int, 3>> kept;
  for (const auto& t : open.triangles) {
    const Vec3 middle = (open.vertices[t[0]] + open.vertices[t[1]] + open.vertices[t[2]]) / 3;
    if ((middle - Vec3(0.07, 0, 0)).norm() > 0.02 && (middle - Vec3(-0.07, 0, 0)).norm() > 0.008) kept.push_back(t);
  }
  open.triangles = kept;
  const long before = diagnose(open).holes;
  ASSERT_EQ(before, 2);
  RepairChange change;
  const TriMesh one = mended(open, {{RepairKind::FillHoles, 0.08}}, &change);
  EXPECT_EQ(change.changed, 1);
  EXPECT_EQ(change.left, 1);
  EXPECT_NEAR(change.measure, 2 * M_PI * 0.02, 0.03);
  EXPECT_FALSE(healthOf(one).closed());
  const TriMesh all = mended(open, {{RepairKind::FillHoles}}, &change);
  EXPECT_EQ(change.changed, 2);
  EXPECT_TRUE(healthOf(all).healthy());
  EXPECT_NEAR(enclosedVolume(all), enclosedVolume(sphere(0.07)), 0.01 * enclosedVolume(all));
}

TEST(Repair, bodiesThatTouchComeApart) {
  for (const Vec3& at : {Vec3(50, 50, 0), Vec3(50, 50, 50)}) {
    const TriMesh touching = weldVertices(joined(box({0, 0, 0}, {50, 50, 50}), box(at, at + Vec3::Constant(50))), 0);
    ASSERT_FALSE(healthOf(touching).manifold());
    const TriMesh apart = mended(touching, {{RepairKind::SplitNonManifold}});
    EXPECT_TRUE(healthOf(apart).healthy());
    EXPECT_EQ(healthOf(apart).components, 2);
    EXPECT_EQ(apart.triangles.size(), touching.triangles.size());
  }
}

TEST(Repair, finsAndFlapsAreFreedAndDropped) {
  // A triangle that stands on an edge of a ball, once alone and once with its back.
  for (const bool twoSided : {false, true}) {
    TriMesh ball = sphere(0.07);
    const auto t = ball.triangles[500];
    const int tip = static_cast<int>(ball.vertices.size());
    ball.vertices.push_back(1.2 * ball.vertices[t[0]]);
    ball.triangles.push_back({t[0], t[1], tip});
    if (twoSided) ball.triangles.push_back({t[1], t[0], tip});
    const SurfaceDiagnosis d = diagnose(ball);
    ASSERT_TRUE(d.find(FindingKind::NonManifoldEdges)) << twoSided;
    const TriMesh clean = mended(ball, automaticRepairs(d));
    EXPECT_TRUE(healthOf(clean).healthy()) << twoSided;
    EXPECT_EQ(clean.triangles.size(), sphere(0.07).triangles.size()) << twoSided;
  }
}

TEST(Repair, duplicatesGo) {
  TriMesh ball = sphere(0.07);
  ball.triangles.push_back(ball.triangles[7]);
  ball.triangles.push_back({ball.triangles[9][1], ball.triangles[9][0], ball.triangles[9][2]});
  const TriMesh clean = mended(ball, {{RepairKind::DropDuplicates}});
  EXPECT_EQ(healthOf(clean).triangles, healthOf(sphere(0.07)).triangles);
  EXPECT_TRUE(healthOf(mended(ball, automaticRepairs(diagnose(ball)))).healthy());
}

TEST(Repair, piecesAreChosen) {
  const TriMesh three = joined(joined(sphere(0.01), sphere(0.07)), shifted(sphere(0.0005), {0.1, 0, 0}));
  RepairChange change;
  EXPECT_EQ(healthOf(mended(three, {{RepairKind::DropSmall, 0.001}}, &change)).components, 2);
  EXPECT_EQ(change.changed, 1);
  EXPECT_EQ(healthOf(mended(three, {{RepairKind::KeepLargest}})).components, 1);
  const auto shells = shellsOf(three);
  ASSERT_EQ(shells.size(), 3u);
  EXPECT_EQ(shells[0], sphere(0.07));
  EXPECT_EQ(shells[2], shifted(sphere(0.0005), {0.1, 0, 0}));
  const TriMesh two = joined(shifted(sphere(0.01), {-0.2, 0, 0}), shifted(sphere(0.01), {0.2, 0, 0}));
  EXPECT_LT(boundsOf(mended(two, {{RepairKind::KeepSide, 0, 0, false}})).max().x(), 0);
  EXPECT_GT(boundsOf(mended(two, {{RepairKind::KeepSide, 0, 0, true}})).min().x(), 0);
  const auto across = repair(two, {{RepairKind::KeepSide, 0, 1, true}});
  ASSERT_FALSE(across.ok());
  EXPECT_EQ(across.error().fault, Fault::BadMesh);
}

TEST(Repair, selfIntersectionsAreCutOutWhereThatIsPossible) {
  // A few points of a ball pulled over their neighbours, as a scanner's software folds a surface.
  TriMesh ball = sphere(0.07, 32, 21);
  for (std::size_t v = 40; v < ball.vertices.size(); v += 97) ball.vertices[v] += Vec3(0.02, -0.025, 0.02);
  const long before = diagnose(ball).selfIntersections;
  ASSERT_GT(before, 0);
  RepairChange change;
  const TriMesh clean = mended(ball, {{RepairKind::RemoveSelfIntersections}}, &change);
  EXPECT_EQ(change.changed + change.left, before);
  EXPECT_EQ(change.left, 0);
  EXPECT_TRUE(healthOf(clean).healthy());
  EXPECT_EQ(diagnose(clean).selfIntersections, 0);
}

TEST(Repair, axesAndUnitsPlaceASurface) {
  const auto map = axisMapFrom({"-y", "z", "-x"});
  ASSERT_TRUE(map.ok());
  const TriMesh from = box({100, 10, 1000}, {110, 30, 1030});
  const TriMesh to = placed(from, 1e-3, *map, {0, -1, 0});
  EXPECT_TRUE(healthOf(to).healthy());
  EXPECT_LT((boundsOf(to).min() - Vec3(-0.03, 0, -0.11)).norm(), 1e-12);
  EXPECT_LT((boundsOf(to).max() - Vec3(-0.01, 0.03, -0.1)).norm(), 1e-12);
  // A map that mirrors keeps the outside outside.
  EXPECT_TRUE(healthOf(placed(from, 1, *axisMapFrom({"-x", "y", "z"}), Vec3::Zero())).healthy());
  EXPECT_TRUE(healthOf(mended(from, {{RepairKind::Mirror, 0, 2}, {RepairKind::Scale, 1e-3}})).healthy());
  for (const std::array<std::string, 3>& wrong : {std::array<std::string, 3>{"x", "x", "z"}, {"x", "y", "w"}, {"x", "y", ""}, {"x", "y", "--z"}})
    EXPECT_FALSE(axisMapFrom(wrong).ok());
}

TEST(Repair, stepsAreWords) {
  for (const char* word : {"weld", "weld=0.001", "dropDegenerate", "dropDuplicates", "splitNonManifold", "orient", "outwards", "fillHoles", "fillHoles=0.05",
                           "keepLargest", "dropSmall=0.02", "dropSheets", "keepSide=-x", "keepSide=+z", "removeSelfIntersections", "thicken=0.002",
                           "scale=0.0254", "mirror=y", "thicken=1mm", "weld=0.05mm", "fillHoles=2cm", "weld=10um", "thicken=0.1inch",
                           "fillHoles=0.5m", "fillHoles=0.5ft", "wrap", "wrap=2mm"}) {
    const auto step = repairStepFrom(word);
    ASSERT_TRUE(step.ok()) << word;
    EXPECT_EQ(toWord(*step), word);
  }
  for (const char* word : {"", "wield", "weld=", "weld=-1", "weld=nan", "thicken", "orient=1", "keepSide=x", "mirror=-x", "mirror", "thicken=mm", "thicken=1mil",
                           "thicken=1 mm", "thicken=-1mm", "dropSmall=0.1mm", "scale=2mm", "weld=1mmm"}) {
    const auto step = repairStepFrom(word);
    ASSERT_FALSE(step.ok()) << word;
    EXPECT_EQ(step.error().fault, Fault::BadUsage) << word;
  }
}

TEST(Repair, whatCannotBeDoneIsAFault) {
  TriMesh bad = sphere(0.07);
  bad.triangles[3][1] = -1;
  EXPECT_EQ(repair(bad, {}).error().fault, Fault::BadIndex);
  bad = sphere(0.07);
  bad.vertices[3].y() = HUGE_VAL;
  EXPECT_EQ(repair(bad, {}).error().fault, Fault::NotFinite);
  EXPECT_EQ(repair(sphere(0.07), {{RepairKind::Thicken, 0}}).error().fault, Fault::OutOfRange);
  EXPECT_EQ(repair(sphere(0.07), {{RepairKind::Weld, 1}}).error().fault, Fault::BadMesh);  // all one point
}

}  // namespace
}  // namespace glenoid
