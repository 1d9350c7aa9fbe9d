// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/file/PlyHeader.h"

#include <array>

namespace glenoid {
namespace {

struct TypeName {
  std::string_view name, sized;
  PlyType type;
  std::size_t size;
};

constexpr std::array<TypeName, 8> kTypes{{{"char", "int8", PlyType::Int8, 1},
                                          {"uchar", "uint8", PlyType::UInt8, 1},
                                          {"short", "int16", PlyType::Int16, 2},
                                          {"ushort", "uint16", PlyType::UInt16, 2},
                                          {"int", "int32", PlyType::Int32, 4},
                                          {"uint", "uint32", PlyType::UInt32, 4},
                                          {"float", "float32", PlyType::Float32, 4},
                                          {"double", "float64", PlyType::Float64, 8}}};

std::optional<PlyType> typeNamed(std::string_view name) {
  for (const TypeName& known : kTypes)
    if (name == known.name || name == known.sized) return known.type;
  return std::nullopt;
}

/// Words of one header line; anything that makes no sense answers what is wrong.
class HeaderLine {
 public:
  explicit HeaderLine(std::string_view line) : m_words(line) {}
  std::string_view next() { return m_words.takeWord(); }

 private:
  ByteReader m_words;
};

const char* readFormat(HeaderLine& line, PlyHeader& header) {
  const std::string_view name = line.next();
  if (name == "ascii")
    header.encoding = PlyEncoding::Ascii;
  else if (name == "binary_little_endian")
    header.encoding = PlyEncoding::LittleEndian;
  else if (name == "binary_big_endian")
    header.encoding = PlyEncoding::BigEndian;
  else
    return "format is none of ascii, binary_little_endian, binary_big_endian";
  return line.next() == "1.0" ? nullptr : "version is not 1.0";
}

const char* readElement(HeaderLine& line, PlyHeader& header) {
  const std::string_view name = line.next();
  const auto count = integerIn(line.next());
  if (name.empty() || !count || *count < 0) return "element without name or count";
  header.elements.push_back({std::string(name), *count, {}});
  return nullptr;
}

const char* readProperty(HeaderLine& line, PlyHeader& header) {
  if (header.elements.empty()) return "property before the first element";
  PlyProperty property;
  std::string_view typeName = line.next();
  if (typeName == "list") {
    property.isList = true;
    const auto count = typeNamed(line.next());
    if (!count || *count == PlyType::Float32 || *count == PlyType::Float64)
      return "list whose count has no integer type";
    property.countType = *count;
    typeName = line.next();
  }
  const auto type = typeNamed(typeName);
  if (!type) return "property of unknown type";
  property.type = *type;
  property.name = line.next();
  if (property.name.empty()) return "property without name";
  header.elements.back().properties.push_back(property);
  return nullptr;
}

}  // namespace

std::size_t sizeOf(PlyType type) {
  return kTypes[static_cast<std::size_t>(type)].size;
}

Result<PlyHeader> readPlyHeader(ByteReader& reader, const std::string& file) {
  const Place whole{file, {}, {}, {}};
  if (const auto magic = reader.takeLine(); !magic || *magic != "ply") {
    // A file cut inside its first word is still recognised as what it was.
    const bool begun = magic && !magic->empty() && std::string_view("ply").substr(0, magic->size()) == *magic;
    return Error{begun ? Fault::FileTruncated : Fault::UnknownFormat, whole, {}, "no PLY header"};
  }
  PlyHeader header;
  bool hasFormat = false;
  while (const auto text = reader.takeLine()) {
    HeaderLine line(*text);
    const std::string_view word = line.next();
    const char* wrong = nullptr;
    if (word == "end_header") {
      if (!hasFormat) return Error{Fault::BadMesh, whole, {"the header has no format line"}, {}};
      return header;
    }
    if (word == "format") {
      wrong = readFormat(line, header);
      hasFormat = true;
    } else if (word == "element") {
      wrong = readElement(line, header);
    } else if (word == "property") {
      wrong = readProperty(line, header);
    } else if (word != "comment" && word != "obj_info" && !word.empty()) {
      wrong = "unknown word in the header";
    }
    if (wrong && reader.left() == 0) break;  // the cut went through this line
    if (wrong) return Error{Fault::BadMesh, {file, {}, {}, reader.line()}, {wrong}, std::string(*text)};
  }
  return Error{Fault::FileTruncated, whole, {}, "the PLY header does not end"};
}

}  // namespace glenoid
