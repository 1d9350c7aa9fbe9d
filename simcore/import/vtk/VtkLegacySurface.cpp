// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <limits>

#include "simcore/file/ByteReader.h"
#include "simcore/import/vtk/VtkSurface.h"

namespace glenoid {
namespace {

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

enum class Cells { Vertices, Lines, Polygons, Strips, Grid };

/// Walks through the sections of one file. Each function answers false once `m_error` says why.
class LegacyFile {
 public:
  LegacyFile(std::string_view bytes, const std::string& file) : m_bytes(bytes), m_file(file), m_cells(file) {}

  Result<ImportedFile> read() {
    if (!readHeader() || !readSections()) return m_error;
    if (!m_kept.empty()) return Error{Fault::BadMesh, {m_file, {}, {}, {}}, {"its cells have no types"}, {}};
    return m_cells.finish("VTK");
  }

 private:
  bool fail(Fault fault, Arguments arguments = {}) {
    m_error = {fault, {m_file, {}, {}, {}}, std::move(arguments), {}};
    return false;
  }
  bool wrong(const std::string& what) { return m_bytes.left() == 0 ? fail(Fault::FileTruncated) : fail(Fault::BadMesh, {what}); }
  bool pass(const Result<Done>& done) {
    if (!done) m_error = done.error();
    return done.ok();
  }

  bool readHeader() {
    static constexpr std::string_view kMagic = "# vtk DataFile Version ";
    const auto magic = m_bytes.takeLine();
    if (!magic || magic->substr(0, kMagic.size()) != kMagic) {
      const bool cut = magic && m_bytes.left() == 0 && kMagic.substr(0, magic->size()) == *magic;
      return fail(cut ? Fault::FileTruncated : Fault::UnknownFormat);
    }
    ByteReader words(magic->substr(kMagic.size()));
    const auto version = realIn(words.takeWord());
    if (!version || !(*version >= 1 && *version < 6)) return m_bytes.left() ? fail(Fault::UnknownFormat) : fail(Fault::FileTruncated);
    m_offsets = *version >= 5;
    if (!m_bytes.takeLine()) return fail(Fault::FileTruncated);  // title
    const std::string encoding = lower(m_bytes.takeWord());
    if (encoding != "ascii" && encoding != "binary") return wrong("it is neither ascii nor binary");
    m_ascii = encoding == "ascii";
    const std::string dataset = lower(m_bytes.takeWord()), kind = lower(m_bytes.takeWord());
    if (m_bytes.left() == 0) return fail(Fault::FileTruncated);
    if (dataset != "dataset") return wrong("it has no data set");
    m_grid = kind == "unstructured_grid";
    if (kind != "polydata" && !m_grid) return fail(Fault::BadMesh, {"it holds " + kind.substr(0, 40) + ", not surfaces (polydata) or cells (unstructured_grid)"});
    return true;
  }

  /// Points come first in every writer, yet the order is free; values attached to points and cells come last.
  bool readSections() {
    bool points = false;
    while (true) {
      const std::string word = lower(m_bytes.takeWord());
      if (word.empty()) return points ? true : fail(Fault::FileTruncated);
      bool good = false;
      if (word == "point_data" || word == "cell_data") {
        m_cells.note(ImportNote::DataDropped, 1);
        return points ? true : fail(Fault::BadMesh, {"it has no points"});
      }
      if (word == "points" && !points) points = good = readPoints();
      else if (word == "metadata") good = skipMetadata();
      else if (word == "field") good = skipField();
      else if (!points) return wrong("unexpected word \"" + word.substr(0, 40) + "\"");
      else if (m_grid && word == "cells") good = readCells(Cells::Grid);
      else if (m_grid && word == "cell_types") good = readTypes();
      else if (m_grid) return wrong("unexpected word \"" + word.substr(0, 40) + "\"");
      else if (word == "polygons") good = readCells(Cells::Polygons);
      else if (word == "triangle_strips") good = readCells(Cells::Strips);
      else if (word == "lines") good = readCells(Cells::Lines);
      else if (word == "vertices") good = readCells(Cells::Vertices);
      else return wrong("unexpected word \"" + word.substr(0, 40) + "\"");
      if (!good) return false;
    }
  }

  bool skipMetadata() {
    m_bytes.takeLine();
    while (const auto line = m_bytes.takeLine())
      if (line->empty()) return true;
    return true;
  }

  /// Arrays of values that belong to the whole, with their metadata; VTK writes them before the points.
  bool skipField() {
    m_bytes.takeWord();  // name
    std::size_t arrays = 0;
    if (!takeCount(1, arrays)) return false;
    m_cells.note(ImportNote::DataDropped, arrays > 0);
    for (std::size_t i = 0; i < arrays;) {
      if (lower(m_bytes.takeWord()) == "metadata") {  // of the array before
        skipMetadata();
        continue;
      }
      std::size_t components = 0, tuples = 0;
      if (!takeCount(0, components) || !takeCount(0, tuples)) return false;
      const std::string type = lower(m_bytes.takeWord());
      if (!endHeaderLine() || !skipValues(type, components, tuples)) return false;
      ++i;
    }
    return true;
  }

  bool skipValues(const std::string& type, std::size_t components, std::size_t tuples) {
    if (components > 0 && tuples > std::numeric_limits<std::size_t>::max() / 8 / components) return fail(Fault::FileTruncated);
    const std::size_t count = components * tuples;
    if (type == "string") return skipStrings(count);
    if (m_ascii) {
      for (std::size_t i = 0; i < count; ++i)
        if (m_bytes.takeWord().empty()) return fail(Fault::FileTruncated);
      return true;
    }
    const std::size_t each = type.ends_with("char")                                                                      ? 1
                             : type.ends_with("short")                                                                   ? 2
                             : type == "int" || type == "unsigned_int" || type == "float" || type == "vtkidtype"         ? 4
                             : type.ends_with("long") || type.ends_with("int64") || type == "double"                     ? 8
                                                                                                                         : 0;
    if (each == 0 && type != "bit") return wrong("values of the unknown type \"" + type.substr(0, 40) + "\"");
    return m_bytes.skip(type == "bit" ? (count + 7) / 8 : count * each) ? true : fail(Fault::FileTruncated);
  }

  /// ascii: one a line. Binary: the two upper bits of the first byte say of how many bytes its length is (3, 2, 1, 0: 1, 2, 4, 8).
  bool skipStrings(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (m_ascii) {
        if (!m_bytes.takeLine()) return fail(Fault::FileTruncated);
        continue;
      }
      const auto first = m_bytes.take<std::uint8_t>(std::endian::big);
      if (!first) return fail(Fault::FileTruncated);
      std::uint64_t length = *first & 63u;
      for (int more = (1 << (3 - (*first >> 6))) - 1; more > 0; --more) {
        const auto byte = m_bytes.take<std::uint8_t>(std::endian::big);
        if (!byte) return fail(Fault::FileTruncated);
        length = length << 8 | *byte;
      }
      if (length > m_bytes.left() || !m_bytes.skip(static_cast<std::size_t>(length))) return fail(Fault::FileTruncated);
    }
    return true;
  }

  /// A count from a header line, believed only where the rest of the file could hold so many.
  bool takeCount(std::size_t bytesEach, std::size_t& count) {
    const auto value = integerIn(m_bytes.takeWord());
    if (!value || *value < 0) return wrong("a count that is none");
    if (bytesEach > 0 && static_cast<unsigned long long>(*value) > m_bytes.left() / (m_ascii ? 1 : bytesEach)) return fail(Fault::FileTruncated);
    if (*value > std::numeric_limits<int>::max()) return fail(Fault::BadMesh, {"more rows than an index can count"});
    count = static_cast<std::size_t>(*value);
    return true;
  }

  /// Binary data begins right behind the line break of its header.
  bool endHeaderLine() { return m_bytes.takeLine() ? true : fail(Fault::FileTruncated); }

  template <class Binary, class Value>
  bool takeBinary(Value& value) {
    const auto number = m_bytes.take<Binary>(std::endian::big);
    if (!number) return fail(Fault::FileTruncated);
    value = static_cast<Value>(*number);
    return true;
  }

  bool takeReal(const std::string& type, double& value) {
    if (m_ascii) {
      const auto number = realIn(lower(m_bytes.takeWord()));
      if (!number) return wrong("a word that is no number");
      value = *number;
      return true;
    }
    return type == "double" ? takeBinary<double>(value) : takeBinary<float>(value);
  }

  bool takeInteger(bool is64, long long& value) {
    if (m_ascii) {
      const auto number = integerIn(m_bytes.takeWord());
      if (!number) return wrong("a word that is no integer");
      value = *number;
      return true;
    }
    return is64 ? takeBinary<std::int64_t>(value) : takeBinary<std::int32_t>(value);
  }

  bool readPoints() {
    std::size_t count = 0;
    if (!takeCount(12, count)) return false;
    const std::string type = lower(m_bytes.takeWord());
    if (type != "float" && type != "double") return wrong("points that are neither float nor double");
    if (!endHeaderLine()) return false;
    m_cells.points().resize(count);
    for (Vec3& x : m_cells.points())
      for (double& value : x)
        if (!takeReal(type, value)) return false;
    return true;
  }

  bool take(Cells kind, std::vector<long long>& corners) {
    switch (kind) {
      case Cells::Vertices: m_cells.note(ImportNote::PointsDropped, static_cast<long>(corners.size())); return true;
      case Cells::Lines: m_cells.note(ImportNote::LinesDropped, 1); return true;
      case Cells::Polygons: return pass(m_cells.polygon(corners, 0));
      case Cells::Strips: return pass(m_cells.strip(corners, 0));
      case Cells::Grid: m_kept.push_back(corners); return true;  // their types follow
    }
    return false;
  }

  bool readCells(Cells kind) { return m_offsets ? readOffsetCells(kind) : readCountedCells(kind); }

  bool readCountedCells(Cells kind) {
    std::size_t cells = 0, numbers = 0;
    if (!takeCount(4, cells) || !takeCount(4, numbers) || !endHeaderLine()) return false;
    std::vector<long long> corners;
    for (std::size_t cell = 0, used = 0; cell < cells; ++cell) {
      long long count = 0;
      if (!takeInteger(false, count)) return false;
      if (count < 1 || static_cast<unsigned long long>(count) >= numbers - used)
        return fail(Fault::BadMesh, {"cells whose size does not fit their number"});
      used += static_cast<std::size_t>(count) + 1;
      corners.resize(static_cast<std::size_t>(count));
      for (long long& corner : corners)
        if (!takeInteger(false, corner)) return false;
      if (!take(kind, corners)) return false;
      if (cell + 1 == cells && used != numbers) return fail(Fault::BadMesh, {"cells whose size does not fit their number"});
      if (cell + 1 < cells && used >= numbers) return fail(Fault::BadMesh, {"cells whose size does not fit their number"});
    }
    return true;
  }

  /// Of the cells that were read before.
  bool readTypes() {
    std::size_t count = 0;
    if (!takeCount(4, count) || !endHeaderLine()) return false;
    if (count != m_kept.size()) return fail(Fault::BadMesh, {"as many types as cells are wanted"});
    for (std::vector<long long>& corners : m_kept) {
      long long type = 0;
      if (!takeInteger(false, type)) return false;
      if (!pass(m_cells.cell(static_cast<int>(std::clamp(type, -1ll, 1000ll)), corners, 0))) return false;
    }
    m_kept.clear();
    return true;
  }

  bool takeArray(const char* name, std::vector<long long>& values) {
    const std::string word = lower(m_bytes.takeWord()), type = lower(m_bytes.takeWord());
    const bool is64 = type == "vtktypeint64";
    if (word != name || (!is64 && type != "vtktypeint32" && type != "int")) return wrong("cells without " + std::string(name));
    if (!endHeaderLine()) return false;
    for (long long& value : values)
      if (!takeInteger(is64, value)) return false;
    return true;
  }

  bool readOffsetCells(Cells kind) {
    std::size_t offsetCount = 0, cornerCount = 0;
    if (!takeCount(4, offsetCount) || !takeCount(4, cornerCount) || !endHeaderLine()) return false;
    std::vector<long long> offsets(offsetCount), all(cornerCount), corners;
    if (!takeArray("offsets", offsets) || !takeArray("connectivity", all)) return false;
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
      const long long from = offsets[i], to = offsets[i + 1];
      if (from < 0 || to <= from || to > static_cast<long long>(all.size()))
        return fail(Fault::BadMesh, {"cells whose offsets do not ascend"});
      corners.assign(all.begin() + from, all.begin() + to);
      if (!take(kind, corners)) return false;
    }
    return true;
  }

  ByteReader m_bytes;
  const std::string& m_file;
  bool m_ascii = true, m_offsets = false, m_grid = false;
  std::vector<std::vector<long long>> m_kept;  ///< cells of a grid until their types are known
  VtkCells m_cells;
  Error m_error;
};

}  // namespace

Result<ImportedFile> parseVtkSurface(std::string_view bytes, const std::string& file) { return LegacyFile(bytes, file).read(); }

}  // namespace glenoid
