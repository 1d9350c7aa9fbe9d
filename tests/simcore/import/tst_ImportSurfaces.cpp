// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/ImportSurfaces.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "simcore/import/MeshFormat.h"
#include "simcore/mesh/MeshHealth.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/import/SampleFiles.h"

namespace glenoid {
namespace {

long countOf(const ImportedFile& file, ImportNote note) {
  for (const NoteCount& entry : file.notes)
    if (entry.note == note) return entry.count;
  return 0;
}

TEST(ImportSurfaces, everyFormatGivesTheSameBox) {
  const TemporaryFolder folder;
  for (const samples::Sample& sample : samples::all()) {
    const auto file = importSurfaces(folder.put(sample.name, sample.bytes));
    ASSERT_TRUE(file.ok()) << sample.name << ": " << toLogLine(file.error());
    ASSERT_EQ(file->surfaces.size(), 1u) << sample.name;
    const TriMesh& mesh = file->surfaces[0].mesh;
    const MeshHealth health = healthOf(mesh);
    EXPECT_EQ(mesh.vertices.size(), 8u) << sample.name;
    EXPECT_EQ(mesh.triangles.size(), 12u) << sample.name;
    EXPECT_TRUE(health.healthy()) << sample.name << " volume " << health.volume;
    // Single precision of the formats and of assimp: a few units in the seventh digit.
    EXPECT_NEAR(health.volume / std::pow(sample.scale, 3), 6, 1e-5) << sample.name;
    const Box3 box = boundsOf(mesh);
    EXPECT_LT((box.diagonal() / sample.scale - Vec3(1, 2, 3)).norm(), 1e-5) << sample.name;
    EXPECT_NEAR(box.min().x() / sample.scale, sample.mirrored ? -1 : 0, 1e-5) << sample.name;
    EXPECT_EQ(countOf(*file, ImportNote::PolygonsSplit), sample.quads ? 6 : 0) << sample.name;
    EXPECT_EQ(countOf(*file, ImportNote::NodesMirrored), sample.mirrored ? 1 : 0) << sample.name;
    EXPECT_NEAR(file->metresPerUnit.value_or(0), sample.unit, 1e-6 * sample.unit) << sample.name;
  }
}

TEST(ImportSurfaces, whatIsLostIsSaid) {
  const TemporaryFolder folder;
  const auto obj = importSurfaces(folder.put("a.obj", samples::obj() + "l 1 2\np 3\n"));
  ASSERT_TRUE(obj.ok()) << toLogLine(obj.error());
  EXPECT_EQ(obj->format, "OBJ");
  EXPECT_GT(countOf(*obj, ImportNote::NormalsDropped), 0);
  EXPECT_GT(countOf(*obj, ImportNote::TexturesDropped), 0);
  EXPECT_EQ(countOf(*obj, ImportNote::LinesDropped), 1);
  EXPECT_EQ(countOf(*obj, ImportNote::PointsDropped), 1);
  EXPECT_EQ(countOf(*obj, ImportNote::MaterialsDropped), 0);  // its file of materials is not there
  folder.put("nowhere.mtl", "newmtl bone\nKd 1 1 0.9\n");
  const auto painted = importSurfaces(folder.put("b.obj", samples::obj() + "usemtl bone\nf 1 3 2\n"));
  ASSERT_TRUE(painted.ok()) << toLogLine(painted.error());
  EXPECT_GT(countOf(*painted, ImportNote::MaterialsDropped), 0);
  ASSERT_EQ(painted->surfaces.size(), 1u) << "two materials are still one surface";
  EXPECT_EQ(painted->surfaces[0].mesh.triangles.size(), 13u);
  const auto stl = importSurfaces(folder.put("a.stl", samples::stlBinary()));
  ASSERT_TRUE(stl.ok());
  EXPECT_EQ(countOf(*stl, ImportNote::PointsJoined), 28);  // 36 corners, 8 places
}

TEST(ImportSurfaces, severalNodesAreSeveralSurfaces) {
  const TemporaryFolder folder;
  std::string two = samples::obj();
  two += "o other\nv 9 0 0\nv 10 0 0\nv 9 1 0\nf 9 10 11\n";
  const auto file = importSurfaces(folder.put("two.obj", two));
  ASSERT_TRUE(file.ok()) << toLogLine(file.error());
  ASSERT_EQ(file->surfaces.size(), 2u);
  EXPECT_EQ(file->surfaces[0].name, "box");
  EXPECT_EQ(file->surfaces[1].name, "other");
  EXPECT_EQ(file->surfaces[1].mesh.triangles.size(), 1u);
}

TEST(ImportSurfaces, theContentCountsMoreThanTheEnding) {
  const TemporaryFolder folder;
  const auto file = importSurfaces(folder.put("really-stl.obj", samples::stlBinary()));
  ASSERT_TRUE(file.ok()) << toLogLine(file.error());
  EXPECT_EQ(file->format, "STL");
}

TEST(ImportSurfaces, endingsOfOtherProgramsAreRefused) {
  const TemporaryFolder folder;
  for (const char* name : {"liver.mesh", "scene.scn", "a.blend", "noending", "dir.obj/x"}) {
    const auto file = importSurfaces(folder.put(name, samples::stlBinary()));
    ASSERT_FALSE(file.ok()) << name;
    EXPECT_EQ(file.error().fault, Fault::UnknownFormat) << name;
    EXPECT_EQ(file.error().place.file, folder.path(name));
  }
}

TEST(ImportSurfaces, filesThatCannotBeReadAreNamed) {
  const TemporaryFolder folder;
  const auto fault = [](const std::string& path, const ImportLimits& limits = {}) {
    const auto file = importSurfaces(path, limits);
    return file ? Fault::Internal : file.error().fault;
  };
  EXPECT_EQ(fault(folder.path("none.stl")), Fault::FileMissing);
  EXPECT_EQ(fault(folder.put("empty.stl", "")), Fault::FileEmpty);
  std::filesystem::create_directory(folder.path("folder.stl"));
  EXPECT_EQ(fault(folder.path("folder.stl")), Fault::FileUnreadable);
  ASSERT_EQ(::mkfifo(folder.path("pipe.stl").c_str(), 0600), 0);
  EXPECT_EQ(fault(folder.path("pipe.stl")), Fault::FileUnreadable);
  ImportLimits small;
  small.fileBytes = 100;
  EXPECT_EQ(fault(folder.put("large.stl", samples::stlBinary()), small), Fault::FileTooLarge);
  ImportLimits few;
  few.triangles = 11;
  EXPECT_EQ(fault(folder.path("large.stl"), few), Fault::FileTooLarge);
  ImportLimits nobody;
  nobody.worker = folder.path("no-such-program");
  const auto file = importSurfaces(folder.path("large.stl"), nobody);
  ASSERT_FALSE(file.ok());
  EXPECT_EQ(file.error().fault, Fault::FileMissing);
  EXPECT_EQ(file.error().place.file, nobody.worker);
}

TEST(ImportSurfaces, aBufferOutsideTheFilesFolderIsNotOpened) {
  const TemporaryFolder folder;
  std::string away = samples::gltf();
  const auto at = away.find("\"uri\":\""), end = away.find('"', at + 7);
  away.replace(at + 7, end - at - 7, "../buffer.bin");
  folder.put("buffer.bin", std::string(168, '\0'));
  const auto file = importSurfaces(folder.put("in/box.gltf", away));
  EXPECT_FALSE(file.ok());
}

TEST(ImportSurfaces, twinsOfAFormatWithIndicesAreMeant) {
  // Two tetrahedra that touch at a point, each with its own copy of it.
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\nelement face 8\n"
                          "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 0\n-1 0 0\n0 -1 0\n0 0 -1\n"
                          "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 5 6\n3 4 7 5\n3 4 6 7\n3 5 7 6\n";
  const TemporaryFolder folder;
  const auto file = importSurfaces(folder.put("two.ply", ply));
  ASSERT_TRUE(file.ok()) << toLogLine(file.error());
  EXPECT_EQ(file->surfaces[0].mesh.vertices.size(), 8u);
  EXPECT_TRUE(file->notes.empty());
}

TEST(ImportSurfaces, numbersThatAreNoneAreRefused) {
  const TemporaryFolder folder;
  std::string bad = samples::stlBinary();
  bad.replace(84 + 12, 4, "\xff\xff\xff\x7f");  // NaN
  const auto file = importSurfaces(folder.put("nan.stl", bad));
  ASSERT_FALSE(file.ok());
  EXPECT_EQ(file.error().fault, Fault::NotFinite);
}

}  // namespace
}  // namespace glenoid
