// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "simcore/file/AtomicWrite.h"
#include "tests/simcore/file/TemporaryFolder.h"

namespace glenoid {
namespace {

/// No file may grow beyond `bytes` while this lives: a disk that is full, for root too.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    m_before = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &m_limit);
    const rlimit small{bytes, m_limit.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &m_limit);
    std::signal(SIGXFSZ, m_before);
  }

 private:
  rlimit m_limit{};
  void (*m_before)(int) = nullptr;
};

TEST(AtomicWrite, whatIsWrittenComesBack) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n\xff", 5);
  ASSERT_TRUE(writeWholeFile(folder.path("x"), bytes).ok());
  const auto back = readWholeFile(folder.path("x"));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(*back, bytes);
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(AtomicWrite, aFailedWriteKeepsTheOldFileAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const std::string path = folder.put("x", "old");
  const auto written = [&] {
    const FullDisk full(1000);
    return writeWholeFile(path, std::string(100000, 'n'));
  }();
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().fault, Fault::FileUnwritable);
  EXPECT_EQ(written.error().place.file, path);
  EXPECT_EQ(folder.get("x"), "old");
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(AtomicWrite, permissionsAndLinksStay) {
  const TemporaryFolder folder;
  const std::string path = folder.put("x", "old"), link = folder.path("link");
  ::chmod(path.c_str(), 0640);
  std::filesystem::create_symlink("x", link);
  ASSERT_TRUE(writeWholeFile(link, "new").ok());
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(folder.get("x"), "new");
  struct stat info {};
  ::stat(path.c_str(), &info);
  EXPECT_EQ(info.st_mode & 0777, 0640u);
}

TEST(AtomicWrite, writingSaysWhy) {
  const TemporaryFolder folder;
  const auto missing = writeWholeFile(folder.path("nowhere/x"), "a");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().fault, Fault::FileMissing);
  const auto aFolder = writeWholeFile(folder.path(), "a");
  ASSERT_FALSE(aFolder.ok());
  EXPECT_EQ(aFolder.error().fault, Fault::FileUnwritable);
}

TEST(AtomicWrite, whetherItWouldGoIsSaidBeforehandAndLeavesNothing) {
  const TemporaryFolder folder;
  EXPECT_TRUE(checkWritable(folder.path("new")).ok());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  folder.put("old", "kept");
  EXPECT_TRUE(checkWritable(folder.path("old")).ok());
  EXPECT_EQ(folder.get("old"), "kept");
  const auto missing = checkWritable(folder.path("nowhere/x")), aFolder = checkWritable(folder.path());
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().fault, Fault::FileMissing);
  ASSERT_FALSE(aFolder.ok());
  EXPECT_EQ(aFolder.error().fault, Fault::FileUnwritable);
}

TEST(AtomicWrite, readingSaysWhy) {
  const TemporaryFolder folder;
  const auto faultOf = [](const Result<std::string>& result) {
    EXPECT_FALSE(result.ok());
    return result.ok() ? Fault::Internal : result.error().fault;
  };
  EXPECT_EQ(faultOf(readWholeFile(folder.path("none"))), Fault::FileMissing);
  EXPECT_EQ(faultOf(readWholeFile(folder.put("file", "1") + "/below")), Fault::FileMissing);
  EXPECT_EQ(faultOf(readWholeFile(folder.path())), Fault::FileUnreadable);
  EXPECT_EQ(faultOf(readWholeFile(folder.put("empty", ""))), Fault::FileEmpty);
  const auto large = readWholeFile(folder.put("large", "12345"), 4);
  EXPECT_EQ(faultOf(large), Fault::FileTooLarge);
  EXPECT_EQ(large.error().arguments, (Arguments{"5 bytes", "4 bytes"}));
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(faultOf(readWholeFile(folder.path("pipe"))),
            Fault::FileUnreadable);  // and does not wait for a writer
}

}  // namespace
}  // namespace glenoid
