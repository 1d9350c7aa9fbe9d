// SPDX-License-Identifier: GPL-3.0-or-later
// One joint in one file, by the commands.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Zip.h"
#include "simcore/scene/JointFile.h"
#include "tests/app/Program.h"
#include "tests/simcore/check/Faults.h"

namespace glenoid::testing {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

struct Packed {
  fs::path folder = freshFolder(), joint = folder / "test.joint", archive = folder / "test.jointz";
  Packed() {
    EXPECT_TRUE(saveJoint(soundJoint(), joint.string()).ok());
    const Outcome outcome = glenoidProgram("joint pack " + quoted(joint) + " " + quoted(archive));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
};

TEST(JointArchive, packedAndUnpackedItIsTheSame) {
  const Packed packed;
  const fs::path again = packed.folder / "again.joint", twice = packed.folder / "twice.jointz";
  const Outcome outcome = glenoidProgram("joint unpack " + quoted(packed.archive) + " " + quoted(again));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(readText(again / "joint.json"), readText(packed.joint / "joint.json"));
  int files = 0;
  for (const auto& mesh : fs::directory_iterator(again / "meshes")) {
    EXPECT_EQ(readText(mesh.path()), readText(packed.joint / "meshes" / mesh.path().filename()));
    ++files;
  }
  EXPECT_GE(files, 3);
  ASSERT_EQ(glenoidProgram("joint pack " + quoted(again) + " " + quoted(twice)).status, 0);
  EXPECT_EQ(readText(twice), readText(packed.archive)) << "the same joint gives the same bytes";
  for (const auto& entry : fs::directory_iterator(packed.folder))
    EXPECT_NE(entry.path().filename().string().substr(0, 9), ".glenoid-") << "something half-made was left";
}

TEST(JointArchive, everyCommandTakesItWhereItTakesAFolder) {
  const Packed packed;
  const std::string glb = quoted(packed.folder / "out.glb");
  for (const fs::path& word : {packed.archive, packed.joint / "joint.json"}) {
    for (const std::string command : {"joint check ", "joint info ", "joint info --json "}) {
      const Outcome folder = glenoidProgram(command + quoted(packed.joint)), outcome = glenoidProgram(command + quoted(word));
      EXPECT_EQ(outcome.status, 0) << command << word << outcome.err;
      EXPECT_EQ(outcome.out, folder.out) << command << word;
    }
    EXPECT_EQ(glenoidProgram("export " + quoted(word) + " --format glb --out " + glb).status, 0);
    EXPECT_EQ(glenoidProgram("render " + quoted(word) + " --size 64x64 --out " + quoted(packed.folder / "out.png")).status, 0);
    const Outcome run = glenoidProgram("run " + quoted(word) + " --steps 2");
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("is a joint, and a scenario is wanted"), std::string::npos) << run.err;
  }
  writeText(packed.folder / "a.scenario.json", R"({"schemaVersion": 2, "id": "a", "name": "A", "joint": "test.jointz"})");
  EXPECT_EQ(glenoidProgram("run " + quoted(packed.folder / "a.scenario.json") + " --steps 2").status, 0);
  const fs::path saved = packed.folder / "saved.jointz";
  ASSERT_TRUE(saveJoint(soundJoint(), saved.string()).ok());
  EXPECT_EQ(readText(saved), readText(packed.archive));
}

TEST(JointArchive, aFolderZippedByHandIsTaken) {
  const Packed packed;
  std::vector<ZipEntry> entries;
  ASSERT_TRUE(readZip(packed.archive.string(), [&](const std::string& name, std::string_view bytes) -> Result<Done> {
                entries.push_back({"my.joint/" + name, std::string(bytes)});
                return Done{};
              }).ok());
  const fs::path byHand = packed.folder / "by-hand.jointz";
  ASSERT_TRUE(writeZip(byHand.string(), entries).ok());
  EXPECT_EQ(glenoidProgram("joint check " + quoted(byHand)).status, 0);
  const fs::path out = packed.folder / "out.joint";
  EXPECT_EQ(glenoidProgram("joint unpack " + quoted(byHand) + " " + quoted(out)).status, 0);
  EXPECT_TRUE(fs::exists(out / "joint.json"));
}

// CMake packs and unpacks by libarchive, which shares nothing with the library that is used here.
TEST(JointArchive, anotherProgramUnpacksItAndPacksOneThatIsTaken) {
  const Packed packed;
  const auto cmake = [](const fs::path& in, const std::string& arguments) {
    return std::system(("cd " + quoted(in) + " && " + quoted(GLENOID_CMAKE) + " -E tar " + arguments).c_str());
  };
  const fs::path theirs = packed.folder / "theirs";
  fs::create_directories(theirs);
  ASSERT_EQ(cmake(theirs, "xf " + quoted(packed.archive)), 0);
  EXPECT_EQ(readText(theirs / "joint.json"), readText(packed.joint / "joint.json"));
  for (const auto& mesh : fs::directory_iterator(packed.joint / "meshes"))
    EXPECT_EQ(readText(theirs / "meshes" / mesh.path().filename()), readText(mesh.path())) << mesh.path();
  const fs::path archive = packed.folder / "theirs.jointz";
  ASSERT_EQ(cmake(theirs, "cf " + quoted(archive) + " --format=zip joint.json meshes"), 0);
  const auto joint = loadJoint(archive.string()), original = loadJoint(packed.joint.string());
  ASSERT_TRUE(joint.ok() && original.ok());
  EXPECT_EQ(jointHash(*joint), jointHash(*original));
}

TEST(JointArchive, badOnesAreRefusedInASentenceAndLeaveNothing) {
  const Packed packed;
  const auto refused = [&](const fs::path& archive, const std::string& why) {
    const fs::path out = packed.folder / "never.joint";
    for (const std::string& command : {"joint unpack " + quoted(archive) + " " + quoted(out), "joint check " + quoted(archive)}) {
      const Outcome outcome = glenoidProgram(command);
      EXPECT_EQ(outcome.status, 2) << command;
      EXPECT_EQ(lineCount(outcome.err), 1) << outcome.err;
      EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
      EXPECT_NE(outcome.err.find(archive.filename().string()), std::string::npos) << outcome.err;
      EXPECT_FALSE(fs::exists(out));
    }
  };
  const fs::path bad = packed.folder / "bad.jointz";
  ASSERT_TRUE(writeZip(bad.string(), {{"joint.json", "{}"}, {"../../evil.ply", "ply"}}).ok());
  refused(bad, "leaves its folder");
  EXPECT_FALSE(fs::exists(packed.folder.parent_path() / "evil.ply"));
  ASSERT_TRUE(writeZip(bad.string(), {{"joint.json", "{}"}}).ok());
  refused(bad, "expected form");
  ASSERT_TRUE(writeZip(bad.string(), {{"readme.txt", "no joint"}}).ok());
  refused(bad, "no such file");
  writeText(bad, "no archive");
  refused(bad, "format of the file is not known");
  const std::string whole = readText(packed.archive);
  writeText(bad, whole.substr(0, whole.size() / 2));
  refused(bad, ".");
  // The method of the first entry, in its own header and in the archive's list: LZMA.
  std::string otherwise = whole;
  const std::size_t listed = otherwise.find("PK\1\2");
  ASSERT_NE(listed, std::string::npos);
  otherwise[8] = otherwise[listed + 10] = 14;
  writeText(bad, otherwise);
  refused(bad, "pack it by deflate");
}

TEST(JointArchive, nothingIsWrittenOver) {
  const Packed packed;
  writeText(packed.folder / "precious" , "mine");
  fs::create_directories(packed.folder / "full");
  writeText(packed.folder / "full" / "mine.txt", "mine");
  for (const char* target : {"precious", "full"})
    EXPECT_EQ(glenoidProgram("joint unpack " + quoted(packed.archive) + " " + quoted(packed.folder / target)).status, 2) << target;
  EXPECT_EQ(readText(packed.folder / "precious"), "mine");
  EXPECT_EQ(readText(packed.folder / "full" / "mine.txt"), "mine");
  EXPECT_EQ(glenoidProgram("joint pack " + quoted(packed.joint) + " " + quoted(packed.folder / "wrong.zip")).status, 2);
  EXPECT_FALSE(fs::exists(packed.folder / "wrong.zip"));
}

}  // namespace
}  // namespace glenoid::testing
