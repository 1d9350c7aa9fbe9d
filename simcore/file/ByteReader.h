// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace glenoid {

/// Forward reader over the bytes of a mesh file, shared by the formats here. Never reads beyond the end: whoever asks
/// for more than there is gets nothing back.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : m_bytes(bytes) {}

  std::size_t left() const { return m_bytes.size() - m_at; }
  std::size_t position() const { return m_at; }
  long line() const { return m_line; }  ///< of the header, from 1

  /// Up to the line break, which is taken but not answered ("\n", "\r\n").
  std::optional<std::string_view> takeLine() {
    if (left() == 0) return std::nullopt;
    const std::size_t end = m_bytes.find('\n', m_at);
    const bool whole = end != std::string_view::npos;
    std::string_view line = m_bytes.substr(m_at, whole ? end - m_at : std::string_view::npos);
    m_at = whole ? end + 1 : m_bytes.size();
    ++m_line;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  /// Next word between white space; empty at the end.
  std::string_view takeWord() {
    while (left() > 0 && isSpace(m_bytes[m_at])) ++m_at;
    const std::size_t begin = m_at;
    while (left() > 0 && !isSpace(m_bytes[m_at])) ++m_at;
    return m_bytes.substr(begin, m_at - begin);
  }

  /// One binary number in the given byte order.
  template <class T>
  std::optional<T> take(std::endian order) {
    if (left() < sizeof(T)) return std::nullopt;
    char raw[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i)
      raw[i] = m_bytes[m_at + (order == std::endian::native ? i : sizeof(T) - 1 - i)];
    m_at += sizeof(T);
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }

  bool skip(std::size_t count) {
    if (left() < count) return false;
    m_at += count;
    return true;
  }

  static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }

 private:
  std::string_view m_bytes;
  std::size_t m_at = 0;
  long m_line = 0;
};

/// The whole word as a number, in the C locale; NaN and infinities are numbers here, so that they can be named.
inline std::optional<double> realIn(std::string_view word) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size()) return std::nullopt;
  if (failed == std::errc::result_out_of_range)  // 1e999 or 1e-999: tell them apart by the exponent
    return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos ? 0.0 : HUGE_VAL;
  if (failed != std::errc()) return std::nullopt;
  return value;
}

inline std::optional<long long> integerIn(std::string_view word) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  long long value = 0;
  const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || failed != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// Appends the bytes of a number in the given order.
template <class T>
void appendBytes(T value, std::endian order, std::string& out) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (order != std::endian::native)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  out.append(raw, sizeof(T));
}

}  // namespace glenoid
