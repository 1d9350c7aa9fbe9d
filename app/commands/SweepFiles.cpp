// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/SweepFiles.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>

#include "app/commands/Console.h"
#include "app/commands/StudyFiles.h"
#include "simcore/file/Json.h"
#include "simcore/file/JsonObject.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&time, &utc);
  char words[32];
  std::strftime(words, sizeof words, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return words;
}

std::string hostName() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

bool isThere(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// The first member in which two objects differ, whatever the order of their members; nothing where they are the same.
std::optional<std::string> difference(const JsonValue& a, const JsonValue& b) {
  for (const auto& [key, value] : a.members())
    if (b[key] != value) return key;
  if (a.members().size() != b.members().size()) return "options";
  return std::nullopt;
}

/// One part as its status file has it.
std::string statusWords(const JsonValue& status) {
  const std::string state = status["state"].text(), on = status["host"].text();
  const std::string far =
      text("%ld of %ld settings", status["finished"].integer(), status["settings"].integer());
  if (state == "done") return "done on " + on + " at " + status["written"].text();
  if (state == "failed") return "failed on " + on + " after " + far + ": " + status["error"].text();
  const auto pid = static_cast<pid_t>(status["pid"].integer());
  if (on == hostName() && pid > 0 && kill(pid, 0) != 0 && errno == ESRCH)
    return "ended without a word after " + far + ": it was killed; run it again with --resume";
  return "running on " + on + ", " + far + ", last word at " + status["written"].text();
}

}  // namespace

SweepFiles::SweepFiles(std::string folder, int shard, int shards, JsonValue of)
    : m_began(now()), m_of(std::move(of)), m_number(shard), m_count(shards) {
  const std::string stem = shards > 0 ? text("shard-%d-of-%d", shard, shards) : "accuracy";
  if (shards > 0) m_shard = inFolder(folder, stem + ".json");
  m_partial = inFolder(folder, stem + ".partial.json");
  m_status = inFolder(folder, stem + ".status.json");
}

Result<JsonValue> SweepFiles::readOwn(const std::string& path) const {
  Result<JsonValue> json = readJson(path);
  if (!json) return json;
  const std::optional<std::string> other = difference(m_of, (*json)["of"]);
  if (!other) return json;
  return Error{Fault::BadUsage,
               {path, "", "", {}},
               {"what stands there was measured of something else (its “" + *other +
                "” is another); give another --out, or take it away"},
               "sweep"};
}

Result<bool> SweepFiles::isDone() const {
  if (m_shard.empty() || !isThere(m_shard)) return false;
  const Result<JsonValue> json = readOwn(m_shard);
  if (!json) return json.error();
  return true;
}

Result<std::optional<JsonValue>> SweepFiles::left() const {
  if (!isThere(m_partial)) return std::optional<JsonValue>();
  Result<JsonValue> json = readOwn(m_partial);
  if (!json) return json.error();
  return std::optional<JsonValue>(std::move(*json));
}

Result<Done> SweepFiles::say(const char* state, const std::string& error) const {
  return writeJson(m_status, jsonObject({{"state", state},
                                         {"shard", m_number},
                                         {"shards", m_count},
                                         {"finished", m_finished},
                                         {"settings", m_settings},
                                         {"host", hostName()},
                                         {"pid", static_cast<long>(getpid())},
                                         {"began", m_began},
                                         {"written", now()},
                                         {"error", error}}));
}

Result<Done> SweepFiles::begin(long settings) {
  m_settings = settings;
  return say("running");
}

Result<Done> SweepFiles::keep(JsonValue soFar, long finished, long settings) {
  m_finished = finished;
  m_settings = settings;
  soFar.set("of", m_of);
  if (const auto saved = writeJson(m_partial, soFar); !saved) return saved;
  return say("running");
}

Result<Done> SweepFiles::finish(JsonValue whole) {
  if (!m_shard.empty()) {
    whole.set("of", m_of);
    if (const auto saved = writeJson(m_shard, whole); !saved) return saved;
  }
  std::error_code ignored;
  fs::remove(m_partial, ignored);
  return say("done");
}

void SweepFiles::fail(const std::string& sentence) {
  static_cast<void>(say("failed", sentence));
}

Result<SweepStatus> sweepStatus(const std::string& folder) {
  std::map<int, std::string> words;  // by part
  int parts = -1;
  bool done = true;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    if (!it->path().filename().string().ends_with(".status.json")) continue;
    const Result<JsonValue> status = readJson(it->path().string());
    if (!status) return status.error();
    const auto shard = static_cast<int>((*status)["shard"].integer());
    const auto shards = static_cast<int>((*status)["shards"].integer());
    if (parts > 0 && shards > 0 && shards != parts)
      return Error{Fault::BadUsage, {folder, "", "", {}}, {text("there are shards of a sweep in %d parts and of one in %d; take those of one away", parts, shards)}, "sweep"};
    if (shards == 0 && parts > 0) continue;  // an older study of the whole in the same folder
    if (shards > 0 && parts == 0) words.clear(), done = true;
    parts = shards;
    words[shard] = statusWords(*status);
    done = done && (*status)["state"].text() == "done";
  }
  if (parts < 0)
    return Error{Fault::FileMissing, {inFolder(folder, "shard-1-of-….status.json"), "", "", {}}, {}, "study"};
  SweepStatus status;
  if (parts == 0) status.words = "The sweep is " + words.begin()->second + ".\n";
  for (int shard = 1; shard <= parts; ++shard) {
    const auto found = words.find(shard);
    done = done && found != words.end();
    status.words +=
        text("shard %d of %d: ", shard, parts) + (found == words.end() ? "not begun" : found->second) + "\n";
  }
  status.done = done;
  return status;
}

}  // namespace glenoid
