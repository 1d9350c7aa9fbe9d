// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/file/ByteReader.h"

namespace glenoid {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// One column of an element: a number, or a counted list of numbers.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  bool isList = false;
  PlyType countType = PlyType::UInt8;
};

struct PlyElement {
  std::string name;
  long long count = 0;
  std::vector<PlyProperty> properties;
};

/// What stands between "ply" and "end_header"; the reader is then at the first byte of the data.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
};

std::size_t sizeOf(PlyType type);

/// Fails with UnknownFormat, BadMesh (element: line) or FileTruncated.
Result<PlyHeader> readPlyHeader(ByteReader& reader, const std::string& file);

}  // namespace glenoid
