// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/Machine.h"

#include <cstdlib>
#include <fstream>

namespace glenoid {
namespace {

/// What stands behind "KEY   :" in a file of /proc; empty when there is no such line.
std::string valueOf(const char* file, const std::string& key) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    if (line.compare(0, key.size(), key) != 0) continue;
    const auto colon = line.find(':');
    if (colon == std::string::npos) continue;
    const auto first = line.find_first_not_of(" \t", colon + 1);
    return first == std::string::npos ? std::string() : line.substr(first);
  }
  return {};
}

/// The kernel writes "12345 kB".
double mebibytes(const char* key) { return std::atof(valueOf("/proc/self/status", key).c_str()) / 1024; }

}  // namespace

std::string processorName() {
  const std::string name = valueOf("/proc/cpuinfo", "model name");
  return name.empty() ? "unknown" : name;
}

double residentMiB() { return mebibytes("VmRSS"); }
double residentPeakMiB() { return mebibytes("VmHWM"); }

}  // namespace glenoid
