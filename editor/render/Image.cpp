// SPDX-License-Identifier: GPL-3.0-or-later
// PNG in its plain form. Source: W3C Recommendation "Portable Network Graphics (PNG) Specification", 2nd
// edition, sections 5 (chunks), 9 (filtering) and 11 (chunk contents).
#include "editor/render/Image.h"

#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace glenoid {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::uint8_t kSignature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

void put32(Bytes& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint32_t get32(const std::uint8_t* p) {
  return std::uint32_t{p[0]} << 24 | std::uint32_t{p[1]} << 16 | std::uint32_t{p[2]} << 8 | p[3];
}

void putChunk(Bytes& out, const char* type, const Bytes& data) {
  put32(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t from = out.size();
  out.insert(out.end(), type, type + 4);
  out.insert(out.end(), data.begin(), data.end());
  put32(out, static_cast<std::uint32_t>(crc32(0, out.data() + from, static_cast<uInt>(data.size() + 4))));
}

int paeth(int a, int b, int c) {
  const int p = a + b - c, pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

/// What filter `type` predicts for byte i of a row, given the row itself and the one above.
int predicted(int type, const std::uint8_t* row, const std::uint8_t* above, int i, int step) {
  const int a = i >= step ? row[i - step] : 0;
  const int b = above ? above[i] : 0;
  const int c = above && i >= step ? above[i - step] : 0;
  switch (type) {
    case 1:
      return a;
    case 2:
      return b;
    case 3:
      return (a + b) / 2;
    case 4:
      return paeth(a, b, c);
    default:
      return 0;
  }
}

/// Filtered rows, each with its filter byte: for each row the filter with the smallest sum of residuals.
Bytes filtered(const Bytes& pixels, int rowBytes, int height, int step) {
  Bytes out, best, candidate(rowBytes);
  out.reserve(pixels.size() + height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row = pixels.data() + static_cast<std::size_t>(y) * rowBytes;
    const std::uint8_t* above = y > 0 ? row - rowBytes : nullptr;
    long bestSum = -1;
    int bestType = 0;
    for (int type = 0; type <= 4; ++type) {
      long sum = 0;
      for (int i = 0; i < rowBytes; ++i) {
        candidate[i] = static_cast<std::uint8_t>(row[i] - predicted(type, row, above, i, step));
        sum += std::abs(static_cast<std::int8_t>(candidate[i]));
      }
      if (bestSum >= 0 && sum >= bestSum) continue;
      bestSum = sum;
      bestType = type;
      best = candidate;
    }
    out.push_back(static_cast<std::uint8_t>(bestType));
    out.insert(out.end(), best.begin(), best.end());
  }
  return out;
}

Error pngError(Fault fault, const char* detail) {
  return Error{fault, {}, {}, std::string("PNG: ") + detail};
}

struct Header {
  int width = 0, height = 0, channels = 0;
};

Result<Header> readHeader(const std::uint8_t* data, std::size_t size) {
  if (size != 13) return pngError(Fault::UnknownFormat, "header length");
  const std::uint32_t width = get32(data), height = get32(data + 4);
  if (width < 1 || height < 1) return pngError(Fault::UnknownFormat, "empty picture");
  if (width > static_cast<std::uint32_t>(kImageSideMax) ||
      height > static_cast<std::uint32_t>(kImageSideMax)) {
    Error error = pngError(Fault::FileTooLarge, "side");
    error.arguments = {std::to_string(std::max(width, height)), std::to_string(kImageSideMax)};
    return error;
  }
  if (data[8] != 8 || data[10] != 0 || data[11] != 0 || data[12] != 0)
    return pngError(Fault::UnknownFormat, "only 8 bits, not interlaced");
  Header header{static_cast<int>(width), static_cast<int>(height), 0};
  switch (data[9]) {
    case 0:
      header.channels = 1;
      break;
    case 2:
      header.channels = 3;
      break;
    case 4:
      header.channels = 2;
      break;
    case 6:
      header.channels = 4;
      break;
    default:
      return pngError(Fault::UnknownFormat, "palette");
  }
  return header;
}

Result<Image> unpack(const Header& header, const Bytes& packed) {
  const std::size_t rowBytes = static_cast<std::size_t>(header.width) * header.channels;
  Bytes raw((rowBytes + 1) * header.height);
  uLongf size = static_cast<uLongf>(raw.size());
  const int status = uncompress(raw.data(), &size, packed.data(), static_cast<uLong>(packed.size()));
  if (status == Z_BUF_ERROR && size < raw.size()) return pngError(Fault::FileTruncated, "pixel data");
  if (status != Z_OK && status != Z_BUF_ERROR)
    return pngError(Fault::HashMismatch, "pixel data do not unpack");
  if (size != raw.size()) return pngError(Fault::FileTruncated, "fewer rows than promised");

  Image image{header.width, header.height, {}};
  image.rgba.resize(4 * static_cast<std::size_t>(header.width) * header.height);
  Bytes row(rowBytes), above;
  for (int y = 0; y < header.height; ++y) {
    const std::uint8_t* in = raw.data() + y * (rowBytes + 1);
    if (in[0] > 4) return pngError(Fault::UnknownFormat, "filter");
    for (std::size_t i = 0; i < rowBytes; ++i) {
      const int guess =
          predicted(in[0], row.data(), y > 0 ? above.data() : nullptr, static_cast<int>(i), header.channels);
      row[i] = static_cast<std::uint8_t>(in[i + 1] + guess);
    }
    for (int x = 0; x < header.width; ++x) {
      const std::uint8_t* p = row.data() + x * header.channels;
      std::uint8_t* out = image.rgba.data() + 4 * (static_cast<std::size_t>(y) * header.width + x);
      const bool grey = header.channels < 3;
      for (int c = 0; c < 3; ++c) out[c] = grey ? p[0] : p[c];
      out[3] = header.channels == 2 ? p[1] : header.channels == 4 ? p[3] : 255;
    }
    above = row;
  }
  return image;
}

}  // namespace

Result<std::vector<std::uint8_t>> encodePng(const Image& image,
                                            const std::vector<std::array<std::string, 2>>& text) {
  const bool sized =
      image.width > 0 && image.height > 0 && image.width <= kImageSideMax && image.height <= kImageSideMax;
  if (!sized || image.rgba.size() != 4 * static_cast<std::size_t>(image.width) * image.height)
    return Error{Fault::OutOfRange,
                 {},
                 {std::to_string(image.width) + "x" + std::to_string(image.height), "1",
                  std::to_string(kImageSideMax)},
                 "picture size"};
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque = opaque && image.rgba[i] == 255;
  const int channels = opaque ? 3 : 4;
  Bytes pixels;
  pixels.reserve(image.rgba.size());
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    pixels.insert(pixels.end(), image.rgba.begin() + i, image.rgba.begin() + i + channels);

  const Bytes rows = filtered(pixels, image.width * channels, image.height, channels);
  uLongf size = compressBound(static_cast<uLong>(rows.size()));
  Bytes packed(size);
  if (compress2(packed.data(), &size, rows.data(), static_cast<uLong>(rows.size()), 9) != Z_OK)
    return Error{Fault::Internal, {}, {}, "zlib does not compress"};
  packed.resize(size);

  Bytes out(kSignature, kSignature + 8), header;
  put32(header, static_cast<std::uint32_t>(image.width));
  put32(header, static_cast<std::uint32_t>(image.height));
  for (const int byte : {8, opaque ? 2 : 6, 0, 0, 0}) header.push_back(static_cast<std::uint8_t>(byte));
  putChunk(out, "IHDR", header);
  putChunk(out, "sRGB", {0});
  for (const auto& [key, value] : text) {
    Bytes data(key.begin(), key.begin() + std::min<std::size_t>(key.size(), 79));
    data.push_back(0);
    data.insert(data.end(), value.begin(), value.end());
    putChunk(out, "tEXt", data);
  }
  putChunk(out, "IDAT", packed);
  putChunk(out, "IEND", {});
  return out;
}

Result<Done> writePng(const Image& image, const std::string& path,
                      const std::vector<std::array<std::string, 2>>& text) {
  auto bytes = encodePng(image, text);
  if (!bytes) return bytes.error();
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
  file.close();
  if (!file) return Error{Fault::FileUnwritable, {path, {}, {}, {}}, {}, "picture"};
  return Done{};
}

Result<Image> decodePng(const std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) return pngError(Fault::FileEmpty, "no bytes");
  if (std::memcmp(bytes.data(), kSignature, std::min<std::size_t>(8, bytes.size())) != 0)
    return pngError(Fault::UnknownFormat, "signature");
  Header header;
  Bytes packed;
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t length = get32(bytes.data() + at);
    if (length > bytes.size() - at - 12) return pngError(Fault::FileTruncated, "chunk");
    const std::uint8_t* type = bytes.data() + at + 4;
    const std::uint8_t* data = type + 4;
    if (crc32(0, type, static_cast<uInt>(length + 4)) != get32(data + length))
      return pngError(Fault::HashMismatch, "check sum of a chunk");
    const std::string name(type, type + 4);
    if (header.width == 0) {
      if (name != "IHDR") return pngError(Fault::UnknownFormat, "first chunk");
      auto read = readHeader(data, length);
      if (!read) return read.error();
      header = *read;
    } else if (name == "IDAT") {
      packed.insert(packed.end(), data, data + length);
    } else if (name == "IEND") {
      return unpack(header, packed);
    }
    at += length + 12;
  }
  return pngError(Fault::FileTruncated, "no end");
}

Result<Image> readPng(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    return Error{Fault::FileMissing, {path, {}, {}, {}}, {}, "picture"};
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, ignored))
    return Error{Fault::FileUnreadable, {path, {}, {}, {}}, {}, "picture"};
  const Bytes bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  auto image = decodePng(bytes);
  if (!image) image.error().place.file = path;
  return image;
}

}  // namespace glenoid
