// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/gltf/GltfPlain.h"

#include <algorithm>
#include <bit>

#include "simcore/file/ByteReader.h"
#include "simcore/file/Json.h"
#include "simcore/import/AssimpRead.h"
#include "simcore/import/gltf/GltfFile.h"
#include "simcore/import/gltf/GltfNodes.h"

namespace glenoid {
namespace {

using Items = std::vector<JsonValue>;
constexpr int kFloat = 5126;

JsonValue arrayOf(const Items& items) {
  JsonValue out = JsonValue::array();
  for (const JsonValue& item : items) out.append(item);
  return out;
}

JsonValue objectOf(std::initializer_list<std::pair<const char*, JsonValue>> members) {
  JsonValue out = JsonValue::object();
  for (const auto& [key, value] : members) out.set(key, value);
  return out;
}

bool isPacked(const JsonValue& view) { return view["extensions"]["EXT_meshopt_compression"].isObject(); }
bool isDraco(const JsonValue& primitive) { return primitive["extensions"]["KHR_draco_mesh_compression"].isObject(); }
bool isShape(std::string_view attribute) { return attribute == "POSITION" || attribute == "NORMAL" || attribute == "TANGENT" || attribute.starts_with("TEXCOORD_"); }

class Writer {
 public:
  Writer(GltfFile& file, std::string path)
      : m_file(file), m_path(std::move(path)), m_views(file.json()["bufferViews"].items()), m_accessors(file.json()["accessors"].items()),
        m_meshes(file.json()["meshes"].items()), m_nodes(file.json()["nodes"].items()), m_scenes(file.json()["scenes"].items()),
        m_buffer(static_cast<std::int64_t>(file.json()["buffers"].items().size())) {}

  bool needed() const {
    const auto skinned = [](const JsonValue& node) { return node["skin"].isInteger() && node["mesh"].isInteger(); };
    if (std::any_of(m_views.begin(), m_views.end(), isPacked) || std::any_of(m_nodes.begin(), m_nodes.end(), skinned)) return true;
    for (const JsonValue& mesh : m_meshes)
      for (const JsonValue& primitive : mesh["primitives"].items())
        if (!isDraco(primitive) && typeOf(primitive["attributes"]["POSITION"].integer(-1)) != kFloat) return true;
    return false;
  }

  Result<PlainGltf> write(bool binary) {
    for (const auto step : {&Writer::unpackViews, &Writer::makeFloats, &Writer::placeSkins})
      if (const auto done = (this->*step)(); !done) return done.error();
    JsonValue json = m_file.json();
    Items buffers = json["buffers"].items();
    for (std::size_t i = 0; i < buffers.size(); ++i)
      if (buffers[i]["uri"].isNull() && !(i == 0 && !m_file.binaryChunk().empty())) buffers[i] = objectOf({{"byteLength", 0}});  // a fallback that was left out
    buffers.push_back(objectOf({{"uri", kBesideName}, {"byteLength", static_cast<std::int64_t>(m_out.beside.size())}}));
    json.set("buffers", arrayOf(buffers));
    json.set("bufferViews", arrayOf(m_views));
    json.set("accessors", arrayOf(m_accessors));
    json.set("meshes", arrayOf(m_meshes));
    json.set("nodes", arrayOf(m_nodes));
    if (!m_scenes.empty()) json.set("scenes", arrayOf(m_scenes));
    std::string text = toText(json);
    m_out.bytes = binary ? packed(std::move(text)) : std::move(text);
    return std::move(m_out);
  }

 private:
  int typeOf(std::int64_t accessor) const {
    const bool there = accessor >= 0 && accessor < static_cast<std::int64_t>(m_accessors.size());
    return there ? static_cast<int>(m_accessors[static_cast<std::size_t>(accessor)]["componentType"].integer(kFloat)) : kFloat;
  }

  /// A view of bytes that go to the buffer beside.
  JsonValue viewOf(std::string_view bytes, std::int64_t stride) {
    while (m_out.beside.size() % 4 != 0) m_out.beside += '\0';
    JsonValue view = objectOf({{"buffer", m_buffer}, {"byteOffset", static_cast<std::int64_t>(m_out.beside.size())}, {"byteLength", static_cast<std::int64_t>(bytes.size())}});
    if (stride > 0) view.set("byteStride", stride);
    m_out.beside.append(bytes);
    return view;
  }

  Result<Done> unpackViews() {
    for (std::size_t i = 0; i < m_views.size(); ++i) {
      if (!isPacked(m_views[i])) continue;
      const auto bytes = m_file.view(static_cast<std::int64_t>(i));
      if (!bytes) return bytes.error();
      m_views[i] = viewOf(*bytes, m_views[i]["byteStride"].integer(0));
    }
    return Done{};
  }

  std::int64_t addAccessor(const Eigen::MatrixXd& values) {
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(4 * values.size()));
    for (Eigen::Index i = 0; i < values.cols(); ++i)
      for (Eigen::Index r = 0; r < values.rows(); ++r) appendBytes(static_cast<float>(values(r, i)), std::endian::little, bytes);
    m_views.push_back(viewOf(bytes, 0));
    static constexpr const char* kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    m_accessors.push_back(objectOf({{"bufferView", static_cast<std::int64_t>(m_views.size() - 1)}, {"componentType", kFloat},
                                    {"count", static_cast<std::int64_t>(values.cols())}, {"type", kTypes[values.rows()]}}));
    return static_cast<std::int64_t>(m_accessors.size() - 1);
  }

  /// The same attributes with floats in place of integers.
  Result<JsonValue> asFloats(const JsonValue& attributes) {
    JsonValue out = attributes;
    for (const auto& [name, value] : attributes.members()) {
      const std::int64_t old = value.integer(-1);
      if (!isShape(name) || typeOf(old) == kFloat) continue;
      if (const auto known = m_floats.find(old); known != m_floats.end()) {
        out.set(name, known->second);
        continue;
      }
      const auto values = m_file.values(old);
      if (!values) return values.error();
      if (values->rows() > 4) return m_file.bad("an attribute of it is a matrix");
      out.set(name, m_floats[old] = addAccessor(*values));
    }
    return out;
  }

  Result<Done> makeFloats() {
    for (JsonValue& mesh : m_meshes) {
      Items primitives = mesh["primitives"].items();
      for (JsonValue& primitive : primitives) {
        if (isDraco(primitive)) continue;
        auto attributes = asFloats(primitive["attributes"]);
        if (!attributes) return attributes.error();
        primitive.set("attributes", std::move(*attributes));
        if (primitive["targets"].isNull()) continue;
        Items targets = primitive["targets"].items();
        for (JsonValue& target : targets) {
          auto moved = asFloats(target);
          if (!moved) return moved.error();
          target = std::move(*moved);
        }
        primitive.set("targets", arrayOf(targets));
      }
      mesh.set("primitives", arrayOf(primitives));
    }
    return Done{};
  }

  /// Surfaces with a skin become nodes of their own at the root, with points where the joints put them.
  Result<Done> placeSkins() {
    const auto skinned = [](const JsonValue& node) { return node["skin"].isInteger() && node["mesh"].isInteger(); };
    if (std::none_of(m_nodes.begin(), m_nodes.end(), skinned)) return Done{};
    const auto nodes = placeNodes(m_file, m_path);
    if (!nodes) return nodes.error();
    const std::size_t count = m_nodes.size();
    Items added;
    for (std::size_t i = 0; i < count; ++i) {
      if (!skinned(m_nodes[i])) continue;
      auto placed = placeSkin(m_nodes[i], *nodes);
      if (!placed) return placed.error();
      m_nodes[i].erase("mesh");
      m_nodes[i].erase("skin");
      if (!nodes->shown[i] || nodes->scene < 0) continue;
      m_nodes.push_back(std::move(*placed));
      added.push_back(JsonValue(static_cast<std::int64_t>(m_nodes.size() - 1)));
    }
    if (added.empty()) return Done{};
    JsonValue& scene = m_scenes[static_cast<std::size_t>(nodes->scene)];
    Items tops = scene["nodes"].items();
    tops.insert(tops.end(), added.begin(), added.end());
    scene.set("nodes", arrayOf(tops));
    return Done{};
  }

  Result<JsonValue> placeSkin(const JsonValue& node, const GltfNodes& nodes) {
    const auto& skins = m_file.json()["skins"].items();
    const std::int64_t skin = node["skin"].integer(), mesh = node["mesh"].integer();
    if (skin < 0 || skin >= static_cast<std::int64_t>(skins.size()) || mesh < 0 || mesh >= static_cast<std::int64_t>(m_meshes.size()))
      return m_file.bad("a node names a skin or a mesh that is not in it");
    JsonValue moved = m_meshes[static_cast<std::size_t>(mesh)];
    Items primitives = moved["primitives"].items();
    std::vector<SkinnedPoints> points;
    std::size_t mirrored = 0;
    for (const JsonValue& primitive : m_file.json()["meshes"][static_cast<std::size_t>(mesh)]["primitives"].items()) {
      if (isDraco(primitive)) return m_file.bad("a surface of it has a skin and is packed by KHR_draco_mesh_compression, which is not read together: write it without one of them");
      auto placed = skinnedPoints(m_file, nodes, skins[static_cast<std::size_t>(skin)], primitive["attributes"]);
      if (!placed) return placed.error();
      mirrored += placed->mirrored;
      points.push_back(std::move(*placed));
    }
    // What joints mirror stands as its image in a node that mirrors, so that the reader turns its triangles.
    const bool image = 2 * mirrored > points.size();
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      if (image) points[k].points.row(0) *= -1;
      JsonValue attributes = JsonValue::object();
      for (const auto& [name, value] : primitives[k]["attributes"].members())
        if (!name.starts_with("JOINTS_") && !name.starts_with("WEIGHTS_")) attributes.set(name, value);
      attributes.set("POSITION", addAccessor(points[k].points));
      primitives[k].set("attributes", std::move(attributes));
      m_out.lost += static_cast<long>(primitives[k]["targets"].items().size());
      primitives[k].erase("targets");
    }
    moved.set("primitives", arrayOf(primitives));
    m_meshes.push_back(std::move(moved));
    ++m_out.skins;
    m_out.lost += static_cast<long>(skins[static_cast<std::size_t>(skin)]["joints"].items().size());
    JsonValue own = objectOf({{"mesh", static_cast<std::int64_t>(m_meshes.size() - 1)}});
    if (!node["name"].isNull()) own.set("name", node["name"]);
    if (image) own.set("scale", arrayOf({JsonValue(-1), JsonValue(1), JsonValue(1)}));
    return own;
  }

  std::string packed(std::string json) const {
    while (json.size() % 4 != 0) json += ' ';
    const std::string_view chunk = m_file.binaryChunk();
    const std::size_t whole = 20 + json.size() + (chunk.empty() ? 0 : 8 + chunk.size());
    std::string out = "glTF";
    for (const std::size_t number : {std::size_t{2}, whole, json.size()}) appendBytes(static_cast<std::uint32_t>(number), std::endian::little, out);
    out += "JSON" + json;
    if (chunk.empty()) return out;
    appendBytes(static_cast<std::uint32_t>(chunk.size()), std::endian::little, out);
    return out.append("BIN\0", 4).append(chunk);
  }

  GltfFile& m_file;
  std::string m_path;
  Items m_views, m_accessors, m_meshes, m_nodes, m_scenes;
  std::int64_t m_buffer;
  std::map<std::int64_t, std::int64_t> m_floats;  ///< accessors of floats by those of integers
  PlainGltf m_out;
};

}  // namespace

Result<std::optional<PlainGltf>> plainGltf(std::string_view bytes, const std::string& path, bool binary) {
  Result<GltfFile> file = GltfFile::open(bytes, path, binary);
  if (!file) return std::optional<PlainGltf>();  // the reader behind judges it
  Writer writer(*file, path);
  if (!writer.needed()) return std::optional<PlainGltf>();
  Result<PlainGltf> plain = writer.write(binary);
  if (!plain) return plain.error();
  return std::optional<PlainGltf>(std::move(*plain));
}

}  // namespace glenoid
