// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/ResourcePaths.h"

#include <algorithm>
#include <filesystem>

namespace glenoid {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBuiltin = "builtin:";

struct ResourceKind {
  const char* folder;
  std::string_view ending;
  const char* name;
};

/// Every name of this kind that ships, sorted.
std::vector<std::string> namesBelow(const std::string& root, const ResourceKind& kind) {
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator it(fs::path(root) / kind.folder, failed), end; !failed && it != end;
       it.increment(failed)) {
    const std::string leaf = it->path().filename().string();
    if (leaf.size() > kind.ending.size() && leaf.ends_with(kind.ending))
      names.push_back(leaf.substr(0, leaf.size() - kind.ending.size()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

Result<std::string> resolve(const std::string& reference, const std::string& baseFolder,
                            const std::string& root, const ResourceKind& kind) {
  if (reference.empty()) return Error{Fault::BadReference, {}, {reference}, "empty reference"};
  if (reference.rfind(kBuiltin, 0) != 0) {
    const fs::path path(reference);
    return path.is_absolute() || baseFolder.empty()
               ? reference
               : (fs::path(baseFolder) / path).lexically_normal().string();
  }
  // Only a name from the list is taken, so that no reference leaves the folder.
  const std::string name = reference.substr(kBuiltin.size());
  const std::vector<std::string> names = namesBelow(root, kind);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    Error error{
        Fault::UnknownId, {(fs::path(root) / kind.folder).string(), {}, {}, {}}, {name, kind.name}, {}};
    error.arguments.insert(error.arguments.end(), names.begin(), names.end());
    return error;
  }
  return (fs::path(root) / kind.folder / (name + std::string(kind.ending))).string();
}

}  // namespace

Result<std::string> resolveJoint(const std::string& reference, const std::string& baseFolder,
                                 const std::string& resourcesRoot) {
  return resolve(reference, baseFolder, resourcesRoot, {"joints", ".joint", "joint"});
}

Result<std::string> resolveScenario(const std::string& reference, const std::string& baseFolder,
                                    const std::string& resourcesRoot) {
  return resolve(reference, baseFolder, resourcesRoot, {"scenarios", ".scenario.json", "scenario"});
}

Result<std::string> resolveRecording(const std::string& reference, const std::string& baseFolder,
                                     const std::string& resourcesRoot) {
  return resolve(reference, baseFolder, resourcesRoot, {"recordings", ".recording", "recording"});
}

std::string folderOf(const std::string& path) {
  return fs::path(path).parent_path().string();
}

}  // namespace glenoid
