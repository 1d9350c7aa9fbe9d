// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Resources.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "simcore/scene/JointArchive.h"
#include "simcore/scene/ResourcePaths.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;

std::string findRoot() {
  if (const char* named = std::getenv("GLENOID_RESOURCES"); named && *named) return named;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  if (!program.empty()) {
    const fs::path installed = program.parent_path().parent_path() / "share" / "glenoid";
    if (fs::is_directory(installed / "scenarios", ignored)) return installed.string();
  }
  return GLENOID_SOURCE_RESOURCES;
}

}  // namespace

const std::string& resourceRoot() {
  static const std::string root = findRoot();
  return root;
}

bool namesJoint(const std::string& word) {
  if (word.rfind("builtin:", 0) == 0) return resolveJoint(word, "", resourceRoot()).ok();
  std::error_code ignored;
  fs::path path(word);
  if (path.filename().empty()) path = path.parent_path();  // "x.joint/"
  return path.extension() == ".joint" || path.filename() == "joint.json" || isJointArchive(word) || fs::is_directory(path, ignored);
}

}  // namespace glenoid
