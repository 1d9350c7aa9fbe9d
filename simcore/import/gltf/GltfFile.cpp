// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/gltf/GltfFile.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/ByteReader.h"
#include "simcore/file/Json.h"
#include "simcore/import/Uri.h"
#include "simcore/mesh/MeshoptStream.h"

namespace glenoid {
namespace {

constexpr const char* kMeshopt = "EXT_meshopt_compression";
constexpr std::int64_t kMostBytes = std::int64_t{1} << 32;

std::size_t widthOf(int componentType) {
  switch (componentType) {
    case 5120:
    case 5121: return 1;
    case 5122:
    case 5123: return 2;
    case 5125:
    case 5126: return 4;
  }
  return 0;
}

int rowsOf(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4" || type == "MAT2") return 4;
  if (type == "MAT3") return 9;
  return type == "MAT4" ? 16 : 0;
}

template <class T>
double numberFrom(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);  // little endian, as every machine that this is built for
  return static_cast<double>(value);
}

/// glTF 2.0, 3.11: normalized integers are shares of their largest; the lowest negative one counts as −1.
double component(const char* at, int type, bool normalized) {
  static_assert(std::endian::native == std::endian::little);
  switch (type) {
    case 5120: return normalized ? std::max(numberFrom<std::int8_t>(at) / 127, -1.0) : numberFrom<std::int8_t>(at);
    case 5121: return numberFrom<std::uint8_t>(at) / (normalized ? 255 : 1);
    case 5122: return normalized ? std::max(numberFrom<std::int16_t>(at) / 32767, -1.0) : numberFrom<std::int16_t>(at);
    case 5123: return numberFrom<std::uint16_t>(at) / (normalized ? 65535 : 1);
    case 5125: return numberFrom<std::uint32_t>(at);
    default: return numberFrom<float>(at);
  }
}

}  // namespace

std::string_view gltfText(std::string_view bytes, bool binary) {
  if (!binary) return bytes;
  std::uint32_t length = 0;
  if (bytes.size() < 20 || bytes.substr(16, 4) != "JSON") return {};
  std::memcpy(&length, bytes.data() + 12, 4);
  return bytes.substr(20, length);
}

Error GltfFile::bad(const std::string& what, const std::string& pointer) const { return {Fault::BadMesh, {m_path, pointer, {}, {}}, {what}, "glTF"}; }

Result<GltfFile> GltfFile::open(std::string_view bytes, const std::string& path, bool binary) {
  GltfFile file;
  file.m_path = path;
  const std::string_view text = gltfText(bytes, binary);
  Result<JsonValue> json = parseJson(text, path, {64, std::uint64_t{1} << 32});
  if (!json) return json.error();
  file.m_json = std::move(*json);
  if (binary) {
    const std::size_t next = (20 + text.size() + 3) / 4 * 4;
    std::uint32_t length = 0;
    if (bytes.size() >= next + 8 && bytes.substr(next + 4, 3) == "BIN") {
      std::memcpy(&length, bytes.data() + next, 4);
      file.m_chunk = bytes.substr(next + 8, length);
    }
  }
  return file;
}

Result<std::string_view> GltfFile::buffer(std::int64_t index) {
  const std::string pointer = pointerTo("/buffers", static_cast<std::size_t>(std::max<std::int64_t>(index, 0)));
  const JsonValue& buffers = m_json["buffers"];
  if (index < 0 || index >= static_cast<std::int64_t>(buffers.items().size()))
    return Error{Fault::BadIndex, {m_path, "/buffers", {}, {}}, {std::to_string(index), std::to_string(buffers.items().size())}, "glTF"};
  if (const auto known = m_buffers.find(index); known != m_buffers.end()) return std::string_view(known->second);
  const std::string& uri = buffers[static_cast<std::size_t>(index)]["uri"].text();
  if (uri.empty()) {
    if (index == 0 && !m_chunk.empty()) return m_chunk;
    return bad("a buffer of it has no bytes", pointer);
  }
  if (uri.starts_with("data:")) {
    auto data = bytesOfDataUri(uri);
    if (!data) return bad("a buffer of it cannot be made out of its text", pointer);
    return std::string_view(m_buffers.emplace(index, std::move(*data)).first->second);
  }
  const std::string beside = fileBeside(m_path, uri);
  if (beside.empty()) return bad("it needs “" + uri.substr(0, 100) + "” beside it, which is not there", pointer);
  auto data = readWholeFile(beside);
  if (!data) return data.error();
  return std::string_view(m_buffers.emplace(index, std::move(*data)).first->second);
}

Result<std::string_view> GltfFile::cut(std::string_view whole, const JsonValue& from, const std::string& pointer) const {
  const std::int64_t offset = from["byteOffset"].integer(0), length = from["byteLength"].integer(0);
  if (offset < 0 || length < 0 || offset > static_cast<std::int64_t>(whole.size()) || length > static_cast<std::int64_t>(whole.size()) - offset)
    return Error{Fault::FileTruncated, {m_path, pointer, {}, {}}, {}, "glTF"};
  return whole.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

Result<std::string_view> GltfFile::view(std::int64_t index) {
  const JsonValue& views = m_json["bufferViews"];
  if (index < 0 || index >= static_cast<std::int64_t>(views.items().size()))
    return Error{Fault::BadIndex, {m_path, "/bufferViews", {}, {}}, {std::to_string(index), std::to_string(views.items().size())}, "glTF"};
  if (const auto known = m_views.find(index); known != m_views.end()) return std::string_view(known->second);
  const std::string pointer = pointerTo("/bufferViews", static_cast<std::size_t>(index));
  const JsonValue& view = views[static_cast<std::size_t>(index)];
  const JsonValue& packed = view["extensions"][kMeshopt];
  const JsonValue& source = packed.isObject() ? packed : view;
  const auto whole = buffer(source["buffer"].integer(-1));
  if (!whole) return whole.error();
  const auto bytes = cut(*whole, source, pointer);
  if (!bytes || !packed.isObject()) return bytes;
  auto unpacked = unpackMeshopt(*bytes, {packed["mode"].text(), packed["filter"].text(), packed["count"].integer(-1), packed["byteStride"].integer(0)});
  if (!unpacked) {
    unpacked.error().place = {m_path, pointer, {}, {}};
    return unpacked.error();
  }
  return std::string_view(m_views.emplace(index, std::move(*unpacked)).first->second);
}

Result<Done> GltfFile::take(const JsonValue& source, int type, int rows, bool normalized, const Eigen::VectorXd* to, Eigen::MatrixXd& out, const std::string& pointer) {
  const std::int64_t index = source["bufferView"].integer(-1);
  const auto bytes = view(index);
  if (!bytes) return bytes.error();
  const auto element = static_cast<std::int64_t>(rows * static_cast<int>(widthOf(type)));
  const std::int64_t offset = source["byteOffset"].integer(0), count = to ? to->size() : out.cols();
  const std::int64_t stride = m_json["bufferViews"][static_cast<std::size_t>(index)]["byteStride"].integer(element);
  const auto size = static_cast<std::int64_t>(bytes->size());
  if (offset < 0 || stride < element || stride > 1 << 20 || offset > size || (count > 0 && (count - 1) * stride + element > size - offset))
    return Error{Fault::FileTruncated, {m_path, pointer, {}, {}}, {}, "glTF"};
  for (std::int64_t i = 0; i < count; ++i) {
    const double column = to ? (*to)[i] : static_cast<double>(i);
    if (!(column >= 0 && column < static_cast<double>(out.cols())))
      return Error{Fault::BadIndex, {m_path, pointer, {}, {}}, {std::to_string(static_cast<long long>(column)), std::to_string(out.cols())}, "glTF"};
    for (int r = 0; r < rows; ++r)
      out(r, static_cast<Eigen::Index>(column)) = component(bytes->data() + offset + i * stride + r * static_cast<std::int64_t>(widthOf(type)), type, normalized);
  }
  return Done{};
}

Result<Eigen::MatrixXd> GltfFile::values(std::int64_t accessor) {
  const JsonValue& accessors = m_json["accessors"];
  if (accessor < 0 || accessor >= static_cast<std::int64_t>(accessors.items().size()))
    return Error{Fault::BadIndex, {m_path, "/accessors", {}, {}}, {std::to_string(accessor), std::to_string(accessors.items().size())}, "glTF"};
  const std::string pointer = pointerTo("/accessors", static_cast<std::size_t>(accessor));
  const JsonValue& from = accessors[static_cast<std::size_t>(accessor)];
  const int type = static_cast<int>(from["componentType"].integer(0)), rows = rowsOf(from["type"].text());
  const std::int64_t count = from["count"].integer(-1);
  if (widthOf(type) == 0 || rows == 0 || count < 0) return bad("an accessor of it has a type that glTF does not have", pointer);
  if (count > kMostBytes / (8 * rows)) return Error{Fault::FileTooLarge, {m_path, pointer, {}, {}}, {std::to_string(count) + " values", std::to_string(kMostBytes / (8 * rows))}, "glTF"};
  const bool normalized = from["normalized"].boolean(false);
  const JsonValue& sparse = from["sparse"];
  if (from["bufferView"].isNull() && !sparse.isObject()) return bad("an accessor of it has no values", pointer);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(rows, count);
  if (!from["bufferView"].isNull())
    if (const auto done = take(from, type, rows, normalized, nullptr, out, pointer); !done) return done.error();
  if (!sparse.isObject()) return out;
  const std::int64_t few = sparse["count"].integer(-1);
  const int indexType = static_cast<int>(sparse["indices"]["componentType"].integer(0));
  if (few < 0 || few > count || widthOf(indexType) == 0) return bad("an accessor of it has sparse values that cannot be", pointer);
  Eigen::MatrixXd places(1, few);
  if (const auto done = take(sparse["indices"], indexType, 1, false, nullptr, places, pointer); !done) return done.error();
  const Eigen::VectorXd columns = places.row(0);
  if (const auto done = take(sparse["values"], type, rows, normalized, &columns, out, pointer); !done) return done.error();
  return out;
}

}  // namespace glenoid
