// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/JointPack.h"

#include <cstdio>
#include <filesystem>

#include "app/Resources.h"
#include "app/commands/Console.h"
#include "simcore/scene/JointArchive.h"
#include "simcore/scene/ResourcePaths.h"
#include "simcore/starter/Starter.h"

namespace glenoid {
namespace {

/// Nothing is written over.
Result<Done> requireNew(const std::string& folder) {
  std::error_code failed;
  if (!std::filesystem::exists(folder, failed)) return Done{};
  if (std::filesystem::is_directory(folder, failed) && std::filesystem::is_empty(folder, failed)) return Done{};
  return usageError("“" + folder + "” is there already; name a new folder");
}

}  // namespace

std::string starterNames() {
  std::string names;
  for (const StarterKind& kind : starterKinds()) names += (names.empty() ? "" : ", ") + std::string(kind.name);
  return names;
}

Result<Done> newJoint(const std::string& folder, const std::string& kindName) {
  const StarterKind* const kind = findStarter(kindName);
  if (!kind) return usageError("--kind is one of " + starterNames() + ", not “" + kindName + "”");
  if (const auto free = requireNew(folder); !free) return free;
  const auto files = saveStarter(*kind, resourceRoot(), folder);
  if (!files) return files.error();
  std::printf("%s: recipe, scenario, meshes and README.md of the %s. Next:\n"
              "  glenoid joint build '%s' --out '%s'\n"
              "  glenoid joint check '%s'\n"
              "  glenoid run '%s' --seconds 5\n",
              folder.c_str(), kind->name, files->recipe.c_str(), files->joint.c_str(), files->scenario.c_str(), files->scenario.c_str());
  return Done{};
}

Result<Done> packJointFile(const std::string& word, const std::string& archive) {
  if (!isJointArchive(archive)) return usageError("a packed joint is called NAME.jointz, not “" + archive + "”");
  const Result<std::string> folder = resolveJoint(word, "", resourceRoot());
  if (!folder) return folder.error();
  std::filesystem::path path(*folder);
  if (path.filename() == "joint.json") path = path.has_parent_path() ? path.parent_path() : ".";
  if (const auto packed = packJoint(path.string(), archive); !packed) return packed;
  std::error_code failed;
  std::printf("%s: %ju bytes\n", archive.c_str(), static_cast<std::uintmax_t>(std::filesystem::file_size(archive, failed)));
  return Done{};
}

Result<Done> unpackJointFile(const std::string& archive, const std::string& folder) {
  if (const auto free = requireNew(folder); !free) return free;
  if (const auto unpacked = unpackJoint(archive, folder); !unpacked) return unpacked;
  std::printf("%s: unpacked\n", folder.c_str());
  return Done{};
}

}  // namespace glenoid
