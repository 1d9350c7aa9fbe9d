// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/file/AtomicWrite.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace glenoid {
namespace {

namespace fs = std::filesystem;

class Descriptor {
 public:
  explicit Descriptor(int fd) : m_fd(fd) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return m_fd; }
  bool valid() const { return m_fd >= 0; }
  /// False when the kernel reports a late write error.
  bool close() {
    const int fd = m_fd;
    m_fd = -1;
    return fd < 0 || ::close(fd) == 0;
  }

 private:
  int m_fd;
};

Error fileError(Fault fault, const std::string& path, int code) {
  return {fault, {path, {}, {}, {}}, {}, code ? std::strerror(code) : ""};
}

Fault readFault(int code) {
  return code == ENOENT || code == ENOTDIR ? Fault::FileMissing : Fault::FileUnreadable;
}

/// Where the bytes really go: a link keeps pointing at the file it names.
std::string targetOf(const std::string& path) {
  std::error_code failed;
  if (!fs::is_symlink(path, failed)) return path;
  const fs::path target = fs::weakly_canonical(path, failed);
  return failed ? path : target.string();
}

/// A new file beside `target`. The name says whose it is, should a crash leave it behind.
int openBeside(const std::string& target, std::string& name) {
  const fs::path path(target);
  for (int attempt = 0; attempt < 1000; ++attempt) {
    std::string leaf(".");
    leaf +=
        path.filename().string() + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
    name = (path.parent_path() / leaf).string();
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
  return -1;
}

bool writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// The new name itself reaches the disk with its folder. Some file systems refuse; the bytes are safe
/// already.
void syncFolder(const std::string& target) {
  const fs::path parent = fs::path(target).parent_path();
  const Descriptor folder(::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.valid()) ::fsync(folder.get());
}

}  // namespace

Result<std::string> readWholeFile(const std::string& path, std::uint64_t limit) {
  // Non-blocking, so that a pipe nobody writes to answers at once and is refused below.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file.valid()) return fileError(readFault(errno), path, errno);
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return fileError(Fault::FileUnreadable, path, errno);
  if (!S_ISREG(info.st_mode))
    return fileError(Fault::FileUnreadable, path, S_ISDIR(info.st_mode) ? EISDIR : 0);
  const auto size = static_cast<std::uint64_t>(info.st_size);
  if (size == 0) return fileError(Fault::FileEmpty, path, 0);
  if (size > limit) {
    Error error = fileError(Fault::FileTooLarge, path, 0);
    error.arguments = {std::to_string(size) + " bytes", std::to_string(limit) + " bytes"};
    return error;
  }
  std::string bytes(size, '\0');
  std::size_t have = 0;
  while (have < size) {
    const ssize_t got = ::read(file.get(), bytes.data() + have, size - have);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return fileError(Fault::FileUnreadable, path, errno);
    if (got == 0) break;  // somebody cut it while we read
    have += static_cast<std::size_t>(got);
  }
  bytes.resize(have);
  if (have == 0) return fileError(Fault::FileEmpty, path, 0);
  return bytes;
}

Result<Done> checkWritable(const std::string& path) {
  const std::string target = targetOf(path);
  struct stat old {};
  if (::stat(target.c_str(), &old) == 0 && !S_ISREG(old.st_mode))
    return fileError(Fault::FileUnwritable, path, S_ISDIR(old.st_mode) ? EISDIR : 0);
  std::string temporary;
  const Descriptor file(openBeside(target, temporary));
  if (!file.valid())
    return fileError(errno == ENOENT || errno == ENOTDIR ? Fault::FileMissing : Fault::FileUnwritable, path, errno);
  ::unlink(temporary.c_str());
  return Done{};
}

Result<Done> writeWholeFile(const std::string& path, std::string_view bytes) {
  const std::string target = targetOf(path);
  struct stat old {};
  const bool replaces = ::stat(target.c_str(), &old) == 0;
  if (replaces && !S_ISREG(old.st_mode))
    return fileError(Fault::FileUnwritable, path, S_ISDIR(old.st_mode) ? EISDIR : 0);
  std::string temporary;
  Descriptor file(openBeside(target, temporary));
  if (!file.valid())
    return fileError(errno == ENOENT || errno == ENOTDIR ? Fault::FileMissing : Fault::FileUnwritable, path,
                     errno);
  if (replaces && ::fchmod(file.get(), old.st_mode & 07777) != 0)
    errno = 0;  // the permissions are a courtesy
  if (!writeAll(file.get(), bytes) || ::fsync(file.get()) != 0 || !file.close() ||
      std::rename(temporary.c_str(), target.c_str()) != 0) {
    const int code = errno;
    ::unlink(temporary.c_str());
    return fileError(Fault::FileUnwritable, path, code);
  }
  syncFolder(target);
  return Done{};
}

}  // namespace glenoid
