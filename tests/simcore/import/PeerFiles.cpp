// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/import/PeerFiles.h"

#include <meshoptimizer.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <sstream>

#include "simcore/file/ByteReader.h"
#include "tests/simcore/import/SampleFiles.h"

namespace glenoid::peers {
namespace {

constexpr std::array<std::array<int, 4>, 6> kQuads{{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
std::array<double, 3> corner(int i) { return {i & 1 ? 1.0 : 0.0, i & 2 ? 2.0 : 0.0, i & 4 ? 3.0 : 0.0}; }

std::vector<unsigned> indices() {
  std::vector<unsigned> list;
  for (const auto& q : kQuads)
    for (const int k : {0, 1, 2, 0, 2, 3}) list.push_back(static_cast<unsigned>(q[static_cast<std::size_t>(k)]));
  return list;
}

template <class T>
void put(std::string& out, T value) {
  appendBytes<T>(value, std::endian::little, out);
}

/// Buffer views of a glTF, packed or not, and the bytes behind them.
class Views {
 public:
  explicit Views(bool packed) : m_packed(packed) {}

  void add(const std::string& plain, std::size_t count, std::size_t stride, const char* mode, const char* filter, int version) {
    const std::string size = "\"byteLength\":" + std::to_string(plain.size()) + (std::string_view(mode) == "ATTRIBUTES" ? ",\"byteStride\":" + std::to_string(stride) : "");
    if (!m_packed) {
      m_json += std::string(m_json.empty() ? "" : ",") + "{\"buffer\":0,\"byteOffset\":" + std::to_string(m_bytes.size()) + "," + size + "}";
      m_bytes += plain;
    } else {
      const std::string packed = pack(plain, count, stride, mode, version);
      m_json += std::string(m_json.empty() ? "" : ",") + "{\"buffer\":1,\"byteOffset\":" + std::to_string(m_whole) + "," + size +
                ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":" + std::to_string(m_bytes.size()) + ",\"byteLength\":" + std::to_string(packed.size()) +
                ",\"byteStride\":" + std::to_string(stride) + ",\"count\":" + std::to_string(count) + ",\"mode\":\"" + mode + "\"" +
                (*filter ? std::string(",\"filter\":\"") + filter + "\"" : "") + "}}}";
      m_bytes += packed;
      m_whole += plain.size();
    }
    while (m_bytes.size() % 4 != 0) m_bytes += '\0';
  }
  const std::string& json() const { return m_json; }
  const std::string& bytes() const { return m_bytes; }
  std::size_t whole() const { return m_whole; }

 private:
  static std::string pack(const std::string& plain, std::size_t count, std::size_t stride, const std::string& mode, int version) {
    std::string out(4096, '\0');
    auto* to = reinterpret_cast<unsigned char*>(out.data());
    if (mode == "TRIANGLES") {
      std::vector<unsigned> list;
      for (std::size_t i = 0; i < count; ++i) {
        std::uint16_t value = 0;
        std::memcpy(&value, plain.data() + 2 * i, 2);
        list.push_back(value);
      }
      out.resize(meshopt_encodeIndexBuffer(to, out.size(), list.data(), count));
    } else {
      out.resize(meshopt_encodeVertexBuffer(to, out.size(), plain.data(), count, stride));
      out[0] = static_cast<char>(0xa0 | version);
    }
    return out;
  }
  bool m_packed;
  std::string m_json, m_bytes;
  std::size_t m_whole = 0;
};

std::string accessor(int view, int type, std::size_t count, const char* shape, bool normalized = false) {
  return "{\"bufferView\":" + std::to_string(view) + ",\"componentType\":" + std::to_string(type) + ",\"count\":" + std::to_string(count) + ",\"type\":\"" + shape + "\"" +
         (normalized ? ",\"normalized\":true" : "") + "}";
}

}  // namespace

std::string gltf(const Gltf& like, bool binary) {
  const bool integers = like.quantised || like.normalized;
  // Integers stand for 1/10000 of a unit, or for shares of 4 units; the node, or the inverse bind matrices, turn them back.
  const double step = like.normalized ? 4.0 / 65535 : 1e-4;
  Views views(like.packed);
  std::string points, corners, joints, weights, binds;
  std::vector<float> floats;
  for (int i = 0; i < 8; ++i) {
    for (const double x : corner(i)) {
      if (integers) put(points, static_cast<std::uint16_t>(std::lround(x / step)));
      else put(points, static_cast<float>(x)), floats.push_back(static_cast<float>(x));
    }
    if (integers) put<std::uint16_t>(points, 0);
    for (const int j : {0, 1, 0, 0}) put(joints, static_cast<std::uint8_t>(j));
    for (const int w : {127, 127, 0, 0}) put(weights, static_cast<std::uint8_t>(w));
  }
  const bool filtered = like.packed && like.exponential && !integers;
  if (filtered) meshopt_encodeFilterExp(points.data(), 8, 12, 24, floats.data());
  for (const unsigned i : indices()) put(corners, static_cast<std::uint16_t>(i));
  views.add(points, 8, integers ? 8 : 12, "ATTRIBUTES", filtered ? "EXPONENTIAL" : "", like.vertexVersion);
  views.add(corners, 36, 2, "TRIANGLES", "", 1);
  std::string accessors = accessor(0, integers ? 5123 : 5126, 8, "VEC3", like.normalized) + "," + accessor(1, 5123, 36, "SCALAR");
  std::string attributes = "\"POSITION\":0", skins, more;
  const std::string scale = integers ? std::to_string(like.normalized ? 4.0 : step) : "1";
  if (like.skinned) {
    for (int j = 0; j < 2; ++j)
      for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) put(binds, static_cast<float>(r != c ? 0 : r == 3 ? 1 : integers ? std::stod(scale) : 1));
    views.add(joints, 8, 4, "ATTRIBUTES", "", 0);
    views.add(weights, 8, 4, "ATTRIBUTES", "", 0);
    views.add(binds, 2, 64, "ATTRIBUTES", "", 0);
    accessors += "," + accessor(2, 5121, 8, "VEC4") + "," + accessor(3, 5121, 8, "VEC4", true) + "," + accessor(4, 5126, 2, "MAT4");
    attributes += ",\"JOINTS_0\":2,\"WEIGHTS_0\":3";
    skins = ",\"skins\":[{\"joints\":[1,2],\"inverseBindMatrices\":4}]";
    const std::string mirror = like.mirroredJoints ? ",\"scale\":[-1,1,1]" : "";
    more = ",{\"name\":\"bone\",\"translation\":[5,0,0],\"children\":[2]" + (like.mirroredJoints ? ",\"scale\":[-1,1,1]" : std::string()) + "},{\"name\":\"bone\",\"translation\":[" +
           (like.mirroredJoints ? "-10" : "10") + ",0,0]}";
  }
  const std::string own = like.skinned ? ",\"skin\":0" : integers ? ",\"scale\":[" + scale + "," + scale + "," + scale + "]" : "";
  std::string required;
  if (integers) required += "\"KHR_mesh_quantization\"";
  if (like.packed) required += std::string(required.empty() ? "" : ",") + "\"EXT_meshopt_compression\"";
  const std::string uri = binary ? "" : ",\"uri\":\"data:application/octet-stream;base64," + samples::base64(views.bytes()) + "\"";
  std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"gltfpack 1.3\"}" + (required.empty() ? "" : ",\"extensionsUsed\":[" + required + "],\"extensionsRequired\":[" + required + "]") +
                     ",\"scene\":0,\"scenes\":[{\"nodes\":[0" + (like.skinned ? ",1" : "") + "]}],\"nodes\":[{\"name\":\"box\",\"mesh\":0" + own + like.node + "}" + more +
                     "],\"meshes\":[{\"primitives\":[{\"attributes\":{" + attributes + "},\"indices\":1}]}]" + skins + ",\"accessors\":[" + accessors + "],\"bufferViews\":[" + views.json() +
                     "],\"buffers\":[{\"byteLength\":" + std::to_string(views.bytes().size()) + uri + "}" +
                     (like.packed ? ",{\"byteLength\":" + std::to_string(views.whole()) + ",\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}" : "") + "]}";
  if (!binary) return json;
  while (json.size() % 4 != 0) json += ' ';
  std::string out = "glTF";
  for (const std::size_t number : {std::size_t{2}, 28 + json.size() + views.bytes().size(), json.size()}) put(out, static_cast<std::uint32_t>(number));
  out += "JSON" + json;
  put(out, static_cast<std::uint32_t>(views.bytes().size()));
  return out.append("BIN\0", 4) + views.bytes();
}

std::string threeMf(const std::vector<std::pair<std::string, std::string>>& models, bool deflate) {
  std::vector<std::pair<std::string, std::string>> members{
      {"[Content_Types].xml", R"(<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)"},
      {"_rels/.rels", R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"}};
  members.insert(members.end(), models.begin(), models.end());
  return samples::zipped(members, deflate);
}

std::string threeMfMesh() {
  std::ostringstream out;
  out << "<mesh><vertices>";
  for (int i = 0; i < 8; ++i) out << "<vertex x=\"" << corner(i)[0] << "\" y=\"" << corner(i)[1] << "\" z=\"" << corner(i)[2] << "\"/>";
  out << "</vertices><triangles>";
  const auto list = indices();
  for (std::size_t i = 0; i < list.size(); i += 3) out << "<triangle v1=\"" << list[i] << "\" v2=\"" << list[i + 1] << "\" v3=\"" << list[i + 2] << "\"/>";
  out << "</triangles></mesh>";
  return out.str();
}

std::string threeMfModel(const std::string& attributes, const std::string& resources, const std::string& build) {
  return R"(<?xml version="1.0" encoding="UTF-8"?><model xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" )" +
         attributes + "><metadata name=\"Application\">BambuStudio-01.09</metadata><resources>" + resources + "</resources><build>" + build + "</build></model>";
}

namespace {

std::array<double, 2> star(int i) {
  const double radius = i % 2 ? 12 : 30, angle = i * std::numbers::pi / 5;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

std::string starFaces(int first, const char* mark, bool counted) {
  std::ostringstream out;
  const auto face = [&](const std::vector<int>& corners) {
    out << mark;
    if (counted) out << corners.size() << ' ';
    for (const int i : corners) out << i + first << ' ';
    out << '\n';
  };
  std::vector<int> low, high;
  for (int i = 0; i < 10; ++i) low.insert(low.begin(), i), high.push_back(10 + i);
  face(low);
  face(high);
  for (int i = 0; i < 10; ++i) face({i, (i + 1) % 10, 10 + (i + 1) % 10, 10 + i});
  return out.str();
}

std::string starPoints(const char* mark) {
  std::ostringstream out;
  out.precision(17);
  for (int i = 0; i < 20; ++i) out << mark << star(i % 10)[0] << ' ' << star(i % 10)[1] << ' ' << (i < 10 ? 0 : 10) << '\n';
  return out.str();
}

double starFace() { return 5 * 30 * 12 * std::sin(std::numbers::pi / 5); }

}  // namespace

double starVolume() { return 10 * starFace(); }
double starArea() {
  const double side = std::hypot(star(1)[0] - star(0)[0], star(1)[1] - star(0)[1]);
  return 2 * starFace() + 100 * side;
}

std::string starPly() {
  return "ply\nformat ascii 1.0\nelement vertex 20\nproperty double x\nproperty double y\nproperty double z\nelement face 12\nproperty list uchar int vertex_indices\nend_header\n" +
         starPoints("") + starFaces(0, "", true);
}

std::string starObj() { return "o star\n" + starPoints("v ") + starFaces(1, "f ", false); }

std::string gmshVtk() {
  std::ostringstream out;
  out << "# vtk DataFile Version 2.0\nbox, Created by Gmsh 4.8.4-git \nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n";
  for (int i = 0; i < 8; ++i) out << corner(i)[0] << ' ' << corner(i)[1] << ' ' << corner(i)[2] << '\n';
  out << "\nCELLS 6 30\n";
  for (const std::array<int, 2>& path : {std::array{1, 2}, {2, 1}, {1, 4}, {4, 1}, {2, 4}, {4, 2}}) {
    const int a = path[0], b = path[0] | path[1];
    const bool even = (path[0] == 1 && path[1] == 2) || (path[0] == 2 && path[1] == 4) || (path[0] == 4 && path[1] == 1);
    out << "4 0 " << (even ? a : b) << ' ' << (even ? b : a) << " 7\n";
  }
  out << "\nCELL_TYPES 6\n10\n10\n10\n10\n10\n10\n";
  return out.str();
}

}  // namespace glenoid::peers
