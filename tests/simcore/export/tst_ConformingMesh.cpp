// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedra of a part itself: volume, size, shape, repetition; surfaces that have none.
#include <cmath>
#include <numbers>
#include <set>

#include "simcore/export/SharpCurves.h"
#include "simcore/mesh/Isosurface.h"
#include "simcore/mesh/TetTools.h"
#include "tests/simcore/export/Exported.h"

namespace glenoid {
namespace {

TriMesh ball(double radius, double step) {
  return isosurface([&](const Vec3& x) { return x.norm() - radius; }, Box3(Vec3::Constant(-1.31 * radius), Vec3::Constant(1.31 * radius)), step);
}

double meanEdge(const TetMesh& mesh) {
  double sum = 0;
  for (const auto& tet : mesh.tets)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b) sum += (mesh.nodes[tet[a]] - mesh.nodes[tet[b]]).norm();
  return sum / (6.0 * static_cast<double>(mesh.tets.size()));
}

SolidFigures figuresOf(const TriMesh& surface, const TetMesh& mesh) {
  Part part;
  part.visual = std::make_shared<const TriMesh>(surface);
  part.volume = std::make_shared<const TetMesh>(mesh);
  return glenoid::figuresOf(part);
}

TEST(ConformingMesh, aBoxKeepsItsCreasesAndSoItsVolume) {
  const TriMesh box = scenes::boxSurface(Vec3(1, 2, 3), Vec3(1.04, 2.01, 3.006), 1);
  for (const double edge : {0.003, 0.005}) {  // of 3 mm some of its tetrahedra lie flat on a side
    const auto mesh = conformingMesh(box, {edge, 0});
    ASSERT_TRUE(mesh.ok()) << toLogLine(mesh.error());
    EXPECT_TRUE(healthOf(*mesh).healthy());
    EXPECT_NEAR(totalVolume(*mesh) / enclosedVolume(box), 1, 1e-6);
    EXPECT_LT((boundsOf(boundaryOf(*mesh)).min() - Vec3(1, 2, 3)).norm(), 1e-9);
  }
}

TEST(ConformingMesh, edgesAreAsLongAsAskedAndTheSurfaceAsNear) {
  const TriMesh surface = ball(0.01, 0.001);
  for (const double edge : {0.004, 0.0025}) {
    const auto mesh = conformingMesh(surface, {edge, 0.05 * edge});
    ASSERT_TRUE(mesh.ok()) << toLogLine(mesh.error());
    EXPECT_TRUE(healthOf(*mesh).healthy());
    EXPECT_NEAR(meanEdge(*mesh) / edge, 1, 0.25);
    // A sphere's cap of height d over each face: the volume left out is at most d times the area.
    const SolidFigures figures = figuresOf(surface, *mesh);
    EXPECT_LT(figures.volume, figures.partVolume * 1.001);
    EXPECT_GT(figures.volume, figures.partVolume - 0.05 * edge * 4 * std::numbers::pi * 1e-4);
    EXPECT_GT(figures.leastDihedral * 180 / std::numbers::pi, 5);
    for (const auto& t : boundaryOf(*mesh).triangles) EXPECT_NEAR(mesh->nodes[t[0]].norm(), 0.01, 1e-4) << "on the surface";
  }
}

TEST(ConformingMesh, theSameTwiceAlsoAfterAnother) {
  const TriMesh surface = ball(0.01, 0.001);
  const Hash128 first = contentHash(conformingMesh(surface, {0.003, 0}).value());
  ASSERT_TRUE(conformingMesh(scenes::boxSurface(Vec3::Zero(), Vec3::Ones(), 2), {0.3, 0}).ok());
  EXPECT_EQ(contentHash(conformingMesh(surface, {0.003, 0}).value()), first);
}

TEST(ConformingMesh, aRegularTetrahedronHasTheFiguresOfTheBooks) {
  TetMesh tet{{Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}, {{0, 1, 2, 3}}};
  if (tetVolume(tet, 0) < 0) std::swap(tet.tets[0][0], tet.tets[0][1]);
  const SolidFigures figures = figuresOf(boundaryOf(tet), tet);
  EXPECT_NEAR(figures.leastDihedral, std::acos(1.0 / 3), 1e-12);
  EXPECT_NEAR(figures.leastRadiusRatio, 1, 1e-12);
  EXPECT_NEAR(figures.volume / figures.partVolume, 1, 1e-12);
}

TEST(ConformingMesh, whatEnclosesNothingIsRefusedWithItsReason) {
  TriMesh open = ball(0.01, 0.002);
  open.triangles.pop_back();
  EXPECT_EQ(conformingMesh(open, {}, "belly").error().fault, Fault::MeshNotClosed);
  EXPECT_EQ(conformingMesh(open, {}, "belly").error().place.part, "belly");
  TriMesh twice = ball(0.01, 0.002);
  const int first = static_cast<int>(twice.vertices.size());
  TriMesh other = twice;
  for (Vec3& x : other.vertices) x.x() += 0.007;
  twice.vertices.insert(twice.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles) twice.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  const auto crossed = conformingMesh(twice, {});
  ASSERT_FALSE(crossed.ok());
  EXPECT_EQ(crossed.error().fault, Fault::BadMesh);
  EXPECT_NE(crossed.error().arguments[0].find("cuts itself"), std::string::npos);
  const TriMesh sound = ball(0.01, 0.002);
  for (const double edge : {1e-6, 1.0}) EXPECT_EQ(conformingMesh(sound, {edge, 0}).error().fault, Fault::OutOfRange) << edge;
  const std::atomic<bool> stop{true};
  EXPECT_EQ(conformingMesh(sound, {0.002, 0}, "", &stop).error().fault, Fault::Cancelled);
}

TEST(SharpCurves, ofABoxAreItsEdgesOfABallNone) {
  const TriMesh box = scenes::boxSurface(Vec3::Zero(), Vec3(1, 2, 3), 3);
  const auto curves = exporting::sharpCurves(box, 0.1);
  EXPECT_EQ(curves.size(), 12u);
  double length = 0;
  for (const auto& curve : curves)
    for (std::size_t i = 1; i < curve.size(); ++i) length += (box.vertices[curve[i]] - box.vertices[curve[i - 1]]).norm();
  EXPECT_NEAR(length, 4 * (1 + 2 + 3), 1e-12);
  EXPECT_TRUE(exporting::sharpCurves(box, 25).empty()) << "all of them are shorter";
  EXPECT_TRUE(exporting::sharpCurves(ball(1, 0.2), 0.1).empty());
}

TEST(ExportJoint, conformingVolumesAreThePartsAndCellsSayHowMuchMoreTheyAre) {
  const Joint joint = soundJoint();
  const double own = enclosedVolume(*joint.parts[1].visual);
  for (const ExportFormat format : {ExportFormat::Msh, ExportFormat::Vtu, ExportFormat::Scn, ExportFormat::Feb, ExportFormat::Inp}) {
    const Exported file(joint, format, ExportWish{.mesh = ExportMesh::Conforming, .size = {0.01, 0}});
    ASSERT_EQ(file.report.solids.size(), 1u) << exportWord(format);
    EXPECT_NEAR(file.report.solids[0].volume / own, 1, 1e-6);
    EXPECT_EQ(file.report.tetrahedra, file.report.solids[0].tetrahedra);
    EXPECT_EQ(file.lost(LossKind::FillFractions), 0);
  }
}

/// Lines of a deck after a keyword line that begins so, up to the next.
std::vector<std::string> blockOf(const std::string& deck, const std::string& keyword) {
  std::istringstream in(deck);
  std::vector<std::string> lines;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line[0] == '*' && line[1] != '*') inside = line.rfind(keyword, 0) == 0;
    else if (inside && line[0] != '*') lines.push_back(line);
  }
  return lines;
}

TEST(ExportCalculix, holdsPartsBonesAndNumbersItsProgramCanRead) {
  Joint joint = richJoint();
  joint.parts[1].id = "Tissue.1";
  for (Coupling& c : joint.couplings)
    for (std::string* id : {&c.partA, &c.partB})
      if (*id != joint.parts[0].id && *id != joint.parts[2].id) *id = "Tissue.1";
  for (Exclusion& e : joint.exclusions)
    for (std::string* id : {&e.partA, &e.partB})
      if (*id != joint.parts[0].id && *id != joint.parts[2].id) *id = "Tissue.1";
  joint.cages.clear();
  const Exported file(joint, ExportFormat::Inp, {.mesh = ExportMesh::Conforming});
  EXPECT_FALSE(blockOf(file.text, "*NODE, NSET=TISSUE_1").empty());
  EXPECT_EQ(static_cast<long>(blockOf(file.text, "*ELEMENT, TYPE=C3D10").size()), file.report.tetrahedra);
  const auto elastic = blockOf(file.text, "*ELASTIC");
  ASSERT_EQ(elastic.size(), 1u);
  EXPECT_EQ(elastic[0], "33333.3333333, 0.4");
  std::istringstream words(file.text);
  for (std::string line; std::getline(words, line);) {
    if (line.empty() || line[0] == '*') continue;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) EXPECT_LE(cell.size(), 21u) << line;  // a blank first
  }
  std::size_t ends = 0;
  for (std::size_t at = 0; (at = file.text.find("*RIGID BODY", at)) != std::string::npos; ++at) ++ends;
  EXPECT_EQ(ends, 2u);
  const Exported alone(joint, ExportFormat::Inp, ExportWish{.part = "Tissue.1", .mesh = ExportMesh::Conforming});
  EXPECT_NE(alone.text.find("ON-" + [](std::string id) { for (char& c : id) c = static_cast<char>(std::toupper(c)); return id; }(joint.couplings[0].id)),
            std::string::npos) << "each coupling is an end of its own";
}

}  // namespace
}  // namespace glenoid
