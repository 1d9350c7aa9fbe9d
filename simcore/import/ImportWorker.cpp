// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/ImportWorker.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "simcore/import/ReadSurfaces.h"
#include "simcore/import/SurfaceWire.h"

namespace glenoid {
namespace {

void limit(int what, rlim_t most) {
  rlimit now{};
  if (getrlimit(static_cast<__rlimit_resource_t>(what), &now) != 0) return;
  if (now.rlim_max != RLIM_INFINITY && now.rlim_max < most) most = now.rlim_max;
  now.rlim_cur = now.rlim_max = most;
  setrlimit(static_cast<__rlimit_resource_t>(what), &now);
}

void limitYourself(unsigned long long memory, unsigned long long seconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // who asked is gone: nobody waits for the answer
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);  // it reads; a pipe has no size
  limit(RLIMIT_NOFILE, 64);
  limit(RLIMIT_CPU, seconds);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // their shadow alone is larger than any limit
  limit(RLIMIT_AS, memory);
#else
  (void)memory;
#endif
  // A failed new ends the process at once with a status that says why, whatever a library would have made of it.
  std::set_new_handler([] { _exit(kWorkerOutOfMemory); });
}

bool sendAll(const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t sent = ::write(kWorkerChannel, bytes.data() + at, bytes.size() - at);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += static_cast<std::size_t>(sent);
  }
  return true;
}

/// For tests of what happens when a reader breaks down: GLENOID_IMPORT_TEST names how.
void breakDownIfAsked() {
  const char* how = std::getenv("GLENOID_IMPORT_TEST");
  if (!how) return;
  const auto is = [&](const char* word) { return std::strcmp(how, word) == 0; };
  if (is("abort")) std::abort();
  if (is("crash")) std::raise(SIGSEGV);
  if (is("hang"))
    for (;;) ::pause();
  if (is("spin"))
    for (volatile bool on = true; on;) {
    }
  if (is("exit")) _exit(7);
  if (is("silent")) _exit(0);
  if (is("babble")) {
    sendAll("glenoid-import-1\x01" + std::string(1000, '\xff'));
    _exit(0);
  }
  if (is("flood"))
    while (sendAll(std::string(1 << 20, 'x'))) {
    }
  if (is("allocate"))
    for (;;) {
      char* more = new char[1 << 24];
      std::memset(more, 1, 1 << 24);
    }
}

}  // namespace

int importWorkerMain(int argc, char** argv) {
  std::string file;
  unsigned long long memory = 2ull << 30, seconds = 60, triangles = 20'000'000;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    unsigned long long* number = word == "--memory" ? &memory : word == "--seconds" ? &seconds : word == "--triangles" ? &triangles : nullptr;
    if (number && i + 1 < argc) *number = std::strtoull(argv[++i], nullptr, 10);
    else if (file.empty()) file = word;
    else return kWorkerBadUsage;
  }
  if (file.empty() || ::fcntl(kWorkerChannel, F_GETFD) < 0) return kWorkerBadUsage;
  limitYourself(memory, seconds);
  breakDownIfAsked();
  Result<ImportedFile> result = Error{};
  try {
    result = readSurfaces(file, static_cast<long long>(triangles));
  } catch (const std::bad_alloc&) {
    return kWorkerOutOfMemory;
  } catch (const std::exception& bad) {
    result = Error{Fault::BadMesh, {file, {}, {}, {}}, {"its reader gave up"}, bad.what()};
  }
  const bool sent = sendAll(toWire(result));
  _exit(sent ? 0 : 1);  // no destructors over a scene that may be damaged
}

}  // namespace glenoid
