// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

#include "simcore/base/Error.h"
#include "simcore/file/JsonValue.h"

namespace glenoid {

/// What one part of a sweep leaves in its folder, so that a scheduler need not be believed (a job that was
/// killed may show exit value 0):
///   shard-3-of-16.json          what was measured, whole or not at all
///   shard-3-of-16.partial.json  what is there of one that goes on, written anew after every setting; gone
///   when it is done shard-3-of-16.status.json   running, done or failed, on which machine, how far, and the
///   sentence of a failure
/// A sweep in one part has accuracy.partial.json and accuracy.status.json.
/// Each says of what it is (`of`): scene, hands, options, build, instruction set. What is of something else
/// is refused, never mixed in.
class SweepFiles {
 public:
  /// `of`: an object of texts and numbers. shards 0: the sweep is in one part.
  SweepFiles(std::string folder, int shard, int shards, JsonValue of);

  const std::string& shardPath() const { return m_shard; }

  /// Whether this part is done. Fails with Unusable where what is there is of something else, and as reading
  /// does.
  Result<bool> isDone() const;
  /// What a part that was stopped has left. Fails likewise.
  Result<std::optional<JsonValue>> left() const;

  /// Says that it runs, so many settings of so many finished, and keeps what there is.
  Result<Done> keep(JsonValue soFar, long finished, long settings);
  /// Says that it runs, before anything is there.
  Result<Done> begin(long settings);
  /// Writes the part, where it is one of several, and says that it is done.
  Result<Done> finish(JsonValue whole);
  /// Says that it failed, and why.
  void fail(const std::string& sentence);

 private:
  Result<Done> say(const char* state, const std::string& error = {}) const;
  Result<JsonValue> readOwn(const std::string& path) const;

  std::string m_shard, m_partial, m_status, m_began;
  JsonValue m_of;
  int m_number, m_count;
  long m_finished = 0, m_settings = 0;
};

/// A line for each part of the sweep in a folder: done, running, failed, ended without a word, or not begun.
/// `done`: whether all are. Fails with FileMissing where there is none at all.
struct SweepStatus {
  std::string words;
  bool done = false;
};
Result<SweepStatus> sweepStatus(const std::string& folder);

}  // namespace glenoid
