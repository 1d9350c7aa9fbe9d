// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/ImportSurfaces.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "simcore/import/ImportWorker.h"
#include "simcore/import/MeshFormat.h"
#include "simcore/import/SurfaceWire.h"

extern char** environ;

namespace glenoid {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::string plainNumber(double value) {
  std::string text = std::to_string(value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string mebibytes(std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

/// Cheap refusals that need no process.
Result<Done> looksReadable(const std::string& path, const ImportLimits& limits) {
  const Place place{path, {}, {}, {}};
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0)
    return Error{errno == ENOENT || errno == ENOTDIR ? Fault::FileMissing : Fault::FileUnreadable, place, {}, "import"};
  if (!S_ISREG(info.st_mode) || ::access(path.c_str(), R_OK) != 0) return Error{Fault::FileUnreadable, place, {}, "import"};
  if (info.st_size == 0) return Error{Fault::FileEmpty, place, {}, "import"};
  if (static_cast<std::uint64_t>(info.st_size) > limits.fileBytes)
    return Error{Fault::FileTooLarge, place, {mebibytes(static_cast<std::uint64_t>(info.st_size)), mebibytes(limits.fileBytes)}, "import"};
  if (!formatByEnding(path)) return Error{Fault::UnknownFormat, place, {}, "import"};
  return Done{};
}

/// The child with the reading end of its channel; killed and reaped whatever happens.
class Child {
 public:
  Child() = default;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (m_channel >= 0) ::close(m_channel);
    if (m_process > 0) {
      ::kill(m_process, SIGKILL);
      reap();
    }
  }

  bool start(const std::vector<std::string>& words) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return false;
    m_channel = ends[0];
    // Above the channel's number, so that neither dup2 closes what the other needs.
    const int sender = ::fcntl(ends[1], F_DUPFD_CLOEXEC, kWorkerChannel + 1);
    ::close(ends[1]);
    if (sender < 0) return false;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, sender, kWorkerChannel);
    posix_spawn_file_actions_addclosefrom_np(&actions, kWorkerChannel + 1);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);  // a thread of ours may block signals; the reader shall not
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const bool started = ::posix_spawn(&m_process, arguments[0], &actions, &attributes, arguments.data(), environ) == 0;
    if (!started) m_process = -1;
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    ::close(sender);
    return started;
  }

  int channel() const { return m_channel; }

  /// How it ended, once it has: the status of waitpid. Waits up to the given time.
  std::optional<int> endedWithin(double seconds) {
    const auto until = Clock::now() + std::chrono::duration<double>(seconds);
    while (true) {
      int status = 0;
      const pid_t got = ::waitpid(m_process, &status, WNOHANG);
      if (got == m_process) {
        m_process = -1;
        return status;
      }
      if (got < 0 && errno != EINTR) {  // somebody else reaped it
        m_process = -1;
        return std::nullopt;
      }
      if (Clock::now() >= until) return std::nullopt;
      ::usleep(1000);
    }
  }

 private:
  void reap() {
    int status = 0;
    while (::waitpid(m_process, &status, 0) < 0 && errno == EINTR) {
    }
    m_process = -1;
  }
  pid_t m_process = -1;
  int m_channel = -1;
};

enum class Ending { Closed, TooSlow, TooMuch, Cancelled, Broken };

Ending receive(const Child& child, const ImportLimits& limits, Clock::time_point until, std::string& bytes) {
  std::vector<char> buffer(1 << 16);
  while (true) {
    if (limits.cancelled && limits.cancelled()) return Ending::Cancelled;
    const double left = std::chrono::duration<double>(until - Clock::now()).count();
    if (left <= 0) return Ending::TooSlow;
    pollfd watched{child.channel(), POLLIN, 0};
    const int ready = ::poll(&watched, 1, static_cast<int>(std::ceil(1000 * std::min(left, 0.05))));
    if (ready < 0 && errno != EINTR) return Ending::Broken;
    if (ready <= 0) continue;
    const ssize_t got = ::read(child.channel(), buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return Ending::Broken;
    if (got == 0) return Ending::Closed;
    if (bytes.size() + static_cast<std::size_t>(got) > limits.memory) return Ending::TooMuch;
    bytes.append(buffer.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace

std::string findImportWorker() {
  if (const char* named = std::getenv("GLENOID_IMPORT"); named && *named) return named;
  std::error_code failed;
  const fs::path self = fs::read_symlink("/proc/self/exe", failed);
  return failed ? std::string("glenoid-import") : (self.parent_path() / "glenoid-import").string();
}

Result<ImportedFile> importSurfaces(const std::string& path, const ImportLimits& limits) {
  if (const auto good = looksReadable(path, limits); !good) return good.error();
  const Place place{path, {}, {}, {}};
  const std::string worker = limits.worker.empty() ? findImportWorker() : limits.worker;
  if (::access(worker.c_str(), X_OK) != 0) return Error{Fault::FileMissing, {worker, {}, {}, {}}, {}, "the reader of surfaces"};
  const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.seconds));
  const Error slow{Fault::TimedOut, place, {plainNumber(limits.seconds)}, "import"};
  const Error stopped{Fault::ReaderStopped, place, {}, "import"};
  Child child;
  if (!child.start({worker, path, "--memory", std::to_string(limits.memory), "--seconds",
                    std::to_string(static_cast<long long>(std::ceil(limits.seconds)) + 1), "--triangles", std::to_string(limits.triangles)}))
    return Error{Fault::Internal, place, {}, "the reader of surfaces could not be started"};
  std::string bytes;
  switch (receive(child, limits, until, bytes)) {
    case Ending::Cancelled: return Error{Fault::Cancelled, place, {}, "import"};
    case Ending::TooSlow: return slow;
    case Ending::TooMuch: return Error{Fault::OutOfMemory, place, {mebibytes(limits.memory)}, "import"};
    case Ending::Broken: return stopped;
    case Ending::Closed: break;
  }
  const auto status = child.endedWithin(1);
  if (!status) return stopped;
  if (WIFSIGNALED(*status)) return WTERMSIG(*status) == SIGXCPU ? slow : stopped;
  if (WEXITSTATUS(*status) == kWorkerOutOfMemory) return Error{Fault::OutOfMemory, place, {mebibytes(limits.memory)}, "import"};
  if (WEXITSTATUS(*status) != 0) return stopped;
  return fromWire(bytes, path);
}

}  // namespace glenoid
