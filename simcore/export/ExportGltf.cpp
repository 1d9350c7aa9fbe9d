// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "simcore/export/ExportParts.h"
#include "simcore/file/Json.h"

namespace glenoid::exporting {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little endian");

constexpr int kFloat = 5126, kUnsignedInt = 5125, kArrayBuffer = 34962, kElementBuffer = 34963;

double linearOf(float srgb) { return srgb <= 0.04045f ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

std::vector<Vec3> smoothNormals(const TriMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles) {
    const Vec3 area = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    for (const int v : t) normals[v] += area;
  }
  for (Vec3& normal : normals) normal = normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitY());
  return normals;
}

JsonValue pair(const char* key, JsonValue value) {
  JsonValue json = JsonValue::object();
  json.set(key, std::move(value));
  return json;
}

/// The JSON of the file and its one buffer.
class Builder {
 public:
  /// Answers the accessor of the values, which are appended to the buffer.
  int points(const std::vector<Vec3>& values, bool bounds) {
    std::vector<float> floats;
    floats.reserve(3 * values.size());
    Eigen::Vector3f low = Eigen::Vector3f::Constant(INFINITY), high = -low;
    for (const Vec3& value : values) {
      const Eigen::Vector3f x = value.cast<float>();
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
      floats.insert(floats.end(), {x.x(), x.y(), x.z()});
    }
    JsonValue accessor = accessorOf(floats, values.size(), "VEC3", kFloat, kArrayBuffer);
    const auto list = [](const Eigen::Vector3f& x) {
      JsonValue json = JsonValue::array();
      for (int k = 0; k < 3; ++k) json.append(static_cast<double>(x[k]));
      return json;
    };
    if (bounds) {
      accessor.set("min", list(low));
      accessor.set("max", list(high));
    }
    return push(m_accessors, std::move(accessor));
  }
  int indices(const std::vector<std::array<int, 3>>& triangles) {
    std::vector<std::uint32_t> flat;
    flat.reserve(3 * triangles.size());
    for (const auto& t : triangles)
      for (const int v : t) flat.push_back(static_cast<std::uint32_t>(v));
    return push(m_accessors, accessorOf(flat, flat.size(), "SCALAR", kUnsignedInt, kElementBuffer));
  }
  int material(const Part& part) {
    JsonValue color = JsonValue::array();
    for (const float channel : part.color) color.append(linearOf(channel));
    color.append(1.0);
    JsonValue shading = pair("baseColorFactor", std::move(color));
    shading.set("metallicFactor", 0.0);
    shading.set("roughnessFactor", 0.6);
    JsonValue json = pair("name", part.id);
    json.set("pbrMetallicRoughness", std::move(shading));
    return push(m_materials, std::move(json));
  }
  /// A mesh with a node that shows it.
  void surface(const std::string& name, const TriMesh& mesh, int material) {
    JsonValue attributes = pair("POSITION", points(mesh.vertices, true));
    attributes.set("NORMAL", points(smoothNormals(mesh), false));
    JsonValue primitive = pair("attributes", std::move(attributes));
    primitive.set("indices", indices(mesh.triangles));
    primitive.set("material", material);
    JsonValue primitives = JsonValue::array();
    primitives.append(std::move(primitive));
    JsonValue json = pair("name", name);
    json.set("primitives", std::move(primitives));
    JsonValue node = pair("name", name);
    node.set("mesh", push(m_meshes, std::move(json)));
    m_roots.append(push(m_nodes, std::move(node)));
  }
  std::string file(const Joint& joint) {
    JsonValue asset = pair("version", "2.0");
    asset.set("generator", "Glenoid Studio");
    if (!joint.provenance.license.empty()) asset.set("copyright", joint.provenance.license);
    JsonValue json = pair("asset", std::move(asset));
    JsonValue scene = pair("name", joint.id);
    scene.set("nodes", m_roots);
    JsonValue scenes = JsonValue::array(), buffers = JsonValue::array();
    scenes.append(std::move(scene));
    buffers.append(pair("byteLength", static_cast<long>(m_buffer.size())));
    json.set("scene", 0);
    json.set("scenes", std::move(scenes));
    json.set("nodes", m_nodes);
    json.set("meshes", m_meshes);
    json.set("materials", m_materials);
    json.set("accessors", m_accessors);
    json.set("bufferViews", m_views);
    json.set("buffers", std::move(buffers));
    std::string text = toText(json);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string out;
    const auto word = [&](std::uint32_t value) { out.append(reinterpret_cast<const char*>(&value), 4); };
    out += "glTF";
    word(2);
    word(static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + m_buffer.size()));
    word(static_cast<std::uint32_t>(text.size()));
    out += "JSON";
    out += text;
    word(static_cast<std::uint32_t>(m_buffer.size()));
    out.append("BIN\0", 4);
    return out + m_buffer;
  }
  std::size_t bytes() const { return m_buffer.size(); }

 private:
  static int push(JsonValue& list, JsonValue item) {
    list.append(std::move(item));
    return static_cast<int>(list.items().size()) - 1;
  }
  template <class T>
  JsonValue accessorOf(const std::vector<T>& values, std::size_t count, const char* type, int component, int target) {
    JsonValue view = pair("buffer", 0);
    view.set("byteOffset", static_cast<long>(m_buffer.size()));
    view.set("byteLength", static_cast<long>(values.size() * sizeof(T)));
    view.set("target", target);
    m_buffer.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));  // four bytes each: aligned
    JsonValue accessor = pair("bufferView", push(m_views, std::move(view)));
    accessor.set("componentType", component);
    accessor.set("count", static_cast<long>(count));
    accessor.set("type", type);
    return accessor;
  }

  std::string m_buffer;
  JsonValue m_nodes = JsonValue::array(), m_meshes = JsonValue::array(), m_materials = JsonValue::array(),
            m_accessors = JsonValue::array(), m_views = JsonValue::array(), m_roots = JsonValue::array();
};

}  // namespace

Result<Written> writeGltf(const Joint& joint) {
  Written out;
  Builder builder;
  long named = 0, volumes = 0;
  for (const Part& part : joint.parts) {
    const int material = builder.material(part);
    for (const auto& [mesh, name] : {std::pair{part.visual, part.id}, std::pair{part.collision, part.id + ".collision"}}) {
      builder.surface(name, *mesh, material);
      out.report.nodes += static_cast<long>(mesh->vertices.size());
      out.report.triangles += static_cast<long>(mesh->triangles.size());
    }
    named += static_cast<long>(part.regions.size() + part.landmarks.size());
    volumes += part.volume != nullptr;
  }
  constexpr std::size_t kMost = 0xffffffffu - (64u << 20);
  if (builder.bytes() > kMost)
    return Error{Fault::FileTooLarge, {}, {std::to_string(builder.bytes()) + " bytes", std::to_string(kMost) + " bytes"}, "glb"};
  out.bytes = builder.file(joint);
  out.lose(LossKind::Precision);
  out.lose(LossKind::Volumes, volumes);
  out.lose(LossKind::Materials, static_cast<long>(joint.materials.size()));
  out.lose(LossKind::Couplings, static_cast<long>(joint.couplings.size()));
  out.lose(LossKind::Exclusions, static_cast<long>(joint.exclusions.size()));
  out.lose(LossKind::Bursae, static_cast<long>(joint.bursae.size()));
  out.lose(LossKind::Regions, named);
  out.lose(LossKind::Cages, static_cast<long>(joint.cages.size()));
  return out;
}

}  // namespace glenoid::exporting
