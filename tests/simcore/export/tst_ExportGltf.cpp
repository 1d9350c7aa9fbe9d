// SPDX-License-Identifier: GPL-3.0-or-later
// GLB taken apart by its chunks, and loaded by assimp.
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/simcore/export/Exported.h"

#ifdef GLENOID_ASSIMP
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#endif

namespace glenoid {
namespace {

using Json = nlohmann::json;

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  if (at + 4 <= bytes.size()) std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

struct Glb {
  Json json;
  std::string buffer;
};
Glb parseGlb(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(bytes, 4), 2u);
  EXPECT_EQ(word(bytes, 8), bytes.size());
  const std::uint32_t jsonSize = word(bytes, 12);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(jsonSize % 4, 0u);
  const std::size_t second = 20 + jsonSize;
  EXPECT_EQ(bytes.substr(second + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(word(bytes, second) % 4, 0u);
  EXPECT_EQ(second + 8 + word(bytes, second), bytes.size());
  return {Json::parse(bytes.substr(20, jsonSize), nullptr, false), bytes.substr(second + 8)};
}

/// Values of an accessor, with its bounds checked.
template <class T>
std::vector<T> valuesOf(const Glb& glb, int index) {
  const Json& accessor = glb.json["accessors"][index];
  const Json& view = glb.json["bufferViews"][accessor["bufferView"].get<int>()];
  const std::size_t per = accessor["type"] == "VEC3" ? 3 : 1, count = per * accessor["count"].get<std::size_t>();
  EXPECT_EQ(accessor["componentType"], (std::is_same_v<T, float> ? 5126 : 5125));
  EXPECT_EQ(view["byteLength"].get<std::size_t>(), count * sizeof(T));
  EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
  EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(), glb.buffer.size());
  std::vector<T> values(count);
  std::memcpy(values.data(), glb.buffer.data() + view["byteOffset"].get<std::size_t>(), count * sizeof(T));
  return values;
}

TEST(ExportGltf, surfacesComeBackInSinglePrecision) {
  const Joint joint = richJoint();
  const Exported file(joint, ExportFormat::Glb);
  const Glb glb = parseGlb(file.text);
  ASSERT_TRUE(glb.json.is_object());
  EXPECT_EQ(glb.json["asset"]["version"], "2.0");
  EXPECT_EQ(glb.json["buffers"][0]["byteLength"].get<std::size_t>(), glb.buffer.size());
  ASSERT_EQ(glb.json["nodes"].size(), 2 * joint.parts.size());
  EXPECT_EQ(glb.json["scenes"][0]["nodes"].size(), 2 * joint.parts.size());
  for (std::size_t n = 0; n < glb.json["nodes"].size(); ++n) {
    const Part& part = joint.parts[n / 2];
    const TriMesh& mesh = n % 2 ? *part.collision : *part.visual;
    EXPECT_EQ(glb.json["nodes"][n]["name"], n % 2 ? part.id + ".collision" : part.id);
    const Json& primitive = glb.json["meshes"][glb.json["nodes"][n]["mesh"].get<int>()]["primitives"][0];
    const auto positions = valuesOf<float>(glb, primitive["attributes"]["POSITION"]);
    const auto normals = valuesOf<float>(glb, primitive["attributes"]["NORMAL"]);
    const auto indices = valuesOf<std::uint32_t>(glb, primitive["indices"]);
    ASSERT_EQ(positions.size(), 3 * mesh.vertices.size());
    ASSERT_EQ(normals.size(), positions.size());
    ASSERT_EQ(indices.size(), 3 * mesh.triangles.size());
    Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9f), high = -low;
    const Vec3 centre = boundsOf(mesh).center();
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const Eigen::Vector3f x(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
      const Eigen::Vector3f n_W(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
      EXPECT_EQ(x, mesh.vertices[v].cast<float>());
      EXPECT_NEAR(n_W.norm(), 1, 1e-6);
      EXPECT_GT(n_W.dot((mesh.vertices[v] - centre).cast<float>()), 0) << "a box's normals point out";
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    const Json& bounds = glb.json["accessors"][primitive["attributes"]["POSITION"].get<int>()];
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(bounds["min"][k].get<float>(), low[k]);
      EXPECT_EQ(bounds["max"][k].get<float>(), high[k]);
    }
    for (std::size_t i = 0; i < indices.size(); ++i) EXPECT_EQ(static_cast<int>(indices[i]), mesh.triangles[i / 3][i % 3]);
    const auto& color = glb.json["materials"][primitive["material"].get<int>()]["pbrMetallicRoughness"]["baseColorFactor"];
    ASSERT_EQ(color.size(), 4u);
    // 0.8 in sRGB is 0.604 linear (IEC 61966-2-1).
    EXPECT_NEAR(color[0].get<double>(), 0.6038, 1e-3);
  }
  EXPECT_EQ(file.lost(LossKind::Precision), 1);
  EXPECT_EQ(file.lost(LossKind::Volumes), 1);
}

TEST(ExportGltf, assimpReadsIt) {
#ifdef GLENOID_ASSIMP
  const Joint joint = richJoint();
  const Exported file(joint, ExportFormat::Glb);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(file.text.data(), file.text.size(), aiProcess_ValidateDataStructure, "glb");
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumMeshes, 2 * joint.parts.size());
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const TriMesh& mesh = m % 2 ? *joint.parts[m / 2].collision : *joint.parts[m / 2].visual;
    EXPECT_EQ(scene->mMeshes[m]->mNumVertices, mesh.vertices.size());
    EXPECT_EQ(scene->mMeshes[m]->mNumFaces, mesh.triangles.size());
    EXPECT_EQ(scene->mMeshes[m]->mVertices[0].x, static_cast<float>(mesh.vertices[0].x()));
  }
#else
  FAIL() << "assimp was not found; its development package is in resources/packaging/packages-debian12.txt";
#endif
}

}  // namespace
}  // namespace glenoid
