// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/JointArchive.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Json.h"
#include "simcore/file/Zip.h"
#include "simcore/scene/JointFile.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;

Error unwritable(const std::string& path, const std::string& why) { return {Fault::FileUnwritable, {path, {}, {}, {}}, {}, why}; }

/// A new folder that goes with everything in it.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const fs::path& parent) {
    std::string name = (parent / ".glenoid-XXXXXX").string();
    if (mkdtemp(name.data())) m_path = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!m_path.empty()) fs::remove_all(m_path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  explicit operator bool() const { return !m_path.empty(); }
  const fs::path& path() const { return m_path; }

 private:
  fs::path m_path;
};

fs::path temporaryRoot() {
  std::error_code failed;
  const fs::path root = fs::temp_directory_path(failed);
  return failed ? fs::path("/tmp") : root;
}

/// Every file of the archive below `folder`.
Result<Done> unpackInto(const std::string& archive, const fs::path& folder) {
  return readZip(archive, [&](const std::string& name, std::string_view bytes) -> Result<Done> {
    const fs::path target = folder / name;
    std::error_code failed;
    fs::create_directories(target.parent_path(), failed);
    if (failed) return unwritable(archive, failed.message());  // one entry is a folder of another
    return writeWholeFile(target.string(), bytes);
  });
}

/// Where joint.json lies: there, or in the only folder there is.
fs::path jointIn(const fs::path& folder) {
  std::error_code failed;
  if (fs::exists(folder / "joint.json", failed)) return folder;
  std::vector<fs::path> found;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) found.push_back(it->path());
  return found.size() == 1 && fs::is_directory(found[0], failed) ? found[0] : folder;
}

/// An error about a file below `folder` as one about the archive.
Error ofArchive(Error error, const fs::path& folder, const std::string& archive) {
  const std::string inside = folder.string();
  if (error.place.file.rfind(inside, 0) == 0) error.place.file = archive + error.place.file.substr(inside.size());
  return error;
}

}  // namespace

bool isJointArchive(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".jointz";
}

Result<Done> packJoint(const std::string& folder, const std::string& archive) {
  if (const auto joint = loadJoint(folder); !joint) return joint.error();  // what is given away is sound
  const auto text = readWholeFile((fs::path(folder) / "joint.json").string());
  if (!text) return text.error();
  std::vector<ZipEntry> entries{{"joint.json", *text}};
  const auto json = parseJson(*text, folder);
  if (!json) return json.error();
  std::set<std::string> meshes;  // once each, in an order of its own
  for (const JsonValue& part : (*json)["parts"].items())
    for (const char* member : {"visual", "collision", "volume"})
      if (part.find(member)) meshes.insert(part[member].text());
  for (const std::string& name : meshes) {
    auto bytes = readWholeFile((fs::path(folder) / name).string());
    if (!bytes) return bytes.error();
    entries.push_back({name, std::move(*bytes)});
  }
  return writeZip(archive, entries);
}

Result<Done> unpackJoint(const std::string& archive, const std::string& folder) {
  fs::path target = folder;
  if (target.filename().empty()) target = target.parent_path();  // "x.joint/"
  std::error_code failed;
  if (fs::exists(target, failed) && (!fs::is_directory(target, failed) || !fs::is_empty(target, failed)))
    return unwritable(folder, "something is there already");
  const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(parent, failed)) return Error{Fault::FileMissing, {parent.string(), {}, {}, {}}, {}, "no such folder"};
  const TemporaryFolder whole(parent);
  if (!whole) return unwritable(folder, "no folder can be made beside it");
  if (const auto unpacked = unpackInto(archive, whole.path()); !unpacked) return unpacked;
  const fs::path joint = jointIn(whole.path());
  if (const auto good = loadJoint(joint.string()); !good) return ofArchive(good.error(), joint, archive);
  fs::permissions(joint, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read | fs::perms::others_exec, failed);
  fs::rename(joint, target, failed);
  if (failed) return unwritable(folder, failed.message());
  return Done{};
}

Result<Joint> loadJointArchive(const std::string& archive) {
  const TemporaryFolder whole(temporaryRoot());
  if (!whole) return unwritable(temporaryRoot().string(), "no temporary folder can be made");
  if (const auto unpacked = unpackInto(archive, whole.path()); !unpacked) return unpacked.error();
  const fs::path folder = jointIn(whole.path());
  auto joint = loadJoint(folder.string());
  if (!joint) return ofArchive(joint.error(), folder, archive);
  return joint;
}

Result<Done> saveJointArchive(const Joint& joint, const std::string& archive) {
  const TemporaryFolder whole(temporaryRoot());
  if (!whole) return unwritable(temporaryRoot().string(), "no temporary folder can be made");
  const fs::path folder = whole.path() / "a.joint";
  if (const auto saved = saveJoint(joint, folder.string()); !saved) return ofArchive(saved.error(), folder, archive);
  return packJoint(folder.string(), archive);
}

}  // namespace glenoid
