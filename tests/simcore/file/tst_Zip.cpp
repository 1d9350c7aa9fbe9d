// SPDX-License-Identifier: GPL-3.0-or-later
// Archives that others might write, honest and not; none of them harms anything even where it is read.
#include "simcore/file/Zip.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <zip.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "simcore/file/AtomicWrite.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;

struct Content {
  Result<Done> done = Done{};
  std::map<std::string, std::string> files;
};

Content contentOf(const std::string& path, const ZipLimits& limits = {}) {
  Content content;
  content.done = readZip(path, [&](const std::string& name, std::string_view bytes) -> Result<Done> {
    content.files[name] = bytes;
    return Done{};
  }, limits);
  return content;
}

class Zip : public ::testing::Test {
 protected:
  void SetUp() override {
    m_folder = fs::path(GLENOID_BUILD_DIR) / "Testing" / "zip" / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);
  }
  std::string path(const std::string& name) const { return (m_folder / name).string(); }
  std::string written(const std::vector<ZipEntry>& entries) const {
    const auto done = writeZip(path("a.zip"), entries);
    EXPECT_TRUE(done.ok()) << toLogLine(done.error());
    return path("a.zip");
  }
  fs::path m_folder;
};

TEST_F(Zip, whatGoesInComesOut) {
  const std::vector<ZipEntry> entries{{"joint.json", "{}"}, {"meshes/a.ply", std::string(100000, 'x')}, {"meshes/schön.ply", std::string("\0\1\2", 3)}, {"empty", ""}};
  const Content content = contentOf(written(entries));
  ASSERT_TRUE(content.done.ok()) << toLogLine(content.done.error());
  EXPECT_EQ(content.files.size(), entries.size());
  for (const ZipEntry& entry : entries) EXPECT_EQ(content.files.at(entry.name), entry.bytes) << entry.name;
  EXPECT_LT(fs::file_size(path("a.zip")), 2000u) << "it is packed";
}

TEST_F(Zip, theSameEntriesGiveTheSameBytesInAnyTimeZone) {
  const std::vector<ZipEntry> entries{{"a", "1"}, {"b", "2"}};
  setenv("TZ", "UTC", 1);
  const auto first = readWholeFile(written(entries));
  setenv("TZ", "Pacific/Auckland", 1);
  const auto again = readWholeFile(written(entries));
  unsetenv("TZ");
  ASSERT_TRUE(first.ok() && again.ok());
  EXPECT_EQ(*first, *again);
}

TEST_F(Zip, namesThatLeaveTheirFolderAreRefusedBeforeAnythingIsTaken) {
  for (const char* name : {"../evil", "a/../../evil", "/etc/evil", "a//b", "./a", "..", "a\\..\\evil", "C:/evil", "a\nb"}) {
    const Content content = contentOf(written({{"good", "1"}, {name, "2"}}));
    ASSERT_FALSE(content.done.ok()) << name;
    EXPECT_EQ(content.done.error().fault, Fault::SchemaMismatch) << name;
    EXPECT_TRUE(content.files.empty()) << name << ": all names are looked at first";
    EXPECT_EQ(content.done.error().arguments.at(0).find('\n'), std::string::npos);
  }
  EXPECT_FALSE(isSafeEntryName(""));
  EXPECT_FALSE(isSafeEntryName(std::string(2000, 'a')));
  EXPECT_FALSE(isSafeEntryName("\xff"));
  EXPECT_TRUE(isSafeEntryName("..a/b..c/.d"));
}

/// An archive made by libzip itself, with what writeZip never writes.
template <class Change>
std::string archiveWith(const std::string& path, Change&& change) {
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  const auto index = zip_file_add(archive, "entry", zip_source_buffer(archive, "target", 6, 0), 0);
  change(archive, static_cast<zip_uint64_t>(index));
  EXPECT_EQ(zip_close(archive), 0);
  return path;
}

TEST_F(Zip, linksAndDevicesAndSecretsAreRefused) {
  for (const zip_uint32_t type : {S_IFLNK, S_IFCHR, S_IFIFO}) {
    const Content content = contentOf(archiveWith(path("l.zip"), [&](zip_t* archive, zip_uint64_t index) {
      zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX, (type | 0777) << 16);
    }));
    ASSERT_FALSE(content.done.ok());
    EXPECT_NE(content.done.error().arguments.at(0).find("link"), std::string::npos);
  }
  const Content secret = contentOf(archiveWith(path("s.zip"), [](zip_t* archive, zip_uint64_t index) {
    zip_file_set_encryption(archive, index, ZIP_EM_AES_256, "word");
  }));
  ASSERT_FALSE(secret.done.ok());
  EXPECT_NE(secret.done.error().arguments.at(0).find("encrypted"), std::string::npos);
  EXPECT_TRUE(contentOf(archiveWith(path("f.zip"), [](zip_t* archive, zip_uint64_t index) {
                zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX, (S_IFREG | 0644u) << 16);
                zip_dir_add(archive, "folder", 0);
              })).done.ok());
}

TEST_F(Zip, limitsHoldByWhatIsDeclared) {
  const std::string many = written({{"a", "1234"}, {"b", "1234"}, {"c", "1234"}});
  EXPECT_TRUE(contentOf(many, {3, 4, 12}).done.ok());
  EXPECT_EQ(contentOf(many, {2, 4, 12}).done.error().fault, Fault::FileTooLarge);
  EXPECT_EQ(contentOf(many, {3, 3, 12}).done.error().fault, Fault::FileTooLarge);
  EXPECT_EQ(contentOf(many, {3, 4, 11}).done.error().fault, Fault::FileTooLarge);
}

TEST_F(Zip, andByWhatIsThere) {
  // A megabyte of one letter packs to a kilobyte; the headers are made to say 16 bytes.
  const std::string path = written({{"bomb", std::string(1 << 20, 'b')}});
  std::string bytes = *readWholeFile(path);
  const std::string size("\0\0\x10\0", 4), less("\x10\0\0\0", 4);
  int changed = 0;
  for (std::size_t at = bytes.find(size); at != std::string::npos; at = bytes.find(size, at + 4), ++changed) bytes.replace(at, 4, less);
  ASSERT_EQ(changed, 2) << "the local header and the directory";
  ASSERT_TRUE(writeWholeFile(path, bytes).ok());
  const Content content = contentOf(path);
  ASSERT_FALSE(content.done.ok());
  EXPECT_TRUE(content.files.empty());
}

TEST_F(Zip, everyCutAndEveryFlippedByteIsAnErrorOrTheSameContent) {
  const std::string path = written({{"joint.json", "{\"id\": 1}"}, {"meshes/a.ply", "ply and so on"}});
  const std::string bytes = *readWholeFile(path);
  const auto whole = contentOf(path).files;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    std::ofstream(path, std::ios::binary) << bytes.substr(0, size);
    EXPECT_FALSE(contentOf(path).done.ok()) << size;
  }
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x55);
    std::ofstream(path, std::ios::binary) << flipped;
    const Content content = contentOf(path);
    if (!content.done.ok()) continue;
    for (const auto& [name, text] : content.files) {  // names have no checksum, contents do
      bool same = false;
      for (const auto& [ignored, right] : whole) same |= right == text;
      EXPECT_TRUE(same) << at;
    }
  }
}

TEST_F(Zip, whatIsNoArchiveIsNone) {
  ASSERT_TRUE(writeWholeFile(path("text"), "no archive at all, but long enough to be looked at").ok());
  EXPECT_EQ(contentOf(path("text")).done.error().fault, Fault::UnknownFormat);
  EXPECT_EQ(contentOf(path("missing")).done.error().fault, Fault::FileMissing);
  EXPECT_EQ(contentOf(m_folder.string()).done.error().fault, Fault::FileUnreadable);
  EXPECT_EQ(writeZip(path("no/such/folder.zip"), {{"a", "1"}}).error().fault, Fault::FileMissing);
}

}  // namespace
}  // namespace glenoid
