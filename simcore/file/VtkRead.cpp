// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <limits>

#include "simcore/file/ByteReader.h"
#include "simcore/file/Vtk.h"

namespace glenoid {
namespace {

constexpr int kVtkTetra = 10;

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Walks through the sections of one file. Each function answers false once `m_error` says why.
class VtkFile {
 public:
  VtkFile(std::string_view bytes, const std::string& file) : m_bytes(bytes), m_file(file) {}

  Result<TetMesh> read() {
    if (!readHeader() || !readSections() || !makeCells()) return m_error;
    if (const auto good = checkTetMesh(m_mesh, m_file); !good) return good.error();
    return std::move(m_mesh);
  }

 private:
  bool fail(Fault fault, Arguments arguments = {}, std::optional<long> element = {}) {
    m_error = {fault, {m_file, {}, {}, element}, std::move(arguments), {}};
    return false;
  }

  bool readHeader() {
    static constexpr std::string_view kMagic = "# vtk DataFile Version ";
    const auto magic = m_bytes.takeLine();
    if (!magic || magic->substr(0, kMagic.size()) != kMagic) {
      const bool cut = magic && m_bytes.left() == 0 && kMagic.substr(0, magic->size()) == *magic;
      return fail(cut ? Fault::FileTruncated : Fault::UnknownFormat);
    }
    const auto version = realIn(lower(magic->substr(kMagic.size())));
    if (!version && m_bytes.left() == 0) return fail(Fault::FileTruncated);
    if (!version || !(*version >= 1 && *version < 6)) return fail(Fault::UnknownFormat);
    m_offsets = *version >= 5;
    if (!m_bytes.takeLine()) return fail(Fault::FileTruncated);  // title
    const std::string encoding = lower(m_bytes.takeWord());
    if (encoding != "ascii" && encoding != "binary")
      return fail(m_bytes.left() == 0 ? Fault::FileTruncated : Fault::UnknownFormat);
    m_ascii = encoding == "ascii";
    const std::string dataset = lower(m_bytes.takeWord()), kind = lower(m_bytes.takeWord());
    if (m_bytes.left() == 0) return fail(Fault::FileTruncated);
    if (dataset != "dataset" || kind != "unstructured_grid") return fail(Fault::UnknownFormat);
    return true;
  }

  /// Order in the file is free; data attached to points and cells comes last and is not ours.
  bool readSections() {
    bool points = false, cells = false, types = false;
    while (!(points && cells && types)) {
      const std::string word = lower(m_bytes.takeWord());
      if (word.empty() || word == "point_data" || word == "cell_data") return fail(Fault::FileTruncated);
      bool good = false;
      if (word == "points" && !points)
        points = good = readPoints();
      else if (word == "cells" && !cells)
        cells = good = m_offsets ? readOffsetCells() : readCountedCells();
      else if (word == "cell_types" && !types)
        types = good = readTypes();
      else if (word == "metadata")
        good = skipMetadata();
      else
        return fail(m_bytes.left() == 0 ? Fault::FileTruncated : Fault::BadMesh,
                    {"unexpected word \"" + word.substr(0, 40) + "\""});
      if (!good) return false;
    }
    return true;
  }

  /// "METADATA" goes on to the next empty line.
  bool skipMetadata() {
    m_bytes.takeLine();
    while (const auto line = m_bytes.takeLine())
      if (line->empty()) return true;
    return fail(Fault::FileTruncated);
  }

  /// A count from a header line, believed only where the rest of the file could hold so many.
  bool takeCount(std::size_t bytesEach, std::size_t& count) {
    const std::string_view word = m_bytes.takeWord();
    const auto value = integerIn(word);
    if (m_bytes.left() == 0) return fail(Fault::FileTruncated);
    if (!value || *value < 0) return fail(Fault::BadMesh, {"a count that is none"});
    if (static_cast<unsigned long long>(*value) > m_bytes.left() / (m_ascii ? 1 : bytesEach))
      return fail(Fault::FileTruncated);
    if (*value > std::numeric_limits<int>::max())
      return fail(Fault::BadMesh, {"more rows than an index can count"});
    count = static_cast<std::size_t>(*value);
    return true;
  }

  /// Binary data begins right behind the line break of its header.
  bool endHeaderLine() { return m_bytes.takeLine() ? true : fail(Fault::FileTruncated); }

  bool takeReal(bool isDouble, double& value) {
    if (m_ascii) {
      const std::string_view word = m_bytes.takeWord();
      const auto number = realIn(lower(word));
      if (!number)
        return fail(m_bytes.left() == 0 ? Fault::FileTruncated : Fault::BadMesh,
                    {"a word that is no number"});
      value = *number;
      return true;
    }
    const auto number = isDouble ? m_bytes.take<double>(std::endian::big)
                                 : std::optional<double>(m_bytes.take<float>(std::endian::big));
    if (!number) return fail(Fault::FileTruncated);
    value = *number;
    return true;
  }

  bool takeInteger(bool is64, long long& value) {
    if (m_ascii) {
      const auto number = integerIn(m_bytes.takeWord());
      if (!number)
        return fail(m_bytes.left() == 0 ? Fault::FileTruncated : Fault::BadMesh,
                    {"a word that is no integer"});
      value = *number;
      return true;
    }
    const auto number = is64 ? std::optional<long long>(m_bytes.take<std::int64_t>(std::endian::big))
                             : std::optional<long long>(m_bytes.take<std::int32_t>(std::endian::big));
    if (!number) return fail(Fault::FileTruncated);
    value = *number;
    return true;
  }

  bool readPoints() {
    std::size_t count = 0;
    if (!takeCount(12, count)) return false;
    const std::string type = lower(m_bytes.takeWord());
    if (type != "float" && type != "double")
      return fail(m_bytes.left() == 0 ? Fault::FileTruncated : Fault::BadMesh,
                  {"points that are neither float nor double"});
    if (!endHeaderLine()) return false;
    m_mesh.nodes.resize(count);
    for (Vec3& x : m_mesh.nodes)
      for (double& value : x)
        if (!takeReal(type == "double", value)) return false;
    return true;
  }

  bool readCountedCells() {
    std::size_t cells = 0, numbers = 0;
    if (!takeCount(4, cells) || !takeCount(4, numbers) || !endHeaderLine()) return false;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      long long corners = 0;
      if (!takeInteger(false, corners)) return false;
      if (corners != 4)
        return fail(Fault::BadMesh, {"a cell that is no tetrahedron"}, static_cast<long>(cell));
      for (int corner = 0; corner < 4; ++corner)
        if (!takeIndex(false, static_cast<long>(cell))) return false;
    }
    m_cells = cells;
    if (numbers != cells * 5) return fail(Fault::BadMesh, {"cells whose size does not fit their number"});
    return true;
  }

  bool readOffsetCells() {
    std::size_t offsets = 0, corners = 0;
    if (!takeCount(4, offsets) || !takeCount(4, corners) || !endHeaderLine()) return false;
    bool is64 = false;
    if (!takeArrayHead("offsets", is64)) return false;
    for (std::size_t i = 0; i < offsets; ++i) {
      long long offset = 0;
      if (!takeInteger(is64, offset)) return false;
      if (offset != static_cast<long long>(4 * i))
        return fail(Fault::BadMesh, {"a cell that is no tetrahedron"}, static_cast<long>(i) - 1);
    }
    m_cells = offsets == 0 ? 0 : offsets - 1;
    if (corners != 4 * m_cells) return fail(Fault::BadMesh, {"cells whose size does not fit their number"});
    if (!takeArrayHead("connectivity", is64)) return false;
    for (std::size_t i = 0; i < corners; ++i)
      if (!takeIndex(is64, static_cast<long>(i / 4))) return false;
    return true;
  }

  bool takeArrayHead(const char* name, bool& is64) {
    const std::string word = lower(m_bytes.takeWord()), type = lower(m_bytes.takeWord());
    if (m_bytes.left() == 0) return fail(Fault::FileTruncated);
    is64 = type == "vtktypeint64";
    if (word != name || (!is64 && type != "vtktypeint32" && type != "int"))
      return fail(Fault::BadMesh, {"cells without " + std::string(name)});
    return endHeaderLine();
  }

  /// Indices that no int holds are kept out here; the rest is judged when the points are known.
  bool takeIndex(bool is64, long cell) {
    long long index = 0;
    if (!takeInteger(is64, index)) return false;
    if (index < 0 || index > std::numeric_limits<int>::max())
      return fail(Fault::BadIndex, {std::to_string(index), std::to_string(m_mesh.nodes.size())}, cell);
    m_corners.push_back(static_cast<int>(index));
    return true;
  }

  bool readTypes() {
    std::size_t count = 0;
    if (!takeCount(4, count) || !endHeaderLine()) return false;
    for (std::size_t i = 0; i < count; ++i) {
      long long type = 0;
      if (!takeInteger(false, type)) return false;
      if (type != kVtkTetra)
        return fail(Fault::BadMesh, {"a cell that is no tetrahedron (VTK type " + std::to_string(type) + ")"},
                    static_cast<long>(i));
    }
    m_types = count;
    return true;
  }

  bool makeCells() {
    if (m_types != m_cells) return fail(Fault::BadMesh, {"as many cell types as cells are needed"});
    m_mesh.tets.resize(m_cells);
    for (std::size_t i = 0; i < m_cells; ++i)
      std::copy_n(m_corners.begin() + 4 * i, 4, m_mesh.tets[i].begin());
    return true;
  }

  ByteReader m_bytes;
  const std::string& m_file;
  bool m_ascii = true, m_offsets = false;
  TetMesh m_mesh;
  std::vector<int> m_corners;  ///< four for each cell
  std::size_t m_cells = 0, m_types = 0;
  Error m_error;
};

}  // namespace

Result<TetMesh> parseVtk(std::string_view bytes, const std::string& file) {
  return VtkFile(bytes, file).read();
}

}  // namespace glenoid
