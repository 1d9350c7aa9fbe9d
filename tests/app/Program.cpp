// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/Program.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace glenoid::testing {

namespace fs = std::filesystem;

Outcome glenoidProgram(const std::string& arguments) {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const fs::path base = fs::path(GLENOID_BUILD_DIR) / "Testing" / "cli";
  fs::create_directories(base);
  const std::string name = (base / (std::string(info->test_suite_name()) + "." + info->name())).string();
  std::string safe = name;
  std::replace(safe.begin() + static_cast<long>(base.string().size()) + 1, safe.end(), '/', '-');
  const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM LC_ALL=C.UTF-8 '" GLENOID_PROGRAM "' " + arguments +
                              " >'" + safe + ".out' 2>'" + safe + ".err' </dev/null";
  const int raw = std::system(command.c_str());
  return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, readText(safe + ".out"), readText(safe + ".err")};
}

int lineCount(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n')) + (!text.empty() && text.back() != '\n');
}

std::string readText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void writeText(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

fs::path freshFolder() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  std::replace(name.begin(), name.end(), '/', '-');
  const fs::path folder = fs::path(GLENOID_BUILD_DIR) / "Testing" / "cli" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

}  // namespace glenoid::testing
