// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/vtk/VtpData.h"

#include <array>
#include <limits>

#include "simcore/file/ByteReader.h"
#include "simcore/import/vtk/Inflate.h"

namespace glenoid {
namespace {

/// Bytes one after the other, as they lie or from base64. Each piece of base64 may end with its own padding; VTK
/// writes the header of an array as a piece of its own.
class Source {
 public:
  Source(std::string_view bytes, bool base64) : m_bytes(bytes), m_base64(base64) {}

  std::optional<std::string> take(std::size_t count) {
    if (count > m_bytes.size()) return std::nullopt;  // neither form makes more bytes than it has
    std::string out;
    if (!m_base64) {
      if (count > m_bytes.size() - m_at) return std::nullopt;
      out = m_bytes.substr(m_at, count);
      m_at += count;
      return out;
    }
    out.reserve(count);
    while (out.size() < count) {
      if (m_ready.empty() && !nextQuad()) return std::nullopt;
      const std::size_t n = std::min(count - out.size(), m_ready.size());
      out.append(m_ready, 0, n);
      m_ready.erase(0, n);
    }
    return out;
  }

 private:
  static int valueOf(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
  }

  bool nextQuad() {
    unsigned bits = 0;
    int have = 0, padding = 0;
    while (have < 4) {
      if (m_at >= m_bytes.size()) return false;
      const char c = m_bytes[m_at++];
      if (ByteReader::isSpace(c)) continue;
      const int value = valueOf(c);
      if (c == '=') ++padding;
      else if (value < 0 || padding > 0) return false;
      bits = (bits << 6) | static_cast<unsigned>(c == '=' ? 0 : value);
      ++have;
    }
    if (padding > 2) return false;
    for (int i = 0; i < 3 - padding; ++i) m_ready.push_back(static_cast<char>((bits >> (16 - 8 * i)) & 255));
    return true;
  }

  std::string_view m_bytes;
  bool m_base64;
  std::size_t m_at = 0;
  std::string m_ready;
};

std::optional<std::uint64_t> takeHeader(Source& source, const VtpPacking& packing) {
  const std::size_t size = packing.wideHeader ? 8 : 4;
  const auto bytes = source.take(size);
  if (!bytes) return std::nullopt;
  ByteReader reader(*bytes);
  const std::endian order = packing.bigEndian ? std::endian::big : std::endian::little;
  if (packing.wideHeader) return reader.take<std::uint64_t>(order);
  return reader.take<std::uint32_t>(order);
}

std::optional<std::string> bytesOf(Source& source, const VtpPacking& packing, std::uint64_t most) {
  const auto first = takeHeader(source, packing);
  if (!first) return std::nullopt;
  if (!packing.zlib) return *first > most ? std::nullopt : source.take(*first);
  const auto blockSize = takeHeader(source, packing), lastSize = takeHeader(source, packing);
  if (!blockSize || !lastSize) return std::nullopt;
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t i = 0; i < *first; ++i) {
    const auto size = takeHeader(source, packing);
    if (!size) return std::nullopt;
    sizes.push_back(*size);
  }
  std::string out;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::uint64_t wanted = i + 1 == sizes.size() && *lastSize > 0 ? *lastSize : *blockSize;
    const auto packed = source.take(sizes[i]);
    if (!packed || wanted > most - out.size()) return std::nullopt;
    const auto block = inflated(*packed, wanted);
    if (!block || block->size() != wanted) return std::nullopt;
    out += *block;
  }
  return out;
}

template <class T>
std::vector<double> numbersIn(const std::string& bytes, bool bigEndian) {
  std::vector<double> numbers;
  numbers.reserve(bytes.size() / sizeof(T));
  ByteReader reader(bytes);
  while (const auto value = reader.take<T>(bigEndian ? std::endian::big : std::endian::little))
    numbers.push_back(static_cast<double>(*value));
  return numbers;
}

std::optional<std::vector<double>> numbersAs(const std::string& type, const std::string& bytes, bool big) {
  if (type == "Float32") return numbersIn<float>(bytes, big);
  if (type == "Float64") return numbersIn<double>(bytes, big);
  if (type == "Int32") return numbersIn<std::int32_t>(bytes, big);
  if (type == "Int64") return numbersIn<std::int64_t>(bytes, big);
  if (type == "UInt32") return numbersIn<std::uint32_t>(bytes, big);
  if (type == "UInt64") return numbersIn<std::uint64_t>(bytes, big);
  if (type == "Int16") return numbersIn<std::int16_t>(bytes, big);
  if (type == "UInt16") return numbersIn<std::uint16_t>(bytes, big);
  if (type == "Int8") return numbersIn<std::int8_t>(bytes, big);
  if (type == "UInt8") return numbersIn<std::uint8_t>(bytes, big);
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<double>> vtpNumbers(const VtpArray& array, const VtpPacking& packing, std::size_t most) {
  if (array.format == "ascii") {
    std::vector<double> numbers;
    ByteReader words(array.text);
    for (std::string_view word = words.takeWord(); !word.empty(); word = words.takeWord()) {
      const auto number = realIn(word);
      if (!number || numbers.size() == most) return std::nullopt;
      numbers.push_back(*number);
    }
    return numbers;
  }
  const bool appended = array.format == "appended";
  if (!appended && array.format != "binary") return std::nullopt;
  const std::string_view from = appended ? packing.appended : array.text;
  if (appended && array.offset > from.size()) return std::nullopt;
  Source source(appended ? from.substr(array.offset) : from, !appended || packing.appendedBase64);
  const auto bytes = bytesOf(source, packing, 8 * static_cast<std::uint64_t>(most));
  if (!bytes) return std::nullopt;
  auto numbers = numbersAs(array.type, *bytes, packing.bigEndian);
  if (!numbers || numbers->size() > most) return std::nullopt;
  return numbers;
}

}  // namespace glenoid
