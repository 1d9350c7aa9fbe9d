// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>
#include <string>

#include "simcore/base/Error.h"

namespace glenoid {

/// Exit statuses of the command line (design: §6).
enum ExitStatus { kDone = 0, kCheckFailed = 1, kBadInput = 2 };

/// Prints the error's sentence as one line on stderr; answers the status that fits it.
int complain(const Error& error);

/// For an answer of the user's own command: BadUsage with what is wrong.
Error usageError(const std::string& what);

/// Says on a terminal how far a long piece of work is; silent in the first two seconds and where stderr is a file.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();  ///< wipes the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  std::string m_what;
  Clock::time_point m_start = Clock::now(), m_last = m_start;
  bool m_terminal, m_shown = false;
};

/// Printf into a string.
[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);

}  // namespace glenoid
