// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/Uri.h"

#include <array>
#include <filesystem>

namespace glenoid {
namespace {

namespace fs = std::filesystem;

int hexadecimal(char c) { return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1; }

int sixBits(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

std::string decodedUri(std::string_view uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hexadecimal(uri[i + 1]) : -1, low = high >= 0 ? hexadecimal(uri[i + 2]) : -1;
    if (low >= 0 && high + low > 0) out += static_cast<char>(16 * high + low), i += 2;
    else out += uri[i];
  }
  return out;
}

std::string fileBeside(const std::string& path, std::string_view uri) {
  std::error_code failed;
  const fs::path folder = fs::weakly_canonical(fs::absolute(path, failed).parent_path(), failed);
  if (failed) return {};
  fs::path whole = fs::weakly_canonical(folder / uri, failed);
  if (failed || !fs::is_regular_file(whole, failed)) whole = fs::weakly_canonical(folder / decodedUri(uri), failed);
  if (failed || !fs::is_regular_file(whole, failed)) return {};
  const fs::path inside = whole.lexically_relative(folder);
  return inside.empty() || *inside.begin() == ".." ? std::string() : whole.string();
}

std::optional<std::string> bytesOfDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) return std::nullopt;
  std::string out;
  out.reserve(3 * (uri.size() - comma) / 4);
  unsigned bits = 0;
  int have = 0;
  for (const char c : uri.substr(comma + 1)) {
    if (c == '=') break;
    const int value = sixBits(c);
    if (value < 0) return std::nullopt;
    bits = (bits << 6 | static_cast<unsigned>(value)) & 0xffffffu, have += 6;
    if (have >= 8) have -= 8, out += static_cast<char>(bits >> have & 255u);
  }
  return out;
}

}  // namespace glenoid
