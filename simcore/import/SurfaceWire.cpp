// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/SurfaceWire.h"

#include <cmath>

#include "simcore/file/ByteReader.h"

namespace glenoid {
namespace {

constexpr std::string_view kBegin = "glenoid-import-2", kEnd = "glenoid-import-e";
constexpr std::size_t kMostText = 10000;

class Writer {
 public:
  template <class T>
  void number(T value) {
    appendBytes(value, std::endian::little, out);
  }
  void text(const std::string& text) {
    const std::size_t size = std::min(text.size(), kMostText);
    number(static_cast<std::uint32_t>(size));
    out.append(text, 0, size);
  }
  std::string out;
};

/// Answers defaults once something did not fit; `bad` tells.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : m_all(bytes), m_bytes(bytes) {}
  template <class T>
  T number() {
    const auto value = m_bytes.take<T>(std::endian::little);
    if (!value) bad = true;
    return value.value_or(T{});
  }
  std::string text() {
    const auto size = number<std::uint32_t>();
    if (size > kMostText || size > m_bytes.left()) bad = true;
    if (bad) return {};
    std::string out(m_all.substr(m_bytes.position(), size));
    m_bytes.skip(size);
    return out;
  }
  /// A count of things of at least so many bytes each.
  std::size_t count(std::size_t bytesEach) {
    const auto value = number<std::uint64_t>();
    if (value > m_bytes.left() / bytesEach || value > 0x7fffffffu) bad = true;
    return bad ? 0 : static_cast<std::size_t>(value);
  }
  bool expect(std::string_view mark) {
    if (m_all.substr(m_bytes.position(), mark.size()) != mark || !m_bytes.skip(mark.size())) bad = true;
    return !bad;
  }
  bool bad = false;

 private:
  std::string_view m_all;
  ByteReader m_bytes;
};

void writeError(Writer& to, const Error& error) {
  to.number(static_cast<std::int32_t>(error.fault));
  to.number(static_cast<std::uint8_t>(error.place.element.has_value()));
  to.number(static_cast<std::int64_t>(error.place.element.value_or(0)));
  to.number(static_cast<std::uint64_t>(error.arguments.size()));
  for (const std::string& argument : error.arguments) to.text(argument);
  to.text(error.detail);
}

Error readError(Reader& from, const std::string& file) {
  Error error;
  const auto fault = from.number<std::int32_t>();
  if (fault < 0 || fault >= kFaultCount) from.bad = true;
  error.fault = from.bad ? Fault::ReaderStopped : static_cast<Fault>(fault);
  const auto has = from.number<std::uint8_t>();
  const auto element = from.number<std::int64_t>();
  if (has) error.place.element = element;
  error.place.file = file;
  const std::size_t arguments = from.count(4);
  for (std::size_t i = 0; i < arguments && !from.bad; ++i) error.arguments.push_back(from.text());
  error.detail = from.text();
  return error;
}

void writeFile(Writer& to, const ImportedFile& file) {
  to.text(file.format);
  to.number(file.metresPerUnit.value_or(0));
  to.number(static_cast<std::int32_t>(file.axes));
  to.number(static_cast<std::uint64_t>(file.notes.size()));
  for (const NoteCount& note : file.notes) {
    to.number(static_cast<std::int32_t>(note.note));
    to.number(static_cast<std::int64_t>(note.count));
  }
  to.number(static_cast<std::uint64_t>(file.surfaces.size()));
  for (const ImportedSurface& surface : file.surfaces) {
    to.text(surface.name);
    to.number(static_cast<std::uint64_t>(surface.mesh.vertices.size()));
    for (const Vec3& v : surface.mesh.vertices)
      for (const double x : v) to.number(x);
    to.number(static_cast<std::uint64_t>(surface.mesh.triangles.size()));
    for (const auto& t : surface.mesh.triangles)
      for (const int i : t) to.number(static_cast<std::int32_t>(i));
  }
}

void readMesh(Reader& from, TriMesh& mesh) {
  mesh.vertices.resize(from.count(24));
  for (Vec3& v : mesh.vertices)
    for (double& x : v) {
      x = from.number<double>();
      if (!std::isfinite(x)) from.bad = true;
    }
  const int size = static_cast<int>(mesh.vertices.size());
  mesh.triangles.resize(from.count(12));
  for (auto& t : mesh.triangles)
    for (int& i : t) {
      i = from.number<std::int32_t>();
      if (i < 0 || i >= size) from.bad = true;
    }
}

ImportedFile readFile(Reader& from) {
  ImportedFile file;
  file.format = from.text();
  const double unit = from.number<double>();
  if (!(unit >= 0 && std::isfinite(unit))) from.bad = true;
  if (unit > 0) file.metresPerUnit = unit;
  const auto axes = from.number<std::int32_t>();
  if (axes < 0 || axes >= kFileAxesCount) from.bad = true;
  if (!from.bad) file.axes = static_cast<FileAxes>(axes);
  const std::size_t notes = from.count(12);
  for (std::size_t i = 0; i < notes && !from.bad; ++i) {
    const auto note = from.number<std::int32_t>();
    const auto count = from.number<std::int64_t>();
    if (note < 0 || note >= kImportNoteCount || count <= 0) from.bad = true;
    if (!from.bad) addNote(file.notes, static_cast<ImportNote>(note), count);
  }
  const std::size_t surfaces = from.count(20);
  for (std::size_t i = 0; i < surfaces && !from.bad; ++i) {
    file.surfaces.emplace_back();
    file.surfaces.back().name = from.text();
    readMesh(from, file.surfaces.back().mesh);
    if (file.surfaces.back().mesh.triangles.empty()) from.bad = true;
  }
  if (file.surfaces.empty()) from.bad = true;
  return file;
}

}  // namespace

std::string toWire(const Result<ImportedFile>& result) {
  Writer to;
  to.out = kBegin;
  to.number(static_cast<std::uint8_t>(result.ok()));
  if (result)
    writeFile(to, *result);
  else
    writeError(to, result.error());
  to.out += kEnd;
  return std::move(to.out);
}

Result<ImportedFile> fromWire(std::string_view bytes, const std::string& file) {
  const Error stopped{Fault::ReaderStopped, {file, {}, {}, {}}, {}, "what the reader sent makes no sense"};
  Reader from(bytes);
  if (!from.expect(kBegin)) return stopped;
  const auto ok = from.number<std::uint8_t>();
  if (ok == 0) {
    Error error = readError(from, file);
    return from.expect(kEnd) && !from.bad ? error : stopped;
  }
  if (ok != 1) return stopped;
  ImportedFile read = readFile(from);
  if (from.bad || !from.expect(kEnd)) return stopped;
  return read;
}

}  // namespace glenoid
