// SPDX-License-Identifier: GPL-3.0-or-later
// Files as other programs write them: each row names the writer and its version, and what is right for it.
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/version.h>
#include <gtest/gtest.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "simcore/import/ImportSurfaces.h"
#include "simcore/mesh/MeshHealth.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/import/PeerFiles.h"
#include "tests/simcore/import/SampleFiles.h"

namespace glenoid {
namespace {

using Names = std::vector<std::string>;

/// What is right for a file; of several surfaces volume and area are of all together.
struct Right {
  Names names{"box"};
  double volume = 6, area = 22;
  double left = 0;         ///< least x of all
  double metres = 0;       ///< per unit; 0: the file does not say
  FileAxes axes = FileAxes::Unsaid;
  long materials = 0, mirrored = 0;
};
struct Row {
  const char *writer, *file;
  std::string bytes;
  Right right;
  const char* refused = nullptr;  ///< words that the refusal holds
};

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

Right inGltf(Right right = {}) {
  right.metres = 1;
  right.axes = FileAxes::YUp;
  return right;
}

std::vector<Row> quantisedAndPacked() {
  std::vector<Row> rows;
  const auto add = [&](const char* writer, const peers::Gltf& like, const Right& right = inGltf(), const char* refused = nullptr) {
    rows.push_back({writer, "a.glb", peers::gltf(like, true), right, refused});
    rows.push_back({writer, "a.gltf", peers::gltf(like, false), right, refused});
  };
  add("gltfpack 1.3.0 -noq", {});
  add("gltfpack 1.3.0, its default (KHR_mesh_quantization)", {.quantised = true});
  add("gltf-transform 4.5.1 quantize", {.normalized = true});
  add("gltfpack 1.3.0 -c (EXT_meshopt_compression, quantised)", {.quantised = true, .packed = true});
  add("gltf-transform 4.5.1 optimize, its default", {.normalized = true, .packed = true});
  add("gltfpack 1.3.0 -c -vpf (exponential filter)", {.packed = true, .exponential = true});
  add("gltfpack -c of a later stream", {.quantised = true, .packed = true, .vertexVersion = 1}, {}, "version 1, newer");
  add("gltfpack 1.3.0, skin", {.quantised = true, .skinned = true}, inGltf({.left = 10}));
  add("gltfpack 1.3.0 -c, skin", {.quantised = true, .packed = true, .skinned = true}, inGltf({.left = 10}));
  // glTF 2.0, 3.7.3.3: the node's own transform does not count.
  add("Blender 3.4, a skin whose node is scaled and moved", {.skinned = true, .node = ",\"scale\":[100,100,100],\"translation\":[1,2,3]"}, inGltf({.left = 10}));
  add("Blender 3.4, mirrored joints", {.skinned = true, .mirroredJoints = true}, inGltf({.left = 9, .mirrored = 1}));
  return rows;
}

std::vector<Row> packages() {
  const std::string box = peers::threeMfMesh();
  const auto one = [&](const std::string& attributes, const std::string& resources, const std::string& build) {
    return peers::threeMf({{"3D/3dmodel.model", peers::threeMfModel(attributes, resources, build)}});
  };
  const std::string object = "<object id=\"1\" type=\"model\" name=\"left humerus\">" + box + "</object>";
  const std::string relation = "<?xml version=\"1.0\"?><Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship Target=\"/3D/Objects/object_1.model\" Id=\"rel-1\" "
                               "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
  const auto bambu = [&](const std::string& path, const std::string& names) {
    std::vector<std::pair<std::string, std::string>> files{
        {"3D/3dmodel.model", peers::threeMfModel("unit=\"millimeter\" requiredextensions=\"p\"",
                                                 "<object id=\"2\" p:UUID=\"1\" type=\"model\"><components><component p:path=\"" + path +
                                                     "\" objectid=\"1\" p:UUID=\"2\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0\"/></components></object>",
                                                 "<item objectid=\"2\" p:UUID=\"3\" transform=\"1 0 0 0 1 0 0 0 1 120 0 0\" printable=\"1\"/>")},
        {"3D/_rels/3dmodel.model.rels", relation},
        {"3D/Objects/object_1.model", peers::threeMfModel("unit=\"millimeter\"", "<object id=\"1\" type=\"model\">" + box + "</object>", "")}};
    if (!names.empty()) files.push_back({"Metadata/model_settings.config", names});
    return peers::threeMf(files);
  };
  const std::string settings = "<?xml version=\"1.0\" encoding=\"UTF-8\"?><config><object id=\"2\"><metadata key=\"name\" value=\"humerus.stl\"/><part id=\"1\" subtype=\"normal_part\">"
                               "<metadata key=\"name\" value=\"H&#252;ftkopf &amp; links\"/></part></object></config>";
  const Right mm{.metres = 1e-3};
  const auto named = [](Names names, Right right) { return right.names = std::move(names), right; };
  Right shifted = mm;
  shifted.left = 120;
  Right two{.names = {"humerus left", "scapula left"}, .volume = 12, .area = 44, .left = -1, .metres = 1e-3, .mirrored = 1};
  Right instances{.names = {"bone", "bone"}, .volume = 12, .area = 44, .left = 0, .metres = 0.0254, .materials = 2};
  return {
      {"lib3mf 2.2, names of objects", "a.3mf", one("unit=\"millimeter\"", object, "<item objectid=\"1\"/>"), named({"left humerus"}, mm)},
      {"PrusaSlicer 2.5, two objects, one of them mirrored", "b.3mf",
       one("", with(object, "left humerus", "humerus left") + with(with(object, "left humerus", "scapula left"), "id=\"1\"", "id=\"7\""),
           "<item objectid=\"1\"/><item objectid=\"7\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"), two},
      {"Microsoft 3D Builder 20, one object twice in a group, materials", "c.3mf",
       one("unit=\"inch\" xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" requiredextensions=\"m\"",
           "<basematerials id=\"5\"><base name=\"a\" displaycolor=\"#FFFFFF\"/><base name=\"b\" displaycolor=\"#000000\"/></basematerials>" + with(object, "left humerus", "bone") +
               "<object id=\"2\"><components><component objectid=\"1\"/><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components></object>",
           "<item objectid=\"2\"/>"), instances},
      {"Bambu Studio 1.9 and OrcaSlicer 2, an object in a model file of its own, names in its settings", "d.3mf", bambu("/3D/Objects/object_1.model", settings),
       named({"Hüftkopf & links"}, shifted)},
      {"Bambu Studio 1.9 without its settings", "e.3mf", bambu("/3D/Objects/object_1.model", ""), named({""}, shifted)},
      {"the same, the file left out", "f.3mf", bambu("/3D/Objects/object_2.model", ""), {}, "object_2.model"},
      {"an object that is its own part", "g.3mf", one("", "<object id=\"1\"><components><component objectid=\"1\"/></components></object>", "<item objectid=\"1\"/>"), {}, "1"},
      {"nothing to be built", "h.3mf", one("", object, ""), {}, "build is empty"},
      {"an extension that changes shapes", "i.3mf",
       one("xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" requiredextensions=\"b\"", object, "<item objectid=\"1\"/>"), {}, "beamlattice"},
  };
}

std::vector<Row> othersOfTableA() {
  const std::string facet = " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n  endloop\n endfacet\n";
  const auto triangle = [](Names names, FileAxes axes = FileAxes::Unsaid) { return Right{.names = std::move(names), .volume = 0, .area = 0.5, .axes = axes}; };
  const Right star{.names = {""}, .volume = peers::starVolume(), .area = peers::starArea(), .left = 30 * std::cos(0.8 * std::numbers::pi)};
  Right starNamed = star;
  starNamed.names = {"star"};
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto stl = [&](const std::string& name) { return "solid " + name + "\n" + facet + "endsolid\n"; };
  std::string upper = samples::stlText();
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  Right nameless;
  nameless.names = {""};
  return {
      {"F2: Blender 3.4, two objects of one first word", "a.obj", points + "o humerus left\nf 1 2 3\no humerus right\nf 1 3 2\n", {.names = {"humerus left", "humerus right"}, .volume = 0, .area = 1}},
      {"F3: Instant Meshes, concave polygons in PLY", "a.ply", peers::starPly(), star},
      {"F3: three.js 0.187 OBJExporter, concave polygons", "b.obj", peers::starObj(), starNamed},
      {"F4: VTK 9.1 vtkPolyDataWriter, field data before the points", "a.vtk", with(samples::vtk(false, true), "POINTS", "FIELD FieldData 1\nMaterialNames 1 1 string\nbone\nPOINTS"), nameless},
      {"F8: Slicer 5", "a.stl", stl("3D Slicer output. SPACE=RAS"), triangle({"3D Slicer output. SPACE=RAS"}, FileAxes::Ras)},
      {"F8: a name of two words", "b.stl", stl("left humerus"), triangle({"left humerus"})},
      {"F11: gmsh 4.8.4, tetrahedra", "b.vtk", peers::gmshVtk(), nameless},
      {"F12: BodyParts3D 4.0", "c.obj", "# English name : left humerus\n# Bounds(mm): (0,0,0)-(1,1,0)\n" + points + "g FJ1234\nf 1 2 3\n", {.names = {"left humerus"}, .volume = 0, .area = 0.5, .metres = 1e-3}},
      {"F13: FreeCAD, capitals", "c.stl", upper, {.names = {"BOX"}}},
      {"F13: bytes behind the end", "d.stl", samples::stlBinary() + std::string(2, '\0'), nameless},
      {"F15: a GLB without materials", "a.glb", peers::gltf({}, true), inGltf()},
      {"F16: Latin-1 in a name", "e.stl", stl("H\xfc" "fte"), triangle({"Hüfte"})},
      {"F18: OBJ without a name", "d.obj", points + "f 1 2 3\n", triangle({""})},
      {"F18: ITK 5.3, which calls every solid ascii", "f.stl", stl("ascii"), triangle({""})},
      {"F18: three.js 0.187, which calls every solid exported", "g.stl", stl("exported"), triangle({""})},
      {"F22: Blender 3.4, COLLADA, Z up", "a.dae", samples::dae("<unit name=\"meter\" meter=\"1\"/>", false), {.metres = 1, .axes = FileAxes::ZUp}},
      {"F9: a buffer that was not sent along", "b.gltf", with(peers::gltf({}, false), "data:application/octet-stream;base64", "left%20humerus.bin?"), {}, "left%20humerus.bin"},
      {"F9: half a file", "h.stl", samples::stlText().substr(0, samples::stlText().size() / 2 + 30), {}, ""},
  };
}

void expectRight(const TemporaryFolder& folder, const Row& row) {
  SCOPED_TRACE(std::string(row.writer) + ", " + row.file);
  const auto file = importSurfaces(folder.put(row.file, row.bytes));
  if (row.refused) {
    ASSERT_FALSE(file.ok());
    const auto& words = file.error().arguments;
    EXPECT_NE(std::accumulate(words.begin(), words.end(), std::string()).find(row.refused), std::string::npos) << toLogLine(file.error());
    return;
  }
  ASSERT_TRUE(file.ok()) << toLogLine(file.error());
  Names names;
  double volume = 0, area = 0;
  Box3 box;
  for (const ImportedSurface& surface : file->surfaces) {
    names.push_back(surface.name);
    const MeshHealth health = healthOf(surface.mesh);
    volume += health.volume;
    for (const auto& t : surface.mesh.triangles)
      area += (surface.mesh.vertices[t[1]] - surface.mesh.vertices[t[0]]).cross(surface.mesh.vertices[t[2]] - surface.mesh.vertices[t[0]]).norm() / 2;
    box.extend(boundsOf(surface.mesh));
  }
  EXPECT_EQ(names, row.right.names);
  // 16-bit integers hold a unit to some 1e-4.
  EXPECT_NEAR(volume, row.right.volume, 2e-4 * std::max(1.0, row.right.volume));
  EXPECT_NEAR(area, row.right.area, 2e-4 * row.right.area);
  EXPECT_NEAR(box.min().x(), row.right.left, 1e-4);
  EXPECT_EQ(file->metresPerUnit.value_or(0), row.right.metres);
  EXPECT_STREQ(fileAxesName(file->axes), fileAxesName(row.right.axes));
  long materials = 0, mirrored = 0;
  for (const NoteCount& note : file->notes) {
    if (note.note == ImportNote::MaterialsDropped) materials = note.count;
    if (note.note == ImportNote::NodesMirrored) mirrored = note.count;
  }
  EXPECT_EQ(materials, row.right.materials);
  EXPECT_EQ(mirrored, row.right.mirrored);
}

TEST(PeerFormats, quantisedPackedAndSkinnedGltf) {
  const TemporaryFolder folder;
  for (const Row& row : quantisedAndPacked()) expectRight(folder, row);
}

TEST(PeerFormats, threeMfOfSlicers) {
  const TemporaryFolder folder;
  for (const Row& row : packages()) expectRight(folder, row);
}

TEST(PeerFormats, everyOtherRow) {
  const TemporaryFolder folder;
  for (const Row& row : othersOfTableA()) expectRight(folder, row);
}

// Debian's own assimp writes the box in each format that it can, and its files come back the same.
TEST(PeerFormats, whatAssimpWrites) {
  const TemporaryFolder folder;
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_TEXCOORDS);  // so that faces share points
  const aiScene* scene = importer.ReadFile(folder.put("source.obj", with(samples::obj(), "mtllib nowhere.mtl\n", "")),
                                           aiProcess_Triangulate | aiProcess_RemoveComponent | aiProcess_JoinIdenticalVertices);
  ASSERT_TRUE(scene);
  const std::string version = "assimp " + std::to_string(aiGetVersionMajor()) + "." + std::to_string(aiGetVersionMinor()) + "." + std::to_string(aiGetVersionPatch());
  for (const auto& [format, name] : {std::pair{"obj", "b.obj"}, {"stl", "b.stl"}, {"stlb", "c.stl"}, {"ply", "b.ply"}, {"plyb", "c.ply"}, {"gltf2", "b.gltf"}, {"glb2", "b.glb"},
                                     {"collada", "b.dae"}, {"3mf", "b.3mf"}, {"fbxa", "b.fbx"}}) {
    Assimp::Exporter exporter;
    ASSERT_EQ(exporter.Export(scene, format, folder.path(name)), aiReturn_SUCCESS) << version << " " << format << ": " << exporter.GetErrorString();
    const auto file = importSurfaces(folder.path(name));
    ASSERT_TRUE(file.ok()) << version << " " << format << ": " << toLogLine(file.error());
    ASSERT_EQ(file->surfaces.size(), 1u) << format;
    EXPECT_EQ(healthOf(file->surfaces[0].mesh).openEdges, 0) << format;
    EXPECT_NEAR(healthOf(file->surfaces[0].mesh).volume, 6, 1e-4) << format;
  }
}

}  // namespace
}  // namespace glenoid
