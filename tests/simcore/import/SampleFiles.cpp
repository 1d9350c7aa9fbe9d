// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/import/SampleFiles.h"

#include <zlib.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace glenoid::samples {
namespace {

// Corner i: x from bit 0, y from bit 1, z from bit 2.
constexpr std::array<std::array<int, 4>, 6> kQuads{{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
std::array<double, 3> corner(int i) { return {i & 1 ? 1.0 : 0.0, i & 2 ? 2.0 : 0.0, i & 4 ? 3.0 : 0.0}; }

std::vector<std::array<int, 3>> triangles() {
  std::vector<std::array<int, 3>> list;
  for (const auto& q : kQuads) {
    list.push_back({q[0], q[1], q[2]});
    list.push_back({q[0], q[2], q[3]});
  }
  return list;
}

template <class T>
void put(std::string& out, T value, std::endian order = std::endian::little) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (order != std::endian::native)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  out.append(raw, sizeof(T));
}

std::string words(const std::vector<double>& numbers) {
  std::ostringstream out;
  for (const double x : numbers) out << x << ' ';
  return out.str();
}

std::vector<double> coordinates() {
  std::vector<double> list;
  for (int i = 0; i < 8; ++i)
    for (const double x : corner(i)) list.push_back(x);
  return list;
}

std::vector<double> triangleCorners() {
  std::vector<double> list;
  for (const auto& t : triangles())
    for (const int i : t) list.push_back(i);
  return list;
}

std::string plyText() {
  std::string out = "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement face 6\n"
                    "property list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 8; ++i) out += words({corner(i)[0], corner(i)[1], corner(i)[2]}) + "\n";
  for (const auto& q : kQuads) out += "4 " + words({double(q[0]), double(q[1]), double(q[2]), double(q[3])}) + "\n";
  return out;
}

std::string plyBinary() {
  std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
                    "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
  for (const double x : coordinates()) put(out, static_cast<float>(x));
  for (const auto& t : triangles()) {
    out += '\3';
    for (const int i : t) put<std::int32_t>(out, i);
  }
  return out;
}

/// Positions, then indices: what both glTF forms hold.
std::string gltfBuffer() {
  std::string out;
  for (const double x : coordinates()) put(out, static_cast<float>(x));
  for (const auto& t : triangles())
    for (const int i : t) put<std::uint16_t>(out, static_cast<std::uint16_t>(i));
  return out;
}

std::string gltfJson(const std::string& uri, const std::string& node) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"box","mesh":0)" + node +
         R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0,0,0],"max":[1,2,3]},{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],"buffers":[{"byteLength":168)" +
         uri + "}]}";
}

std::string glb(const std::string& node) {
  std::string json = gltfJson("", node), data = gltfBuffer(), out;
  while (json.size() % 4) json += ' ';
  out += "glTF";
  put<std::uint32_t>(out, 2);
  put<std::uint32_t>(out, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + data.size()));
  put<std::uint32_t>(out, static_cast<std::uint32_t>(json.size()));
  out += "JSON" + json;
  put<std::uint32_t>(out, static_cast<std::uint32_t>(data.size()));
  out += std::string("BIN\0", 4) + data;
  return out;
}

std::string threeMf(const std::string& unit, bool deflate) {
  std::string model = R"(<?xml version="1.0" encoding="UTF-8"?><model)" + (unit.empty() ? unit : " unit=\"" + unit + "\"") +
                      R"( xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh><vertices>)";
  for (int i = 0; i < 8; ++i) {
    std::ostringstream line;
    line << "<vertex x=\"" << corner(i)[0] << "\" y=\"" << corner(i)[1] << "\" z=\"" << corner(i)[2] << "\"/>";
    model += line.str();
  }
  model += "</vertices><triangles>";
  for (const auto& t : triangles())
    model += "<triangle v1=\"" + std::to_string(t[0]) + "\" v2=\"" + std::to_string(t[1]) + "\" v3=\"" + std::to_string(t[2]) + "\"/>";
  model += "</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>";
  return zipped({{"[Content_Types].xml", R"(<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)"},
                 {"_rels/.rels", R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
                 {"3D/3dmodel.model", model}},
                deflate);
}

std::string fbxText(double centimetres, bool mirrored) {
  std::ostringstream out;
  out << "; FBX 7.3.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: 7300\n}\nGlobalSettings:  {\n"
         "\tVersion: 1000\n\tProperties70:  {\n\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\","
      << centimetres << "\n\t}\n}\nObjects:  {\n\tGeometry: 1001, \"Geometry::box\", \"Mesh\" {\n\t\tVertices: *24 {\n\t\t\ta: ";
  const auto points = coordinates();
  for (std::size_t i = 0; i < points.size(); ++i) out << (i ? "," : "") << points[i];
  out << "\n\t\t}\n\t\tPolygonVertexIndex: *24 {\n\t\t\ta: ";
  for (std::size_t i = 0; i < kQuads.size(); ++i) {
    const auto& q = kQuads[i];
    out << (i ? "," : "") << q[0] << ',' << q[1] << ',' << q[2] << ',' << -q[3] - 1;
  }
  out << "\n\t\t}\n\t\tGeometryVersion: 124\n\t}\n\tModel: 1002, \"Model::box\", \"Mesh\" {\n\t\tVersion: 232\n";
  if (mirrored) out << "\t\tProperties70:  {\n\t\t\tP: \"Lcl Scaling\", \"Lcl Scaling\", \"\", \"A\",-1,1,1\n\t\t}\n";
  out << "\t}\n}\nConnections:  {\n\tC: \"OO\",1001,1002\n\tC: \"OO\",1002,0\n}\n";
  return out.str();
}

/// One record of a binary FBX file; `at` is where it begins.
struct FbxNode {
  std::string name, properties;
  int count = 0;
  std::vector<FbxNode> children;
  FbxNode& text(const std::string& value) {
    properties += 'S';
    put<std::uint32_t>(properties, static_cast<std::uint32_t>(value.size()));
    properties += value;
    ++count;
    return *this;
  }
  FbxNode& integer(std::int64_t value) {
    properties += 'L';
    put(properties, value);
    ++count;
    return *this;
  }
  FbxNode& narrow(std::int32_t value) {
    properties += 'I';
    put(properties, value);
    ++count;
    return *this;
  }
  FbxNode& real(double value) {
    properties += 'D';
    put(properties, value);
    ++count;
    return *this;
  }
  template <class T>
  FbxNode& array(char type, const std::vector<T>& values) {
    properties += type;
    put<std::uint32_t>(properties, static_cast<std::uint32_t>(values.size()));
    put<std::uint32_t>(properties, 0);
    put<std::uint32_t>(properties, static_cast<std::uint32_t>(sizeof(T) * values.size()));
    for (const T value : values) put(properties, value);
    ++count;
    return *this;
  }
  std::string bytes(std::size_t at) const {
    std::string body;
    const std::size_t head = 13 + name.size();
    for (const FbxNode& child : children) body += child.bytes(at + head + properties.size() + body.size());
    if (!children.empty()) body += std::string(13, '\0');
    std::string out;
    put<std::uint32_t>(out, static_cast<std::uint32_t>(at + head + properties.size() + body.size()));
    put<std::uint32_t>(out, static_cast<std::uint32_t>(count));
    put<std::uint32_t>(out, static_cast<std::uint32_t>(properties.size()));
    out += static_cast<char>(name.size());
    return out + name + properties + body;
  }
};

std::string fbxBinary() {
  const std::string separator("\0\1", 2);
  FbxNode geometry{"Geometry", {}, 0, {}};
  geometry.integer(1001).text("box" + separator + "Geometry").text("Mesh");
  std::vector<std::int32_t> indices;
  for (const auto& q : kQuads) indices.insert(indices.end(), {q[0], q[1], q[2], -q[3] - 1});
  geometry.children.push_back(FbxNode{"Vertices", {}, 0, {}}.array('d', coordinates()));
  geometry.children.push_back(FbxNode{"PolygonVertexIndex", {}, 0, {}}.array('i', indices));
  FbxNode model{"Model", {}, 0, {}};
  model.integer(1002).text("box" + separator + "Model").text("Mesh");
  model.children.push_back(FbxNode{"Version", {}, 0, {}}.narrow(232));
  FbxNode header{"FBXHeaderExtension", {}, 0, {FbxNode{"FBXVersion", {}, 0, {}}.narrow(7300)}};
  FbxNode settings{"GlobalSettings", {}, 0, {FbxNode{"Properties70", {}, 0, {FbxNode{"P", {}, 0, {}}.text("UnitScaleFactor").text("double").text("Number").text("").real(0.1)}}}};
  FbxNode objects{"Objects", {}, 0, {geometry, model}};
  FbxNode links{"Connections", {}, 0, {FbxNode{"C", {}, 0, {}}.text("OO").integer(1001).integer(1002), FbxNode{"C", {}, 0, {}}.text("OO").integer(1002).integer(0)}};
  std::string out("Kaydara FBX Binary  \0\x1a\0", 23);
  put<std::uint32_t>(out, 7300);
  for (const FbxNode& node : {header, settings, objects, links}) out += node.bytes(out.size());
  return out + std::string(13, '\0') + std::string(176, '\0');
}

}  // namespace

std::string base64(const std::string& bytes) {
  static const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kLetters[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string zlibPacked(const std::string& bytes, bool raw) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, raw ? -MAX_WBITS : MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string out(bytes.size() + 100, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string zipped(const std::vector<std::pair<std::string, std::string>>& members, bool deflated) {
  std::string out, directory;
  for (const auto& [name, plain] : members) {
    const std::string packed = deflated ? zlibPacked(plain, true) : plain;
    std::string common;
    put<std::uint16_t>(common, 20);
    put<std::uint16_t>(common, 0);
    put<std::uint16_t>(common, deflated ? 8 : 0);
    put<std::uint32_t>(common, 0);
    put<std::uint32_t>(common, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(plain.data()), static_cast<uInt>(plain.size()))));
    put<std::uint32_t>(common, static_cast<std::uint32_t>(packed.size()));
    put<std::uint32_t>(common, static_cast<std::uint32_t>(plain.size()));
    put<std::uint16_t>(common, static_cast<std::uint16_t>(name.size()));
    put<std::uint16_t>(common, 0);
    directory += std::string("PK\1\2\24\0", 6) + common + std::string(10, '\0');
    put<std::uint32_t>(directory, static_cast<std::uint32_t>(out.size()));
    directory += name;
    out += "PK\3\4" + common + name + packed;
  }
  const auto at = static_cast<std::uint32_t>(out.size());
  out += directory + std::string("PK\5\6\0\0\0\0", 8);
  put<std::uint16_t>(out, static_cast<std::uint16_t>(members.size()));
  put<std::uint16_t>(out, static_cast<std::uint16_t>(members.size()));
  put<std::uint32_t>(out, static_cast<std::uint32_t>(directory.size()));
  put<std::uint32_t>(out, at);
  put<std::uint16_t>(out, 0);
  return out;
}

std::string obj() {
  std::string out = "mtllib nowhere.mtl\no box\n";
  for (int i = 0; i < 8; ++i) out += "v " + words({corner(i)[0], corner(i)[1], corner(i)[2]}) + "\n";
  out += "vn 0 0 1\nvt 0 0\n";
  for (const auto& q : kQuads) {
    out += "f";
    for (const int i : q) {
      out += ' ';
      out += std::to_string(i + 1);
      out += "/1/1";
    }
    out += '\n';
  }
  return out;
}

std::string stlText() {
  std::string out = "solid box\n";
  for (const auto& t : triangles()) {
    out += " facet normal 0 0 0\n  outer loop\n";
    for (const int i : t) out += "   vertex " + words({corner(i)[0], corner(i)[1], corner(i)[2]}) + "\n";
    out += "  endloop\n endfacet\n";
  }
  return out + "endsolid box\n";
}

std::string stlBinary() {
  std::string out(80, ' ');
  out.replace(0, 9, "solid bin");  // as some programs begin them all the same
  put<std::uint32_t>(out, 12);
  for (const auto& t : triangles()) {
    for (int i = 0; i < 3; ++i) put(out, 0.0f);
    for (const int i : t)
      for (const double x : corner(i)) put(out, static_cast<float>(x));
    put<std::uint16_t>(out, 0);
  }
  return out;
}

std::string gltf() { return gltfJson(R"(,"uri":"data:application/octet-stream;base64,)" + base64(gltfBuffer()) + "\"", ""); }

std::string dae(const std::string& unit, bool mirrored) {
  return R"(<?xml version="1.0" encoding="utf-8"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)" +
         unit + R"(<up_axis>Z_UP</up_axis></asset><library_geometries><geometry id="box-mesh" name="box"><mesh><source id="box-positions"><float_array id="box-array" count="24">)" +
         words(coordinates()) +
         R"(</float_array><technique_common><accessor source="#box-array" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source><vertices id="box-vertices"><input semantic="POSITION" source="#box-positions"/></vertices><triangles count="12"><input semantic="VERTEX" source="#box-vertices" offset="0"/><p>)" +
         words(triangleCorners()) +
         R"(</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="Scene"><node id="box" name="box" type="NODE">)" +
         std::string(mirrored ? "<scale>-1 1 1</scale>" : "") +
         R"(<instance_geometry url="#box-mesh"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#Scene"/></scene></COLLADA>)";
}

std::string vtk(bool binary, bool offsets) {
  std::string out = std::string("# vtk DataFile Version ") + (offsets ? "5.1" : "3.0") + "\nbox\n" + (binary ? "BINARY" : "ASCII") + "\nDATASET POLYDATA\nPOINTS 8 float\n";
  const auto integer = [&](std::int64_t value, bool wide) {
    if (!binary) out += std::to_string(value) + " ";
    else if (wide) put<std::int64_t>(out, value, std::endian::big);
    else put<std::int32_t>(out, static_cast<std::int32_t>(value), std::endian::big);
  };
  for (const double x : coordinates()) {
    if (binary) put(out, static_cast<float>(x), std::endian::big);
    else out += words({x});
  }
  if (offsets) {
    out += "\nMETADATA\nINFORMATION 0\n\nPOLYGONS 7 24\nOFFSETS vtktypeint64\n";
    for (int i = 0; i <= 6; ++i) integer(4 * i, true);
    out += "\nCONNECTIVITY vtktypeint64\n";
    for (const auto& q : kQuads)
      for (const int i : q) integer(i, true);
  } else {
    out += "\nPOLYGONS 6 30\n";
    for (const auto& q : kQuads) {
      integer(4, false);
      for (const int i : q) integer(i, false);
    }
  }
  return out + "\nCELL_DATA 6\nSCALARS a float 1\nLOOKUP_TABLE default\n";
}

std::string vtp(VtpForm form, bool wideHeader, bool bigEndian) {
  const std::endian order = bigEndian ? std::endian::big : std::endian::little;
  const bool packed = form == VtpForm::BinaryZlib || form == VtpForm::AppendedRawZlib || form == VtpForm::AppendedBase64Zlib;
  const bool appended = form != VtpForm::Ascii && form != VtpForm::Binary && form != VtpForm::BinaryZlib;
  const bool text = form == VtpForm::AppendedBase64 || form == VtpForm::AppendedBase64Zlib || !appended;
  std::string tail;
  const auto count = [&](std::string& to, std::uint64_t value) {
    if (wideHeader) put<std::uint64_t>(to, value, order);
    else put<std::uint32_t>(to, static_cast<std::uint32_t>(value), order);
  };
  const auto array = [&](const std::string& name, const std::string& type, const std::vector<double>& numbers) {
    const std::string head = "<DataArray type=\"" + type + "\" Name=\"" + name + "\"" + (name == "Points" ? " NumberOfComponents=\"3\"" : "");
    if (form == VtpForm::Ascii) return head + " format=\"ascii\">" + words(numbers) + "</DataArray>";
    std::string data;
    for (const double x : numbers) {
      if (type == "Float32") put(data, static_cast<float>(x), order);
      else put<std::int64_t>(data, static_cast<std::int64_t>(x), order);
    }
    std::string all;
    if (packed) {  // two blocks and a rest, so that all three sizes count
      const std::size_t block = data.size() / 2 - 4;
      std::vector<std::string> blocks;
      for (std::size_t at = 0; at < data.size(); at += block) blocks.push_back(data.substr(at, block));
      std::string header, body;
      count(header, blocks.size());
      count(header, block);
      count(header, blocks.back().size() == block ? 0 : blocks.back().size());
      for (const std::string& piece : blocks) {
        count(header, zlibPacked(piece).size());
        body += zlibPacked(piece);
      }
      all = text ? base64(header) + base64(body) : header + body;
    } else {
      std::string header;
      count(header, data.size());
      all = text ? base64(header + data) : header + data;
    }
    if (!appended) return head + " format=\"binary\">\n" + all + "\n</DataArray>";
    const std::string here = head + " format=\"appended\" offset=\"" + std::to_string(tail.size()) + "\"/>";
    tail += all;
    return here;
  };
  std::vector<double> corners, offsets;
  for (const auto& q : kQuads) {
    corners.insert(corners.end(), q.begin(), q.end());
    offsets.push_back(static_cast<double>(corners.size()));
  }
  std::string out = std::string("<?xml version=\"1.0\"?>\n<!-- a box -->\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"") +
                    (bigEndian ? "BigEndian" : "LittleEndian") + "\"" + (wideHeader ? " header_type=\"UInt64\"" : "") +
                    (packed ? " compressor=\"vtkZLibDataCompressor\"" : "") +
                    "><PolyData><Piece NumberOfPoints=\"8\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"6\"><Points>";
  out += array("Points", "Float32", coordinates()) + "</Points><Polys>" + array("connectivity", "Int64", corners) + array("offsets", "Int64", offsets) + "</Polys></Piece></PolyData>";
  if (appended) out += std::string("<AppendedData encoding=\"") + (text ? "base64" : "raw") + "\">\n_" + tail + "\n</AppendedData>";
  return out + "</VTKFile>\n";
}

std::vector<Sample> all() {
  return {{"box.obj", obj(), true, 0, 1, false},
          {"text.stl", stlText(), false, 0, 1, false},
          {"binary.STL", stlBinary(), false, 0, 1, false},
          {"text.ply", plyText(), true, 0, 1, false},
          {"binary.ply", plyBinary(), false, 0, 1, false},
          {"box.gltf", gltf(), false, 1, 1, false},
          {"box.glb", glb(""), false, 1, 1, false},
          {"mirrored.glb", glb(R"(,"scale":[-1,1,1])"), false, 1, 1, true},
          {"stored.3mf", threeMf("inch", false), false, 0.0254, 1, false},
          {"packed.3mf", threeMf("", true), false, 1e-3, 1, false},
          {"box.dae", dae("", false), false, 0, 1, false},
          {"centimetres.dae", dae("<unit name=\"cm\" meter=\"0.01\"/>", true), false, 1, 0.01, true},
          {"text.fbx", fbxText(100, true), true, 1, 1, true},
          {"binary.fbx", fbxBinary(), true, 1e-3, 1, false},
          {"text.vtp", vtp(VtpForm::Ascii, false, false), true, 0, 1, false},
          {"packed.vtp", vtp(VtpForm::BinaryZlib, true, false), true, 0, 1, false},
          {"raw.vtp", vtp(VtpForm::AppendedRaw, false, false), true, 0, 1, false},
          {"text.vtk", vtk(false, false), true, 0, 1, false},
          {"offsets.vtk", vtk(true, true), true, 0, 1, false}};
}

}  // namespace glenoid::samples
