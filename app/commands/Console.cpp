// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Console.h"

#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <vector>

#include "editor/core/Sentences.h"

namespace glenoid {

int complain(const Error& error) {
  QString sentence = sentenceOf(error);
  if (error.fault == Fault::Internal) sentence += QStringLiteral(" [%1]").arg(QString::fromStdString(error.detail));
  sentence.replace(QLatin1Char('\n'), QLatin1Char(' '));
  std::fflush(stdout);  // what was found out comes before what is wrong with it
  std::fprintf(stderr, "%s\n", sentence.toUtf8().constData());
  return error.fault == Fault::CheckFailed ? kCheckFailed : kBadInput;
}

Error usageError(const std::string& what) { return {Fault::BadUsage, {}, {what}, "command line"}; }

ProgressLine::ProgressLine(std::string what) : m_what(std::move(what)), m_terminal(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (m_shown) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double fraction) {
  if (!m_terminal) return;
  const auto now = Clock::now();
  using namespace std::chrono_literals;
  if (now - m_start < 2s || now - m_last < 200ms) return;
  m_last = now;
  m_shown = true;
  std::fprintf(stderr, "\r%s %3.0f %%", m_what.c_str(), 100 * fraction);
  std::fflush(stderr);
}

std::string text(const char* format, ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int size = std::vsnprintf(nullptr, 0, format, arguments);
  std::vector<char> buffer(static_cast<std::size_t>(size) + 1);
  std::vsnprintf(buffer.data(), buffer.size(), format, again);
  va_end(arguments);
  va_end(again);
  return std::string(buffer.data(), static_cast<std::size_t>(size));
}

}  // namespace glenoid
