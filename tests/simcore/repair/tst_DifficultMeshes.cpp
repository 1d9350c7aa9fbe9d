// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/import/ImportSurfaces.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/repair/Diagnose.h"
#include "simcore/spatial/TriangleTree.h"
#include "tests/resources/ReferenceMesh.h"

// What other people's files are like, and what becomes of them.
namespace glenoid {
namespace {

struct Brought {
  ImportedFile file;
  SurfaceDiagnosis diagnosis;
  const TriMesh& mesh() const { return file.surfaces[0].mesh; }
};

class DifficultMeshes : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto folder = test::referenceFolder();
    if (!folder) GTEST_SKIP() << "the folder of reference meshes is not here";
    m_folder = *folder;
  }
  /// Nothing but the numbers: neither the name nor the user helps.
  Brought bring(const std::string& name) const {
    auto file = importSurfaces(m_folder + "/" + name);
    EXPECT_TRUE(file.ok()) << (file ? "" : toLogLine(file.error()));
    if (!file) return {};
    EXPECT_EQ(file->surfaces.size(), 1u);
    SurfaceDiagnosis diagnosis = diagnose(file->surfaces[0].mesh);
    return {std::move(*file), std::move(diagnosis)};
  }
  static TriMesh mended(const TriMesh& mesh, const std::vector<RepairStep>& steps) {
    const auto outcome = repair(mesh, steps);
    EXPECT_TRUE(outcome.ok()) << (outcome ? "" : toLogLine(outcome.error()));
    return outcome ? outcome->mesh : TriMesh{};
  }
  static long countOf(const SurfaceDiagnosis& d, FindingKind kind) { return d.find(kind) ? d.find(kind)->count : 0; }
  std::string m_folder;
};

TEST_F(DifficultMeshes, humerusInsideOutWithPolygonsInCentimetres) {
  const Brought b = bring("difficult/humerus_inside_out_ngons_cm.obj");
  EXPECT_EQ(b.diagnosis.unit.metres, 0.01);
  EXPECT_GT(b.diagnosis.unit.confidence, 0.6);
  EXPECT_EQ(countOf(b.diagnosis, FindingKind::InsideOut), 1);
  EXPECT_EQ(b.diagnosis.closedShells, 1);
  EXPECT_EQ(b.diagnosis.genus, 0);
  const auto split = std::find_if(b.file.notes.begin(), b.file.notes.end(), [](const NoteCount& n) { return n.note == ImportNote::PolygonsSplit; });
  ASSERT_NE(split, b.file.notes.end());
  EXPECT_EQ(split->count, 180);
  const TriMesh turned = mended(b.mesh(), automaticRepairs(b.diagnosis));
  EXPECT_TRUE(healthOf(turned).healthy());
  EXPECT_EQ(turned.vertices, b.mesh().vertices);  // no point moved
  // Its quads are bent enough to cut each other once they are triangles.
  std::vector<RepairStep> all = automaticRepairs(b.diagnosis);
  all.push_back({RepairKind::RemoveSelfIntersections});
  const TriMesh clean = mended(b.mesh(), all);
  EXPECT_TRUE(healthOf(clean).healthy());
  EXPECT_EQ(diagnose(clean).selfIntersections, 0);
}

TEST_F(DifficultMeshes, labrumOfAMirroredNodeInsideOutInMetres) {
  const Brought b = bring("difficult/labrum_mirrored_node_inside_out_metres.stl");
  EXPECT_EQ(b.diagnosis.unit.metres, 1);
  EXPECT_GT(b.diagnosis.unit.confidence, 0.6);
  EXPECT_EQ(countOf(b.diagnosis, FindingKind::InsideOut), 1);
  EXPECT_EQ(b.diagnosis.genus, 1);  // a ring
  const TriMesh turned = mended(b.mesh(), automaticRepairs(b.diagnosis));
  EXPECT_TRUE(healthOf(turned).healthy());
  EXPECT_NEAR(healthOf(turned).volume, 8.148e-7, 1e-9);  // m³, as counted by hand from the file
}

TEST_F(DifficultMeshes, ligamentOfZeroThicknessWithBothSides) {
  const Brought b = bring("difficult/coracoacromial_ligament_zero_thickness_two_sides.stl");
  EXPECT_EQ(b.diagnosis.unit.metres, 1e-3);
  EXPECT_EQ(countOf(b.diagnosis, FindingKind::TwoSides), 2);
  EXPECT_EQ(countOf(b.diagnosis, FindingKind::Sheets), 2);
  EXPECT_EQ(b.diagnosis.side.side, BodySide::Both);
  EXPECT_EQ(b.diagnosis.holes, 0);
  std::vector<RepairStep> steps;
  for (const FindingKind kind : {FindingKind::TwoSides, FindingKind::Sheets})
    for (const RepairStep& step : b.diagnosis.find(kind)->repairs) steps.push_back(step);
  const TriMesh right = mended(b.mesh(), steps);
  EXPECT_TRUE(healthOf(right).healthy());
  EXPECT_EQ(healthOf(right).components, 1);
  EXPECT_LT(boundsOf(right).max().x(), 0);  // right = −X in that atlas
  EXPECT_NEAR(diagnose(right).thicknessMedian, 1, 0.05);  // mm, the default limit
}

TEST_F(DifficultMeshes, scapulaWithHolesAndNonManifoldEdgesInMetres) {
  const Brought b = bring("difficult/scapula_open_nonmanifold_metres.stl");
  EXPECT_EQ(b.diagnosis.unit.metres, 1);
  EXPECT_GT(b.diagnosis.unit.confidence, 0.6);
  EXPECT_EQ(b.diagnosis.openEdges, 13);
  EXPECT_EQ(countOf(b.diagnosis, FindingKind::NonManifoldEdges), 23);
  EXPECT_EQ(countOf(b.diagnosis, FindingKind::DuplicateFaces), 3);
  EXPECT_GT(countOf(b.diagnosis, FindingKind::Holes), 0);
  const TriMesh closed = mended(b.mesh(), automaticRepairs(b.diagnosis));
  const MeshHealth health = healthOf(closed);
  EXPECT_TRUE(health.healthy()) << health.openEdges << " open, " << health.nonManifoldEdges << " crowded, " << health.misorientedEdges << " contrary";
  EXPECT_EQ(health.components, 1);
  // Flaps inside it went, the rest stayed where it was.
  const TriangleTree tree(closed);
  std::size_t stayed = 0;
  for (const Vec3& v : b.mesh().vertices) stayed += tree.closest(v).distance < 1e-9;
  EXPECT_GT(static_cast<double>(stayed), 0.97 * static_cast<double>(b.mesh().vertices.size()));
  EXPECT_EQ(diagnose(mended(closed, {{RepairKind::RemoveSelfIntersections}})).selfIntersections, 0);
}

TEST_F(DifficultMeshes, theClosedOnesAreRecognisedAsSound) {
  for (const char* name : {"zanatomy/scapula_right.stl", "bodyparts3d/humerus_FMA23130.stl", "bodyparts3d/supraspinatus_FMA32544.stl",
                           "bodyparts3d/subscapularis_FMA13414.stl", "zanatomy/coracohumeral_ligament_right.stl"}) {
    const Brought b = bring(name);
    EXPECT_TRUE(b.diagnosis.healthy()) << name;
    EXPECT_EQ(b.diagnosis.unit.metres, 1e-3) << name;
    EXPECT_TRUE(automaticRepairs(b.diagnosis).empty()) << name;
  }
}

TEST_F(DifficultMeshes, subscapularisHasHandlesAndCutsItself) {
  const Brought b = bring("bodyparts3d/subscapularis_FMA13414.stl");
  EXPECT_EQ(b.diagnosis.genus, 17);
  EXPECT_GE(b.diagnosis.selfIntersections, 14);  // those without a common vertex, and those with one
  const TriMesh clean = mended(b.mesh(), {{RepairKind::RemoveSelfIntersections}});
  EXPECT_TRUE(healthOf(clean).healthy());
  EXPECT_EQ(diagnose(clean).selfIntersections, 0);
}

TEST_F(DifficultMeshes, aLigamentHalfAMillimetreThinIsThickened) {
  const Brought b = bring("zanatomy/coracohumeral_ligament_right.stl");
  ASSERT_TRUE(b.diagnosis.find(FindingKind::Thin));
  EXPECT_NEAR(b.diagnosis.thicknessMedian, 0.48, 0.05);  // mm
  const TriMesh thick = mended(b.mesh(), {{RepairKind::Thicken, 1.5}});
  const SurfaceDiagnosis d = diagnose(thick);
  EXPECT_TRUE(d.healthy());
  EXPECT_EQ(d.selfIntersections, 0);
  EXPECT_GT(d.thicknessMedian, 0.9 * 1.5);
}

}  // namespace
}  // namespace glenoid
