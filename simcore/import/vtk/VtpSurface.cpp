// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "simcore/file/ByteReader.h"
#include "simcore/import/FileAxes.h"
#include "simcore/import/vtk/VtkSurface.h"
#include "simcore/import/vtk/VtpData.h"
#include "simcore/import/vtk/XmlScan.h"

namespace glenoid {
namespace {

constexpr long long kMostRows = 1ll << 31;

/// Arrays of one kind of cell.
struct CellArrays {
  std::optional<VtpArray> connectivity, offsets;
};

struct Piece {
  long long points = 0, verts = 0, lines = 0, strips = 0, polys = 0, cells = 0;
  std::optional<VtpArray> coordinates;
  CellArrays polygons, triangleStrips, grid;
  std::optional<VtpArray> types;  ///< of the grid's cells
};

class VtpFile {
 public:
  VtpFile(std::string_view bytes, const std::string& file) : m_bytes(bytes), m_file(file), m_cells(file) {}

  Result<ImportedFile> read() {
    if (!readTags()) return m_error;
    for (const Piece& piece : m_pieces)
      if (!readPiece(piece)) return m_error;
    Result<ImportedFile> file = m_cells.finish(m_grid ? "VTU" : "VTP");
    if (file && m_space) file->axes = spaceOf(*m_space);
    return file;
  }

 private:
  bool fail(Fault fault, Arguments arguments = {}) {
    m_error = {fault, {m_file, {}, {}, {}}, std::move(arguments), {}};
    return false;
  }

  bool readTags() {
    XmlScan scan(m_bytes);
    std::string section;  // the child of a Piece that we are in
    bool root = false;
    while (const auto tag = scan.next()) {
      if (!root) {
        if (tag->name != "VTKFile") return fail(Fault::UnknownFormat);
        if (const std::string type = tag->attribute("type"); type != "PolyData") {
          m_grid = type == "UnstructuredGrid";
          if (!m_grid) return fail(Fault::BadMesh, {"it holds " + (type.empty() ? "nothing named" : type.substr(0, 40)) + ", not surfaces (PolyData) or cells (UnstructuredGrid)"});
        }
        root = true;
        m_packing.bigEndian = tag->attribute("byte_order") == "BigEndian";
        m_packing.wideHeader = tag->attribute("header_type") == "UInt64";
        const std::string compressor = tag->attribute("compressor");
        m_packing.zlib = compressor == "vtkZLibDataCompressor";
        if (!compressor.empty() && !m_packing.zlib)
          return fail(Fault::BadMesh, {"it is packed by " + compressor.substr(0, 40) + "; only vtkZLibDataCompressor can be read"});
        continue;
      }
      if (tag->name == "AppendedData" && !tag->closing) {
        m_packing.appendedBase64 = tag->attribute("encoding") == "base64";
        const std::size_t mark = m_bytes.find('_', scan.position());
        if (mark != std::string_view::npos) m_packing.appended = m_bytes.substr(mark + 1);
        return ended();  // what follows need not be XML
      }
      if (tag->name == "VTKFile" && tag->closing) return ended();
      if (tag->name == "Piece" && !tag->closing) {
        m_pieces.emplace_back();
        if (!readCounts(*tag)) return false;
        section.clear();
      } else if (tag->name == "Array" && !tag->closing && m_pieces.empty() && tag->attribute("Name") == "SPACE") {
        m_space = arrayAt(*tag, scan);
      } else if (tag->name == "DataArray" && !tag->closing) {
        if (m_pieces.empty()) continue;
        takeArray(*tag, section, scan);
      } else if (!m_pieces.empty() && (tag->name == "Points" || tag->name == "Polys" || tag->name == "Strips" ||
                                       tag->name == "Lines" || tag->name == "Verts" || tag->name == "Cells" || tag->name == "PointData" ||
                                       tag->name == "CellData")) {
        section = tag->closing || tag->empty ? std::string() : tag->name;
      }
    }
    return root ? fail(Fault::FileTruncated) : fail(scan.broken() ? Fault::FileTruncated : Fault::UnknownFormat);
  }

  bool ended() { return m_pieces.empty() ? fail(Fault::BadMesh, {"it holds no pieces"}) : true; }

  bool readCounts(const XmlScan::Tag& tag) {
    Piece& piece = m_pieces.back();
    for (const auto& [name, count] :
         {std::pair("NumberOfPoints", &piece.points), std::pair("NumberOfVerts", &piece.verts), std::pair("NumberOfLines", &piece.lines),
          std::pair("NumberOfStrips", &piece.strips), std::pair("NumberOfPolys", &piece.polys), std::pair("NumberOfCells", &piece.cells)}) {
      const auto value = integerIn(tag.attribute(name, "0"));
      if (!value || *value < 0 || *value >= kMostRows) return fail(Fault::BadMesh, {std::string(name) + " is no count"});
      *count = *value;
    }
    return true;
  }

  static VtpArray arrayAt(const XmlScan::Tag& tag, const XmlScan& scan) {
    VtpArray array{tag.attribute("type"), tag.attribute("format", "ascii"), tag.empty ? std::string_view() : scan.textHere(), 0};
    if (const auto offset = integerIn(tag.attribute("offset", "0")); offset && *offset >= 0)
      array.offset = static_cast<unsigned long long>(*offset);
    return array;
  }

  /// A string is the codes of its characters, and 0 at its end.
  FileAxes spaceOf(VtpArray array) const {
    array.type = "UInt8";
    std::string word;
    if (const auto codes = vtpNumbers(array, m_packing, 16))
      for (const double code : *codes)
        if (code >= 'A' && code <= 'z') word += static_cast<char>(code);
    return spaceNamed(word);
  }

  void takeArray(const XmlScan::Tag& tag, const std::string& section, const XmlScan& scan) {
    Piece& piece = m_pieces.back();
    if (section == "PointData" || section == "CellData") {
      m_cells.note(ImportNote::DataDropped, 1);
      return;
    }
    const VtpArray array = arrayAt(tag, scan);
    const std::string name = tag.attribute("Name");
    if (section == "Points" && !piece.coordinates) piece.coordinates = array;
    if (section != "Polys" && section != "Strips" && section != "Cells") return;
    if (section == "Cells" && name == "types") piece.types = array;
    CellArrays& cells = section == "Polys" ? piece.polygons : section == "Strips" ? piece.triangleStrips : piece.grid;
    if (name == "connectivity") cells.connectivity = array;
    if (name == "offsets") cells.offsets = array;
  }

  bool readPiece(const Piece& piece) {
    m_cells.note(ImportNote::PointsDropped, static_cast<long>(piece.verts));
    m_cells.note(ImportNote::LinesDropped, static_cast<long>(piece.lines));
    const auto base = static_cast<long long>(m_cells.points().size());
    if (piece.points > 0) {
      const auto numbers = piece.coordinates ? vtpNumbers(*piece.coordinates, m_packing, 3 * static_cast<std::size_t>(piece.points)) : std::nullopt;
      if (!numbers || numbers->size() != 3 * static_cast<std::size_t>(piece.points))
        return fail(Fault::BadMesh, {"its points cannot be made out"});
      if (base + piece.points >= kMostRows) return fail(Fault::BadMesh, {"more points than an index can count"});
      for (std::size_t i = 0; i < numbers->size(); i += 3)
        m_cells.points().push_back({(*numbers)[i], (*numbers)[i + 1], (*numbers)[i + 2]});
    }
    if (m_grid) {
      if (piece.cells == 0) return true;
      const auto types = piece.types ? vtpNumbers(*piece.types, m_packing, static_cast<std::size_t>(piece.cells)) : std::nullopt;
      if (!types || types->size() != static_cast<std::size_t>(piece.cells)) return fail(Fault::BadMesh, {"the types of its cells cannot be made out"});
      return readCells(piece.grid, piece.cells, [&, at = std::size_t{0}](std::vector<long long>& corners) mutable {
        const double type = (*types)[at++];
        return m_cells.cell(type >= 0 && type < 1000 ? static_cast<int>(type) : -1, corners, base);
      });
    }
    return readCells(piece.polygons, piece.polys, [&](std::vector<long long>& corners) { return m_cells.polygon(corners, base); }) &&
           readCells(piece.triangleStrips, piece.strips, [&](std::vector<long long>& corners) { return m_cells.strip(corners, base); });
  }

  template <class Take>
  bool readCells(const CellArrays& arrays, long long count, Take&& take) {
    if (count == 0) return true;
    const char* unclear = "its cells cannot be made out";
    if (!arrays.connectivity || !arrays.offsets) return fail(Fault::BadMesh, {unclear});
    const auto offsets = vtpNumbers(*arrays.offsets, m_packing, static_cast<std::size_t>(count));
    if (!offsets || offsets->size() != static_cast<std::size_t>(count)) return fail(Fault::BadMesh, {unclear});
    const double last = offsets->back();
    if (!(last >= 0 && last < static_cast<double>(kMostRows))) return fail(Fault::BadMesh, {unclear});
    const auto connectivity = vtpNumbers(*arrays.connectivity, m_packing, static_cast<std::size_t>(last));
    if (!connectivity) return fail(Fault::BadMesh, {unclear});
    std::vector<long long> corners;
    double from = 0;
    for (const double to : *offsets) {
      if (!(to > from) || to > static_cast<double>(connectivity->size()) || to != std::floor(to))
        return fail(Fault::BadMesh, {"cells whose offsets do not ascend"});
      corners.clear();
      for (auto i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i) {
        const double index = (*connectivity)[i];
        if (!(index >= 0 && index < static_cast<double>(kMostRows)) || index != std::floor(index))
          return fail(Fault::BadIndex, {std::to_string(index), std::to_string(m_cells.points().size())});
        corners.push_back(static_cast<long long>(index));
      }
      from = to;
      if (const auto good = take(corners); !good) {
        m_error = good.error();
        return false;
      }
    }
    return true;
  }

  std::string_view m_bytes;
  const std::string& m_file;
  VtkCells m_cells;
  VtpPacking m_packing;
  std::vector<Piece> m_pieces;
  std::optional<VtpArray> m_space;  ///< of the coordinates
  bool m_grid = false;
  Error m_error;
};

}  // namespace

Result<ImportedFile> parseVtp(std::string_view bytes, const std::string& file) { return VtpFile(bytes, file).read(); }

}  // namespace glenoid
