// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/file/Zip.h"

#include <sys/stat.h>
#include <zip.h>

#include <algorithm>
#include <memory>
#include <set>

#include "simcore/base/Utf8.h"
#include "simcore/file/AtomicWrite.h"

namespace glenoid {
namespace {

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Archive = std::unique_ptr<zip_t, Discard>;
using OpenEntry = std::unique_ptr<zip_file_t, Discard>;
using Source = std::unique_ptr<zip_source_t, Discard>;

Error fault(Fault kind, const std::string& path, Arguments arguments, const std::string& detail) {
  return {kind, {path, {}, {}, {}}, std::move(arguments), detail};
}

Error wrong(const std::string& path, const std::string& name, const std::string& what) {
  std::string shown = name.substr(0, 200);
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';  // a sentence is one line
  return fault(Fault::SchemaMismatch, path, {"the archive's entry “" + shown + "” " + what}, "zip");
}

/// What libzip says of an archive, as a fault.
Error from(zip_error_t* error, const std::string& path) {
  const std::string words = zip_error_strerror(error);
  switch (zip_error_code_zip(error)) {
    case ZIP_ER_NOZIP: return fault(Fault::UnknownFormat, path, {}, words);
    case ZIP_ER_CRC: return fault(Fault::HashMismatch, path, {}, words);
    case ZIP_ER_EOF:
    case ZIP_ER_SEEK:
    case ZIP_ER_READ:
    case ZIP_ER_INCONS:
    case ZIP_ER_ZLIB: return fault(Fault::FileTruncated, path, {}, words);
    case ZIP_ER_COMPNOTSUPP:
      return fault(Fault::SchemaMismatch, path, {"the archive is packed by a method that is not read here; pack it by deflate, as zip programs do unless told otherwise"}, "zip");
    case ZIP_ER_MEMORY: return fault(Fault::OutOfMemory, path, {"what is free"}, words);
  }
  return fault(Fault::SchemaMismatch, path, {"the archive cannot be read (" + words + ")"}, "zip");
}

struct Listed {
  zip_uint64_t index, size;
  std::string name;
};

/// The files of an archive, all of them within the limits and fit to be unpacked.
Result<std::vector<Listed>> filesOf(zip_t* archive, const std::string& path, const ZipLimits& limits) {
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  if (count > limits.entries) return fault(Fault::FileTooLarge, path, {std::to_string(count) + " entries", std::to_string(limits.entries)}, "zip");
  std::vector<Listed> files;
  std::set<std::string> names;
  std::uint64_t all = 0;
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    if (zip_stat_index(archive, i, 0, &stat) != 0) return from(zip_get_error(archive), path);
    const zip_uint64_t needed = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_ENCRYPTION_METHOD;
    const std::string name = stat.valid & ZIP_STAT_NAME ? stat.name : "";
    if ((stat.valid & needed) != needed) return wrong(path, name, "has no name or no size");
    const bool folder = !name.empty() && name.back() == '/';
    if (!isSafeEntryName(folder ? std::string_view(name).substr(0, name.size() - 1) : std::string_view(name)))
      return wrong(path, name, "has a name that leaves its folder");
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    if (zip_file_get_external_attributes(archive, i, 0, &system, &attributes) != 0) return from(zip_get_error(archive), path);
    const auto type = system == ZIP_OPSYS_UNIX ? (attributes >> 16) & S_IFMT : 0u;
    if (type != 0 && type != S_IFREG && type != S_IFDIR) return wrong(path, name, "is a link or a device");
    if (folder) continue;
    if (stat.encryption_method != ZIP_EM_NONE) return wrong(path, name, "is encrypted");
    if (!names.insert(name).second) return fault(Fault::DuplicateId, path, {name}, "zip");
    if (stat.size > limits.entryBytes) return fault(Fault::FileTooLarge, path, {std::to_string(stat.size) + " bytes", std::to_string(limits.entryBytes)}, name);
    all += stat.size;
    if (all > limits.bytes) return fault(Fault::FileTooLarge, path, {std::to_string(all) + " bytes", std::to_string(limits.bytes)}, "unpacked");
    files.push_back({static_cast<zip_uint64_t>(i), stat.size, name});
  }
  return files;
}

/// One file, as long as it said it would be. Reads in pieces, so that a false size costs nothing.
Result<std::string> unpacked(zip_t* archive, const Listed& file, const std::string& path) {
  const OpenEntry entry(zip_fopen_index(archive, file.index, 0));
  if (!entry) return from(zip_get_error(archive), path);
  std::string bytes;
  std::vector<char> piece(1 << 16);
  for (;;) {
    const zip_int64_t got = zip_fread(entry.get(), piece.data(), piece.size());
    if (got < 0) return from(zip_file_get_error(entry.get()), path);
    if (got == 0) break;
    if (bytes.size() + static_cast<std::uint64_t>(got) > file.size) return wrong(path, file.name, "holds more than it declares");
    bytes.append(piece.data(), static_cast<std::size_t>(got));
  }
  if (bytes.size() != file.size) return wrong(path, file.name, "holds less than it declares");
  return bytes;
}

}  // namespace

bool isSafeEntryName(std::string_view name) {
  if (name.empty() || name.size() > 1000 || name.front() == '/' || !isUtf8(name)) return false;
  for (const char c : name)
    if (static_cast<unsigned char>(c) < ' ' || c == '\\' || c == ':' || c == 0x7f) return false;
  for (std::size_t from = 0; from <= name.size();) {
    const std::size_t to = std::min(name.find('/', from), name.size());
    const std::string_view word = name.substr(from, to - from);
    if (word.empty() || word == "." || word == ".." || word.size() > 255) return false;
    from = to + 1;
  }
  return true;
}

Result<Done> readZip(const std::string& path, const ZipSink& sink, const ZipLimits& limits) {
  const Result<std::string> whole = readWholeFile(path);
  if (!whole) return whole.error();
  zip_error_t error;
  zip_error_init(&error);
  Source source(zip_source_buffer_create(whole->data(), whole->size(), 0, &error));
  if (!source) return from(&error, path);
  // Without ZIP_CHECKCONS: libarchive (bsdtar, CMake) leaves a size in local headers whose other fields wait for the end of
  // the data, and libzip calls that inconsistent. What an entry holds is held to its size and sum when it is read.
  const Archive archive(zip_open_from_source(source.get(), ZIP_RDONLY, &error));
  if (!archive) return from(&error, path);
  source.release();  // the archive's by now
  const auto files = filesOf(archive.get(), path, limits);
  if (!files) return files.error();
  for (const Listed& file : *files) {
    const auto bytes = unpacked(archive.get(), file, path);
    if (!bytes) return bytes.error();
    if (const auto taken = sink(file.name, *bytes); !taken) return taken;
  }
  return Done{};
}

Result<Done> writeZip(const std::string& path, const std::vector<ZipEntry>& entries) {
  zip_error_t error;
  zip_error_init(&error);
  const auto failed = [&](zip_error_t* why) { return fault(Fault::Internal, path, {}, std::string("zip: ") + zip_error_strerror(why)); };
  const Source buffer(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!buffer) return failed(&error);
  zip_source_keep(buffer.get());  // one for the archive, one for what is read of it below
  Archive archive(zip_open_from_source(buffer.get(), ZIP_CREATE | ZIP_TRUNCATE, &error));
  if (!archive) {
    zip_source_free(buffer.get());
    return failed(&error);
  }
  constexpr zip_uint16_t kTime = 0, kDate = (1 << 5) | 1;  // 1 January 1980, the first that a zip can tell
  for (const ZipEntry& entry : entries) {
    Source content(zip_source_buffer(archive.get(), entry.bytes.data(), entry.bytes.size(), 0));
    if (!content) return failed(zip_get_error(archive.get()));
    const zip_int64_t index = zip_file_add(archive.get(), entry.name.c_str(), content.get(), ZIP_FL_ENC_UTF_8);
    if (index < 0) return failed(zip_get_error(archive.get()));
    content.release();  // the archive's by now
    if (zip_file_set_dostime(archive.get(), index, kTime, kDate, 0) != 0 || zip_set_file_compression(archive.get(), index, ZIP_CM_DEFLATE, 6) != 0)
      return failed(zip_get_error(archive.get()));
  }
  if (zip_close(archive.get()) != 0) return failed(zip_get_error(archive.get()));
  archive.release();
  if (zip_source_open(buffer.get()) != 0) return failed(zip_source_error(buffer.get()));
  std::string bytes;
  std::vector<char> piece(1 << 16);
  zip_int64_t got = 0;
  while ((got = zip_source_read(buffer.get(), piece.data(), piece.size())) > 0) bytes.append(piece.data(), static_cast<std::size_t>(got));
  zip_source_close(buffer.get());
  if (got < 0) return failed(zip_source_error(buffer.get()));
  return writeWholeFile(path, bytes);
}

}  // namespace glenoid
