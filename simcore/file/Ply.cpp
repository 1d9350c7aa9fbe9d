// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/file/Ply.h"

#include <algorithm>
#include <limits>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/PlyHeader.h"
#include "simcore/mesh/PolygonSplit.h"

namespace glenoid {
namespace {

enum class Read { Good, Ended, NoNumber };

/// One number after the other, whatever the encoding. Every type fits a double exactly.
class NumberReader {
 public:
  NumberReader(ByteReader& bytes, PlyEncoding encoding)
      : m_bytes(bytes),
        m_ascii(encoding == PlyEncoding::Ascii),
        m_order(encoding == PlyEncoding::BigEndian ? std::endian::big : std::endian::little) {}

  Read next(PlyType type, double& value) {
    if (m_ascii) {
      const std::string_view word = m_bytes.takeWord();
      if (word.empty()) return Read::Ended;
      auto number = realIn(word);
      if (const std::size_t comma = word.find(','); !number && comma != std::string_view::npos) {
        // Written in a locale with decimal commas, which the readers of the other formats take too.
        std::string text(word);
        text[comma] = '.';
        number = realIn(text);
      }
      if (!number)
        return m_bytes.left() == 0 ? Read::Ended : Read::NoNumber;  // a word that the end of file cut
      value = *number;
      return Read::Good;
    }
    switch (type) {
      case PlyType::Int8:
        return binary<std::int8_t>(value);
      case PlyType::UInt8:
        return binary<std::uint8_t>(value);
      case PlyType::Int16:
        return binary<std::int16_t>(value);
      case PlyType::UInt16:
        return binary<std::uint16_t>(value);
      case PlyType::Int32:
        return binary<std::int32_t>(value);
      case PlyType::UInt32:
        return binary<std::uint32_t>(value);
      case PlyType::Float32:
        return binary<float>(value);
      case PlyType::Float64:
        return binary<double>(value);
    }
    return Read::NoNumber;
  }

  Read skip(PlyType type, std::size_t count) {
    if (!m_ascii) return m_bytes.skip(count * sizeOf(type)) ? Read::Good : Read::Ended;
    for (std::size_t i = 0; i < count; ++i)
      if (m_bytes.takeWord().empty()) return Read::Ended;
    return Read::Good;
  }

 private:
  template <class T>
  Read binary(double& value) {
    const auto number = m_bytes.take<T>(m_order);
    if (!number) return Read::Ended;
    value = static_cast<double>(*number);
    return Read::Good;
  }

  ByteReader& m_bytes;
  bool m_ascii;
  std::endian m_order;
};

/// One file being read: the rows of each element in turn.
class PlyBody {
 public:
  PlyBody(ByteReader& bytes, const PlyHeader& header, const std::string& file)
      : m_bytes(bytes), m_header(header), m_numbers(bytes, header.encoding), m_file(file) {}

  Result<Done> read(TriMesh& mesh, PlyNotes& notes) {
    for (const PlyElement& element : m_header.elements) {
      if (element.properties.empty()) continue;
      if (const auto room = checkRoom(element); !room) return room;
      const bool vertices = element.name == "vertex", faces = element.name == "face";
      if (vertices) {
        if (const auto fit = checkVertexColumns(element); !fit) return fit;
        mesh.vertices.reserve(static_cast<std::size_t>(element.count));
      }
      if (faces) {
        if (const auto fit = checkFaceColumns(element); !fit) return fit;
        mesh.triangles.reserve(static_cast<std::size_t>(element.count));
      }
      for (m_row = 0; m_row < element.count; ++m_row) {
        const Result<Done> row = vertices ? readVertex(element, mesh) : readRow(element, faces, mesh, notes);
        if (!row) return row;
      }
    }
    cutConcave(mesh);
    return Done{};
  }

 private:
  Error fail(Fault fault, Arguments arguments = {}) const {
    return {fault, {m_file, {}, {}, m_row}, std::move(arguments), {}};
  }
  Error failRead(Read read) const {
    return read == Read::Ended ? fail(Fault::FileTruncated)
                               : fail(Fault::BadMesh, {"a word that is no number"});
  }
  Error failHeader(const char* what) const { return {Fault::BadMesh, {m_file, {}, {}, {}}, {what}, {}}; }

  /// A header may promise a billion rows: believe it only where the bytes that are left could hold them. This
  /// also bounds the memory that is set aside.
  Result<Done> checkRoom(const PlyElement& element) const {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties)
      least += m_header.encoding == PlyEncoding::Ascii
                   ? 1
                   : sizeOf(property.isList ? property.countType : property.type);
    if (static_cast<unsigned long long>(element.count) > m_bytes.left() / least)
      return Error{
          Fault::FileTruncated, {m_file, {}, {}, {}}, {}, element.name + " rows do not fit the file"};
    if (element.count > std::numeric_limits<int>::max())
      return failHeader("more rows than an index can count");
    return Done{};
  }

  Result<Done> checkVertexColumns(const PlyElement& element) const {
    int found = 0;
    for (const PlyProperty& p : element.properties)
      if (!p.isList && (p.name == "x" || p.name == "y" || p.name == "z")) ++found;
    if (found != 3) return failHeader("vertices without x, y and z");
    return Done{};
  }

  static bool isCorners(const PlyProperty& p) {
    return p.isList && (p.name == "vertex_indices" || p.name == "vertex_index");
  }

  Result<Done> checkFaceColumns(const PlyElement& element) const {
    for (const PlyProperty& p : element.properties)
      if (isCorners(p)) return Done{};
    return failHeader("faces without vertex_indices");
  }

  Result<Done> readVertex(const PlyElement& element, TriMesh& mesh) {
    Vec3 x = Vec3::Zero();
    for (const PlyProperty& property : element.properties) {
      const bool axis =
          !property.isList && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z';
      double value = 0;
      const Read read = property.isList ? skipList(property)
                        : axis          ? m_numbers.next(property.type, value)
                                        : m_numbers.skip(property.type, 1);
      if (read != Read::Good) return failRead(read);
      if (axis) x[property.name[0] - 'x'] = value;
    }
    if (!x.allFinite()) return fail(Fault::NotFinite);
    mesh.vertices.push_back(x);
    return Done{};
  }

  Result<Done> readRow(const PlyElement& element, bool faces, TriMesh& mesh, PlyNotes& notes) {
    for (const PlyProperty& property : element.properties) {
      if (faces && isCorners(property)) {
        if (const auto face = readFace(property, mesh, notes); !face) return face;
        continue;
      }
      const Read read = property.isList ? skipList(property) : m_numbers.skip(property.type, 1);
      if (read != Read::Good) return failRead(read);
    }
    return Done{};
  }

  Read takeCount(const PlyProperty& property, std::size_t& count) {
    double value = 0;
    const Read read = m_numbers.next(property.countType, value);
    if (read != Read::Good) return read;
    if (!(value >= 0) || value != std::floor(value)) return Read::NoNumber;
    if (value > static_cast<double>(m_bytes.left())) return Read::Ended;
    count = static_cast<std::size_t>(value);
    return Read::Good;
  }

  Read skipList(const PlyProperty& property) {
    std::size_t count = 0;
    const Read read = takeCount(property, count);
    return read == Read::Good ? m_numbers.skip(property.type, count) : read;
  }

  Result<Done> readFace(const PlyProperty& property, TriMesh& mesh, PlyNotes& notes) {
    std::size_t count = 0;
    if (const Read read = takeCount(property, count); read != Read::Good) return failRead(read);
    if (count < 3) return fail(Fault::BadMesh, {"a face of fewer than three corners"});
    std::vector<int> corners;
    int first = 0, before = 0;
    for (std::size_t corner = 0; corner < count; ++corner) {
      double value = 0;
      if (const Read read = m_numbers.next(property.type, value); read != Read::Good) return failRead(read);
      if (!(value >= 0) || value >= static_cast<double>(vertexCount()) || value != std::floor(value))
        return fail(Fault::BadIndex, {indexText(value), std::to_string(vertexCount())});
      const int index = static_cast<int>(value);
      if (count > 3) corners.push_back(index);
      if (corner == 0) first = index;
      if (corner >= 2) mesh.triangles.push_back({first, before, index});
      before = index;
    }
    if (count > 3) {
      ++notes.polygonsSplit;
      m_polygons.push_back({mesh.triangles.size() - (count - 2), std::move(corners)});
    }
    return Done{};
  }

  /// Faces may stand before the vertices they name.
  long long vertexCount() const {
    for (const PlyElement& element : m_header.elements)
      if (element.name == "vertex") return element.count;
    return 0;
  }

  static std::string indexText(double value) {
    return std::abs(value) < 1e15 && value == std::floor(value)
               ? std::to_string(static_cast<long long>(value))
               : std::to_string(value);
  }

  /// Faces may stand before their points, so polygons are looked at when all is read: where the fan from the first corner folds
  /// over, they are cut again.
  void cutConcave(TriMesh& mesh) const {
    std::vector<std::array<int, 3>> pieces;
    for (const Polygon& polygon : m_polygons) {
      const auto facing = [&](std::size_t t) {
        const auto& c = mesh.triangles[t];
        return Vec3((mesh.vertices[c[1]] - mesh.vertices[c[0]]).cross(mesh.vertices[c[2]] - mesh.vertices[c[0]]));
      };
      const std::size_t end = polygon.first + polygon.corners.size() - 2;
      Vec3 mean = Vec3::Zero();  // Newell's normal is the sum of any fan's
      for (std::size_t t = polygon.first; t < end; ++t) mean += facing(t);
      bool folds = false;
      for (std::size_t t = polygon.first; t < end && !folds; ++t) folds = facing(t).dot(mean) < 0;
      if (!folds) continue;
      pieces.clear();
      splitPolygon(mesh.vertices, polygon.corners, pieces);
      std::copy(pieces.begin(), pieces.end(), mesh.triangles.begin() + static_cast<std::ptrdiff_t>(polygon.first));
    }
  }

  struct Polygon {
    std::size_t first;  ///< of its triangles
    std::vector<int> corners;
  };
  std::vector<Polygon> m_polygons;
  ByteReader& m_bytes;
  const PlyHeader& m_header;
  NumberReader m_numbers;
  const std::string& m_file;
  long m_row = 0;
};

}  // namespace

Result<TriMesh> parsePly(std::string_view bytes, const std::string& file, PlyNotes* notes) {
  ByteReader reader(bytes);
  const Result<PlyHeader> header = readPlyHeader(reader, file);
  if (!header) return header.error();
  const Place whole{file, {}, {}, {}};
  int vertexElements = 0, faceElements = 0;
  for (const PlyElement& element : header->elements) {
    vertexElements += element.name == "vertex";
    faceElements += element.name == "face";
  }
  if (vertexElements != 1 || faceElements != 1)
    return Error{Fault::BadMesh, whole, {"needs one vertex element and one face element"}, {}};
  TriMesh mesh;
  PlyNotes found;
  if (const auto read = PlyBody(reader, *header, file).read(mesh, found); !read) return read.error();
  if (mesh.triangles.empty()) return Error{Fault::BadMesh, whole, {"no triangles"}, {}};
  if (notes) *notes = found;
  return mesh;
}

Result<TriMesh> readPly(const std::string& path, PlyNotes* notes) {
  const Result<std::string> bytes = readWholeFile(path);
  if (!bytes) return bytes.error();
  return parsePly(*bytes, path, notes);
}

Result<Done> writePly(const std::string& path, const TriMesh& mesh) {
  if (mesh.triangles.empty()) return Error{Fault::BadMesh, {path, {}, {}, {}}, {"no triangles"}, {}};
  const auto size = static_cast<int>(mesh.vertices.size());
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(size) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  bytes.reserve(bytes.size() + mesh.vertices.size() * 24 + mesh.triangles.size() * 13);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!mesh.vertices[i].allFinite())
      return Error{Fault::NotFinite, {path, {}, {}, static_cast<long>(i)}, {}, {}};
    for (const double x : mesh.vertices[i]) appendBytes(x, std::endian::little, bytes);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    bytes += '\3';
    for (const int index : mesh.triangles[i]) {
      if (index < 0 || index >= size)
        return Error{Fault::BadIndex,
                     {path, {}, {}, static_cast<long>(i)},
                     {std::to_string(index), std::to_string(size)},
                     {}};
      appendBytes(index, std::endian::little, bytes);
    }
  }
  return writeWholeFile(path, bytes);
}

}  // namespace glenoid
