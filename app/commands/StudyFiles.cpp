// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/StudyFiles.h"

#include <charconv>
#include <cmath>
#include <filesystem>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/JsonObject.h"
#include "simcore/live/BuildId.h"
#include "simcore/step/Stepper.h"
#include "simcore/study/Machine.h"

namespace glenoid {
namespace {

std::string csvText(const std::string& words) {
  if (words.find_first_of(",\"\r\n") == std::string::npos) return words;
  std::string quoted = "\"";
  for (const char c : words) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csvCell(const StudyCell& cell) {
  if (const auto* yes = std::get_if<bool>(&cell)) return *yes ? "yes" : "no";
  if (const auto* count = std::get_if<long>(&cell)) return std::to_string(*count);
  if (const auto* words = std::get_if<std::string>(&cell)) return csvText(*words);
  const auto* number = std::get_if<double>(&cell);
  if (!number || !std::isfinite(*number)) return {};
  char digits[32];
  return std::string(digits, std::to_chars(digits, digits + sizeof digits, *number).ptr);
}

}  // namespace

std::string tableCsv(const StudyTable& table) {
  std::string out;
  for (std::size_t c = 0; c < table.columns.size(); ++c) out += (c ? "," : "") + csvText(table.columns[c]);
  out += "\r\n";
  for (const auto& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) out += (c ? "," : "") + csvCell(row[c]);
    out += "\r\n";
  }
  return out;
}

JsonValue machineJson() {
  return jsonObject({{"build", buildId()}, {"isa", kernelIsa(false)}, {"processor", processorName()}, {"threads", 1}});
}

std::string machineWords() {
  return processorName() + ", build " + buildId() + ", kernels " + kernelIsa(false) + ", one thread";
}

std::string inFolder(const std::string& folder, const std::string& leaf) { return (std::filesystem::path(folder) / leaf).string(); }

Result<Done> prepareFolder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directory(folder, failed);  // its parent must be there
  return checkWritable((std::filesystem::path(folder) / "settings.csv").string());
}

std::string movedReference(const std::string& reference, const std::string& fromFolder, const std::string& toFolder) {
  namespace fs = std::filesystem;
  if (reference.empty() || reference.rfind("builtin:", 0) == 0 || fs::path(reference).is_absolute()) return reference;
  const fs::path target = fs::absolute(fs::path(fromFolder) / reference).lexically_normal();
  return target.lexically_relative(fs::absolute(toFolder).lexically_normal()).generic_string();
}

}  // namespace glenoid
