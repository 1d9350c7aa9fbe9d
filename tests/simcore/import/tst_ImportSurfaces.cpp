// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/ImportSurfaces.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cctype>
#include <functional>

#include "simcore/file/ByteReader.h"
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

std::string withFirst(const std::string& text, const std::string& from, const std::string& to) {
  std::string out = text;
  const std::size_t at = out.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? out : out.replace(at, from.size(), to);
}

// What writers say of the frame of their coordinates, and where.
TEST(ImportSurfaces, axesThatAFileNamesAreKept) {
  struct Said {
    const char *writer, *name;
    std::string bytes;
    FileAxes axes;
  };
  std::string binary = samples::stlBinary();
  const std::string header = "3D Slicer output. SPACE=RAS";
  binary.replace(0, header.size(), header);
  const std::string triangle = "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n";
  const std::string vtp = samples::vtp(samples::VtpForm::Ascii, false, false);
  const auto field = [&](const char* attributes, const char* text) {
    return withFirst(vtp, "<Piece", std::string("<FieldData><Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" ") + attributes + ">" + text + "</Array></FieldData><Piece");
  };
  const Said all[] = {
      {"3D Slicer 5, text STL", "a.stl", withFirst(samples::stlText(), samples::stlText().substr(0, samples::stlText().find('\n')), "solid 3D Slicer output. SPACE=LPS"), FileAxes::Lps},
      {"3D Slicer 5, binary STL", "b.stl", binary, FileAxes::Ras},
      {"3D Slicer 5, OBJ", "a.obj", "# 3D Slicer output. SPACE=LPS\n" + samples::obj(), FileAxes::Lps},
      {"3D Slicer 5, PLY", "a.ply", "ply\nformat ascii 1.0\ncomment 3D Slicer output. SPACE=RAS\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                                    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", FileAxes::Ras},
      {"3D Slicer 5, legacy VTK by its title", "a.vtk", "# vtk DataFile Version 4.2\n3D Slicer output. SPACE=LPS\nASCII\nDATASET POLYDATA\n" + triangle, FileAxes::Lps},
      {"VTK 9.1 of Slicer's VTP, legacy VTK by a field", "b.vtk",
       "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nSPACE 1 1 string\nRAS\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
       "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n", FileAxes::Ras},
      {"3D Slicer 5, VTP in ascii", "a.vtp", field("format=\"ascii\"", "76 80 83 0"), FileAxes::Lps},
      {"VTK 9.1, VTP in binary without compression", "b.vtp", field("format=\"binary\"", samples::base64(std::string("\4\0\0\0RAS\0", 8)).c_str()), FileAxes::Ras},
      {"glTF 2.0, by its specification", "a.gltf", samples::gltf(), FileAxes::YUp},
      {"COLLADA 1.4 without up_axis", "a.dae", withFirst(samples::dae({}, false), "<up_axis>Z_UP</up_axis>", ""), FileAxes::YUp},
      {"Blender 3.4, COLLADA", "b.dae", samples::dae({}, false), FileAxes::ZUp},
      {"meshio 5.0, STL that says nothing", "c.stl", samples::stlText(), FileAxes::Unsaid},
      {"a name that only looks like it", "b.obj", "# SPACE=LOCAL\n" + samples::obj(), FileAxes::Unsaid},
  };
  const TemporaryFolder folder;
  for (const Said& said : all) {
    const auto file = importSurfaces(folder.put(said.name, said.bytes));
    ASSERT_TRUE(file.ok()) << said.writer << ": " << toLogLine(file.error());
    EXPECT_STREQ(fileAxesName(file->axes), fileAxesName(said.axes)) << said.writer;
  }
}

TEST(ImportSurfaces, namesAndUnitsInCommentsOfBodyParts3D) {
  const TemporaryFolder folder;
  const std::string comments = "# Representation : FJ3147\n# English name : left humerus\n# Bounds(mm): (0,0,0)-(1,2,3)\n# Volume(cm3): 0.006\n";
  const auto file = importSurfaces(folder.put("FJ3147.obj", comments + withFirst(samples::obj(), "o box", "g FJ3147")));
  ASSERT_TRUE(file.ok()) << toLogLine(file.error());
  EXPECT_EQ(file->surfaces[0].name, "left humerus");
  EXPECT_EQ(file->metresPerUnit.value_or(0), 1e-3);
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

/// Text of an STL with its keywords changed by `write`.
std::string rewritten(const std::string& text, const std::function<char(char)>& write) {
  std::string out = text;
  for (char& c : out) c = write(c);
  return out;
}

TEST(ImportSurfaces, stlAsOthersWriteIt) {
  const TemporaryFolder folder;
  const std::string text = samples::stlText(), binary = samples::stlBinary();
  const auto upper = [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); };
  std::string solid = binary;
  solid.replace(0, 11, "solid facet");  // exporters write so into the header of a binary file
  std::string carriage;
  for (const char c : text) carriage += c == '\n' ? '\r' : c;
  for (const auto& [name, bytes] : std::vector<std::pair<std::string, std::string>>{
           {"capitals.stl", rewritten(text, upper)}, {"blank-first.stl", "\n \n\t\n" + text}, {"mark.stl", "\xef\xbb\xbf" + text},
           {"carriage.stl", carriage}, {"after-text.stl", text + "\n\n  \n"}, {"two-bytes-after.stl", binary + "\r\n"},
           {"many-bytes-after.stl", binary + std::string(1000, '\7')}, {"solid-binary.stl", solid}, {"solid-binary-after.stl", solid + "x"}}) {
    const auto file = importSurfaces(folder.put(name, bytes));
    ASSERT_TRUE(file.ok()) << name << ": " << toLogLine(file.error());
    EXPECT_EQ(file->format, "STL") << name;
    ASSERT_EQ(file->surfaces.size(), 1u) << name;
    EXPECT_EQ(file->surfaces[0].mesh.triangles.size(), 12u) << name;
    EXPECT_NEAR(healthOf(file->surfaces[0].mesh).volume, 6, 1e-5) << name;
  }
  const auto fault = [&](const char* name, const std::string& bytes) {
    const auto file = importSurfaces(folder.put(name, bytes));
    return file ? Error{} : file.error();
  };
  EXPECT_EQ(fault("cut.stl", binary.substr(0, binary.size() - 1)).fault, Fault::FileTruncated);
  EXPECT_EQ(fault("half.stl", binary.substr(0, binary.size() / 2)).fault, Fault::FileTruncated);
  const Error other = fault("an-obj.stl", samples::obj());
  EXPECT_EQ(other.fault, Fault::BadMesh);
  EXPECT_NE(other.arguments.at(0).find("not that of an STL"), std::string::npos) << other.arguments.at(0);
  EXPECT_EQ(fault("short.stl", "hello").fault, Fault::BadMesh);
}

TEST(ImportSurfaces, namesAreWhole) {
  const TemporaryFolder folder;
  const auto namesIn = [&](const char* name, const std::string& bytes) {
    std::vector<std::string> names;
    const auto file = importSurfaces(folder.put(name, bytes));
    EXPECT_TRUE(file.ok()) << name << (file ? "" : toLogLine(file.error()));
    if (file)
      for (const ImportedSurface& surface : file->surfaces) names.push_back(surface.name);
    return names;
  };
  using Names = std::vector<std::string>;
  const std::string facet = " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n  endloop\n endfacet\n";
  EXPECT_EQ(namesIn("two.stl", "solid humerus left\n" + facet + "endsolid humerus left\nSOLID  scapula left \n" + facet + "ENDSOLID\n"), (Names{"humerus left", "scapula left"}));
  EXPECT_EQ(namesIn("slicer.stl", "solid 3D Slicer output. SPACE=RAS\n" + facet + "endsolid\n"), (Names{"3D Slicer output. SPACE=RAS"}));
  EXPECT_EQ(namesIn("latin-1.stl", "solid H\xfc" "fte\n" + facet + "endsolid\n"), (Names{"Hüfte"}));
  EXPECT_EQ(namesIn("none.stl", "solid\n" + facet + "endsolid\n"), (Names{""}));
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  EXPECT_EQ(namesIn("same-first-word.obj", points + "o humerus left\nf 1 2 3\no humerus right\nf 1 3 4\n"), (Names{"humerus left", "humerus right"}));
  EXPECT_EQ(namesIn("same.obj", points + "o\tbone\nf 1 2 3\no bone \nf 1 3 4\n"), (Names{"bone", "bone"}));
  EXPECT_EQ(namesIn("group.obj", points + "g left humerus\nf 1 2 3\n"), (Names{"left humerus"}));
  EXPECT_EQ(namesIn("nameless.obj", points + "f 1 2 3\n"), (Names{""})) << "assimp has a name of its own for it";
  // What follows an object keeps its corners: the file is the same but for names.
  const auto file = importSurfaces(folder.path("same-first-word.obj"));
  ASSERT_EQ(file->surfaces.size(), 2u);
  EXPECT_EQ(file->surfaces[0].mesh.triangles.size(), 1u);
  EXPECT_EQ(file->surfaces[1].mesh.vertices.back(), Vec3(0, 0, 1));
}

TEST(ImportSurfaces, whatIsNotTheFileIsSaid) {
  const TemporaryFolder folder;
  const auto words = [&](const char* name, const std::string& bytes) {
    const auto file = importSurfaces(folder.put(name, bytes));
    return file || file.error().arguments.empty() ? std::string() : file.error().arguments[0];
  };
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0000000000000000000000000000000000000000000000000000000000000000\nsize 12345\n";
  for (const char* name : {"bone.stl", "bone.obj", "bone.ply", "bone.glb", "bone.vtp", "bone.vtk"}) {
    EXPECT_NE(words(name, pointer).find("Git LFS"), std::string::npos) << name;
    EXPECT_NE(words(name, "<!DOCTYPE html>\n<html><body>404</body></html>").find("web page"), std::string::npos) << name;
  }
  // Where a library refuses, its reason is told.
  std::string lost = samples::gltf();
  const auto at = lost.find("\"uri\":\""), end = lost.find('"', at + 7);
  lost.replace(at + 7, end - at - 7, "left.bin");
  EXPECT_NE(words("lost.gltf", lost).find("left.bin"), std::string::npos) << words("lost.gltf", lost);
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

TEST(ImportSurfaces, whatAGltfRequiresIsUnderstoodOrRefused) {
  const TemporaryFolder folder;
  const auto with = [](std::string file, const std::string& names) { return file.insert(file.find('{') + 1, "\"extensionsRequired\":[" + names + "],"); };
  const auto glb = [&](const std::string& text) {
    std::string json = text;
    while (json.size() % 4 != 0) json += ' ';
    std::string bytes = "glTF";
    appendBytes<std::uint32_t>(2, std::endian::little, bytes);
    appendBytes<std::uint32_t>(static_cast<std::uint32_t>(20 + json.size()), std::endian::little, bytes);
    appendBytes<std::uint32_t>(static_cast<std::uint32_t>(json.size()), std::endian::little, bytes);
    return bytes + "JSON" + json;
  };
  for (const bool binary : {false, true}) {
    const char* name = binary ? "box.glb" : "box.gltf";
    const auto form = [&](const std::string& text) { return binary ? glb(text) : text; };
    for (const std::string required : {"\"EXT_mesh_gpu_instancing\"", "\"KHR_meshopt_compression\"", "\"KHR_materials_unlit\",\"VENDOR_new_geometry\""}) {
      const auto refused = importSurfaces(folder.put(name, form(with(samples::gltf(), required))));
      ASSERT_FALSE(refused.ok()) << required;
      const std::string last = required.substr(required.rfind(',') + 2);
      EXPECT_NE(refused.error().arguments.at(0).find(last.substr(0, last.size() - 1)), std::string::npos) << refused.error().arguments[0];
      EXPECT_EQ(refused.error().arguments[0].find("unlit"), std::string::npos);
    }
    if (binary) continue;  // assimp finds no buffer that a GLB holds as text
    for (const std::string required : {"", "\"KHR_materials_unlit\"", "\"KHR_texture_transform\",\"EXT_texture_webp\""}) {
      const auto file = importSurfaces(folder.put(name, form(with(samples::gltf(), required))));
      ASSERT_TRUE(file.ok()) << required << toLogLine(file.error());
      EXPECT_EQ(countOf(*file, ImportNote::MaterialsDropped), 0) << "the reader's own one does not count";
    }
  }
}

TEST(ImportSurfaces, anEncodedNameOfABufferIsFound) {
  const TemporaryFolder folder;
  // The sample's buffer as a file of its own, under a name that an address must encode.
  std::string file = samples::gltf();
  const std::string mark = "base64,";
  const auto at = file.find("\"uri\":\"") + 7, end = file.find('"', at);
  const std::string packed = file.substr(file.find(mark, at) + mark.size(), end - file.find(mark, at) - mark.size());
  std::string bytes;
  unsigned bits = 0;
  int have = 0;
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (const char c : packed) {
    const auto value = letters.find(c);
    if (value == std::string::npos) break;
    bits = bits << 6 | static_cast<unsigned>(value), have += 6;
    if (have >= 8) have -= 8, bytes += static_cast<char>(bits >> have & 255u);
  }
  for (const auto& [name, uri] : {std::pair{"left humerus.bin", "left%20humerus.bin"}, {"plain.bin", "plain.bin"}, {"100%25.bin", "100%25.bin"},
                                  {"Hüfte.bin", "H%c3%BCfte.bin"}, {"in/part 2.bin", "in/part%202.bin"}}) {
    folder.put(name, bytes);
    std::string beside = file;
    beside.replace(at, end - at, uri);
    const auto read = importSurfaces(folder.put("box.gltf", beside));
    ASSERT_TRUE(read.ok()) << uri << ": " << toLogLine(read.error());
    EXPECT_NEAR(healthOf(read->surfaces[0].mesh).volume, 6, 1e-5) << uri;
  }
  std::string outside = file;
  outside.replace(at, end - at, "%2e%2e/outside.bin");
  folder.put("outside.bin", bytes);
  EXPECT_FALSE(importSurfaces(folder.put("in/box.gltf", outside)).ok());
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
