// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/Diagnose.h"

#include <gtest/gtest.h>

#include "simcore/mesh/Cleanup.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/repair/GuessUnit.h"
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

long countOf(const SurfaceDiagnosis& d, FindingKind kind) {
  const Finding* found = d.find(kind);
  return found ? found->count : 0;
}

/// Everything that is found but the unit.
std::string words(const SurfaceDiagnosis& d) {
  std::string out;
  for (const Finding& finding : d.findings)
    if (finding.kind != FindingKind::Unit) out += std::string(out.empty() ? "" : " ") + findingName(finding.kind);
  return out;
}

TEST(Diagnose, aSoundSurfaceHasNoFindings) {
  const SurfaceDiagnosis d = diagnose(sphere(70));
  EXPECT_EQ(words(d), "");
  EXPECT_TRUE(d.healthy());
  EXPECT_EQ(d.shells, 1);
  EXPECT_EQ(d.closedShells, 1);
  EXPECT_EQ(d.genus, 0);
  EXPECT_NEAR(d.thicknessMedian, 140, 3);  // facets of a ball of 48 sides
  EXPECT_TRUE(automaticRepairs(d).empty());
  const SurfaceDiagnosis ring = diagnose(shapes::torus(60, 15, 48, 24));
  EXPECT_EQ(words(ring), "handles");
  EXPECT_EQ(ring.genus, 1);
}

TEST(Diagnose, eachFlawIsFoundWithItsPlace) {
  TriMesh open = sphere(70);
  const auto missing = open.triangles[500];
  open.triangles.erase(open.triangles.begin() + 500);
  SurfaceDiagnosis d = diagnose(open);
  EXPECT_EQ(words(d), "holes");
  EXPECT_EQ(d.holes, 1);
  EXPECT_EQ(d.openEdges, 3);
  double around = 0;
  for (int i = 0; i < 3; ++i) around += (open.vertices[missing[i]] - open.vertices[missing[(i + 1) % 3]]).norm();
  EXPECT_NEAR(d.longestHole, around, 1e-9 * around);
  EXPECT_EQ(d.find(FindingKind::Holes)->triangles.size(), 3u);
  EXPECT_EQ(d.find(FindingKind::Holes)->repairs, (std::vector<RepairStep>{{RepairKind::FillHoles}}));
  EXPECT_FALSE(d.healthy());

  d = diagnose(reversed(sphere(70)));
  EXPECT_EQ(words(d), "inside-out");
  EXPECT_EQ(d.find(FindingKind::InsideOut)->triangles.size(), sphere(70).triangles.size());

  TriMesh contrary = sphere(70);
  std::swap(contrary.triangles[500][0], contrary.triangles[500][1]);
  d = diagnose(contrary);
  EXPECT_EQ(countOf(d, FindingKind::MisorientedEdges), 3);

  TriMesh twice = sphere(70);
  twice.triangles.push_back(twice.triangles[7]);
  d = diagnose(twice);
  EXPECT_EQ(countOf(d, FindingKind::DuplicateFaces), 1);
  EXPECT_EQ(d.find(FindingKind::DuplicateFaces)->triangles, std::vector<int>{static_cast<int>(twice.triangles.size()) - 1});
  EXPECT_EQ(countOf(d, FindingKind::NonManifoldEdges), 3);

  TriMesh flat = sphere(70);
  flat.triangles.push_back({0, 0, 1});
  d = diagnose(flat);
  EXPECT_EQ(countOf(d, FindingKind::DegenerateFaces), 1);

  TriMesh soup;
  for (const auto& t : box({0, 0, 0}, {60, 80, 100}).triangles)
    for (const int v : t) soup.vertices.push_back(box({0, 0, 0}, {60, 80, 100}).vertices[v]);
  for (int i = 0; i < 36; i += 3) soup.triangles.push_back({i, i + 1, i + 2});
  d = diagnose(soup);
  EXPECT_EQ(countOf(d, FindingKind::DuplicateVertices), 28);
  EXPECT_TRUE(d.find(FindingKind::DuplicateVertices)->harmless);
}

TEST(Diagnose, nonManifoldPlacesAreCounted) {
  // Two boxes that share an edge, and two that share a point.
  TriMesh edge = joined(box({0, 0, 0}, {50, 50, 50}), box({50, 50, 0}, {100, 100, 50}));
  edge = weldVertices(edge, 0);
  SurfaceDiagnosis d = diagnose(edge);
  EXPECT_EQ(countOf(d, FindingKind::NonManifoldEdges), 1);
  TriMesh point = weldVertices(joined(box({0, 0, 0}, {50, 50, 50}), box({50, 50, 50}, {100, 100, 100})), 0);
  d = diagnose(point);
  EXPECT_EQ(countOf(d, FindingKind::NonManifoldVertices), 1);
  EXPECT_EQ(countOf(d, FindingKind::NonManifoldEdges), 0);
}

TEST(Diagnose, aCavityIsNotInsideOutButATurnedShellIs) {
  const TriMesh hollow = joined(sphere(70), reversed(sphere(40)));
  EXPECT_EQ(words(diagnose(hollow)), "pieces");
  const SurfaceDiagnosis wrong = diagnose(joined(sphere(70), sphere(40)));
  EXPECT_EQ(countOf(wrong, FindingKind::InsideOut), 1);
}

TEST(Diagnose, selfIntersectionsAreCountedAsTheSlowWayDoes) {
  const TriMesh crossed = joined(sphere(70, 24, 15), shifted(sphere(70, 24, 15), {60, 3, 5}));
  const SurfaceDiagnosis d = diagnose(crossed);
  EXPECT_GT(d.selfIntersections, 0);
  EXPECT_EQ(d.selfIntersections, countSelfIntersections(crossed));
  DiagnosisOptions without;
  without.selfIntersections = false;
  EXPECT_EQ(diagnose(crossed, without).selfIntersections, -1);
}

TEST(Diagnose, sheetsAreNoHoles) {
  TriMesh sheet;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) sheet.vertices.push_back({10.0 * i, 10.0 * j, 0.1 * i * j});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const int a = 5 * i + j;
      sheet.triangles.push_back({a, a + 5, a + 6});
      sheet.triangles.push_back({a, a + 6, a + 1});
    }
  const SurfaceDiagnosis d = diagnose(sheet);
  EXPECT_EQ(words(d), "sheets");
  EXPECT_EQ(d.holes, 0);
  // Two walls on each other are a sheet as well.
  const SurfaceDiagnosis folded = diagnose(joined(sheet, reversed(sheet)));
  EXPECT_EQ(countOf(folded, FindingKind::Sheets), 2);
}

TEST(Diagnose, thinWallsAreMeasured) {
  DiagnosisOptions millimetres;
  millimetres.metresPerUnit = 1e-3;
  const SurfaceDiagnosis thin = diagnose(shapes::sheet(60, 20, 0.5, 0.8), millimetres);
  ASSERT_TRUE(thin.find(FindingKind::Thin));
  EXPECT_EQ(thin.find(FindingKind::Thin)->severity, FindingSeverity::Warning);
  // Elliptic across: half of its width is thinner than 0.5 √(1 − ¼), and its rounded ends are thinner still.
  EXPECT_NEAR(thin.thicknessMedian, 0.42, 0.03);
  EXPECT_EQ(thin.find(FindingKind::Thin)->repairs, (std::vector<RepairStep>{{RepairKind::Thicken, 1}}));
  EXPECT_FALSE(diagnose(shapes::sheet(60, 20, 5, 0.8), millimetres).find(FindingKind::Thin));
}

TEST(Diagnose, twoSidesOfABodyAreSeen) {
  TriMesh right = shifted(shapes::capsule(10, 60), {-160, 20, 1300});
  for (Vec3& v : right.vertices) v.x() += 0.1 * v.y();  // so that it is not its own image
  TriMesh left = reversed(right);
  for (Vec3& v : left.vertices) v.x() = -v.x() + 0.3;
  const SurfaceDiagnosis d = diagnose(joined(right, left));
  ASSERT_TRUE(d.find(FindingKind::TwoSides));
  EXPECT_EQ(d.find(FindingKind::TwoSides)->repairs[0].axis, 0);
  EXPECT_EQ(d.side.side, BodySide::Both);
  // The same twice is no mirror image.
  EXPECT_FALSE(diagnose(joined(right, shifted(right, {320, 0, 0}))).find(FindingKind::TwoSides));
}

TEST(Diagnose, theUnitOfPartsAndOfSmallBones) {
  const auto of = [](const char* name, double extent) { return guessUnit(Box3(Vec3::Zero(), Vec3(0.3 * extent, extent, 0.4 * extent)), name); };
  struct Row {
    const char* name;
    double metres;  ///< true extent
  };
  // Means of adults: textbooks; what scans hold of long bones is often an end of some 60 to 120 mm.
  for (const Row& row : {Row{"distal femur", 0.09}, Row{"tibial plateau", 0.075}, Row{"femoral cartilage", 0.075}, Row{"tibial cartilage medial", 0.04}, Row{"proximal humerus", 0.12},
                         Row{"scaphoid", 0.027}, Row{"Lunate_L", 0.02}, Row{"capitate", 0.026}, Row{"third metacarpal", 0.065}, Row{"talus right", 0.056}, Row{"patella", 0.043},
                         Row{"meniscus lateral", 0.035}, Row{"ACL", 0.036}, Row{"humerus", 0.31}, Row{"femur", 0.44}, Row{"biceps long head", 0.3}, Row{"articular capsule", 0.05}})
    for (const double unit : {1e-3, 1e-2, 1.0, 1e-6}) {
      const UnitGuess guess = of(row.name, row.metres / unit);
      EXPECT_EQ(guess.metres, unit) << row.name;
      if (unit > 1e-6) EXPECT_GT(guess.confidence, 0.6) << row.name << " in units of " << unit << " m";
    }
  EXPECT_EQ(of("humerus", 3e5).metres, 1e-6);
  EXPECT_STREQ(of("humerus", 3e5).reason, "name");
  EXPECT_EQ(of("humerus", 1.02).metres, 0.3048);
  EXPECT_STREQ(of("humerus", 3e-4).reason, "unclear") << "kilometres are no unit of these";
}

TEST(Diagnose, surfacesOfOneFileHaveOneUnit) {
  // By themselves a femur's ball in units of 4 cm or so would be centimetres, its shaft inches.
  const auto box = [](double extent) { return Box3(Vec3::Zero(), Vec3(extent, extent, extent)); };
  const std::vector<NamedBox> two{{box(40), "femur"}, {box(20), "tibia"}};
  EXPECT_NE(guessUnit(two[0].box, "").metres, 0);
  EXPECT_EQ(guessUnit(two).metres, 1e-2);
  // Eight carpals and a forearm; the forearm alone would do, the carpals alone too.
  std::vector<NamedBox> hand{{box(240), "radius"}, {box(260), "ulna"}};
  for (const char* name : {"scaphoid", "lunate", "triquetrum", "pisiform", "trapezium", "trapezoid", "capitate", "hamate"}) hand.push_back({box(20), name});
  EXPECT_EQ(guessUnit(hand).metres, 1e-3);
  EXPECT_GT(guessUnit(hand).confidence, 0.9);
  // Nameless pieces: large ones tell what small ones do not.
  EXPECT_EQ(guessUnit(std::vector<NamedBox>{{box(0.31), ""}, {box(0.02), ""}, {box(0.15), ""}}).metres, 1);
  // One that fits nothing does not outvote the rest.
  EXPECT_EQ(guessUnit(std::vector<NamedBox>{{box(310), "humerus"}, {box(155), "scapula"}, {box(1e9), "scapula"}}).metres, 1e-3);
  ImportedFile file;
  file.surfaces = {{"femur", shifted(sphere(200), {0, 0, 0})}, {"", sphere(3)}};
  const auto found = diagnoseFile(file, "knee");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].unit.metres, 1e-3);
  EXPECT_EQ(found[1].unit.metres, 1e-3);
}

TEST(Diagnose, theUnitIsGuessedFromSizePlaceAndName) {
  const auto guess = [](const Vec3& low, const Vec3& size, const char* name = "") { return guessUnit(Box3(low, low + size), name); };
  // A scapula 155 tall is in millimetres, 0.155 in metres.
  EXPECT_EQ(guess({-50, -80, -60}, {100, 155, 110}).metres, 1e-3);
  EXPECT_GT(guess({-50, -80, -60}, {100, 155, 110}).confidence, 0.6);
  EXPECT_EQ(guess({0, 0, 0}, {0.1, 0.155, 0.11}).metres, 1);
  EXPECT_EQ(guess({0, 0, 0}, {3, 31, 4}, "humerus").metres, 1e-2);
  EXPECT_EQ(guess({0, 0, 0}, {1, 12.2, 1}, "Humerus.r").metres, 0.0254);
  // 2.8 tall fits nothing well: not millimetres, and said to be unclear.
  const UnitGuess odd = guess({0, 0, 0}, {2, 2.8, 2}, "scapula");
  EXPECT_NE(odd.metres, 1e-3);
  EXPECT_STREQ(odd.reason, "unclear");
  // 36 long might be a ligament in millimetres; at shoulder height it is an arm bone in centimetres.
  const UnitGuess high = guess({-54, 141, -5}, {36, 7.6, 6.7});
  EXPECT_EQ(high.metres, 1e-2);
  EXPECT_STREQ(high.reason, "place");
  EXPECT_EQ(guessUnit(Box3(), "x").metres, 0);
  DiagnosisOptions wrong;
  wrong.metresPerUnit = 1;
  const SurfaceDiagnosis d = diagnose(sphere(70), wrong);  // 140 m
  ASSERT_TRUE(d.find(FindingKind::Unit));
  EXPECT_EQ(d.find(FindingKind::Unit)->severity, FindingSeverity::Warning);
  EXPECT_EQ(d.find(FindingKind::Unit)->measure, 1e-3);
}

TEST(Diagnose, theSideComesFromTheNameOrIsUnknown) {
  DiagnosisOptions options;
  for (const auto& [name, side] : {std::pair("scapula_right", BodySide::Right), std::pair("Humerus.l", BodySide::Left), std::pair("clavicle L", BodySide::Left),
                                   std::pair("labrum", BodySide::Unknown), std::pair("lateral_head", BodySide::Unknown)}) {
    options.name = name;
    EXPECT_EQ(diagnose(sphere(70), options).side.side, side) << name;
  }
}

TEST(Diagnose, unreadableMeshesAreSaidToBe) {
  TriMesh bad = sphere(70);
  bad.triangles[3][1] = 1 << 30;
  EXPECT_EQ(words(diagnose(bad)), "cannot-be-read");
  bad = sphere(70);
  bad.vertices[3].x() = NAN;
  EXPECT_EQ(words(diagnose(bad)), "cannot-be-read");
  EXPECT_EQ(words(diagnose(TriMesh{})), "cannot-be-read");
}

TEST(Diagnose, cancelLeavesTheRestOut) {
  DiagnosisOptions options;
  options.cancelled = [] { return true; };
  const SurfaceDiagnosis d = diagnose(reversed(sphere(70)), options);
  EXPECT_TRUE(d.cancelled);
  EXPECT_TRUE(d.findings.empty());
}

}  // namespace
}  // namespace glenoid
