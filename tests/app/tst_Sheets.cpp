// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of the README, smaller: each by the command that stands there, beside what is stored in tests/render.
#include "tests/app/Program.h"
#include "tests/editor/render/PictureCheck.h"

namespace glenoid {
namespace {

Image pictureOf(const std::string& arguments) {
  const std::filesystem::path file = testing::freshFolder() / "picture.png";
  const testing::Outcome outcome = testing::glenoidProgram("render " + arguments + " --out " + file.string());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto image = readPng(file.string());
  EXPECT_TRUE(image.ok()) << arguments;
  return image.ok() ? *image : Image{};
}

TEST(Sheets, anatomyFromTheBonesOutwards) {
  const Image sheet = pictureOf("builtin:palpation --sheet anatomy --layers visual,labels --size 1200x260");
  EXPECT_EQ(sheet.width, 1200);
  test::expectPicture(sheet, "sheet-anatomy");
}

TEST(Sheets, theThreeMeshesOfALigament) {
  test::expectPicture(pictureOf("builtin:shoulder --part 6 --sheet meshes --camera superior --size 600x200"), "sheet-meshes");
}

TEST(Sheets, aCageFreesACuffThatLiesTooLow) {
  const std::string joint = (testing::freshFolder() / "low.joint").string();
  const testing::Outcome built = testing::glenoidProgram("joint build " GLENOID_SOURCE_DIR "/tests/recipes/low-tendon.json --meshes " GLENOID_SOURCE_DIR
                                                         "/resources/joints/shoulder.joint --out " + joint);
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_NE(built.out.find("start: 2 pairs of parts compared exactly: 0 intersecting triangle pairs, 0 of the visual surfaces"), std::string::npos)
      << built.out;
  const std::filesystem::path file = std::filesystem::path(joint).parent_path() / "cage.png";
  const testing::Outcome drawn =
      testing::glenoidProgram("render " + joint + " --sheet cage --part supraspinatus --camera anterior --size 720x224 --out " + file.string());
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  test::expectPicture(*readPng(file.string()), "sheet-cage");
}

TEST(Sheets, bothApplications) {
  test::expectPicture(pictureOf("builtin:arthroscopy --time 6.9 --camera anterior --size 320x200"), "application-arthroscopy");
  test::expectPicture(pictureOf("builtin:palpation --time 2.4 --camera lateral --size 225x175"), "application-palpation");
}

TEST(Sheets, coloursOfWhatPartsBear) {
  test::expectPicture(pictureOf("builtin:arthroscopy --time 2 --camera anterior --colour stress --size 480x320"), "colours-stress");
  test::expectPicture(pictureOf("builtin:arthroscopy --time 2 --camera anterior --colour pressure --colour-range -50kPa:0.1MPa --size 480x320"),
                      "colours-pressure");
}

TEST(Sheets, aRunColoursItsLastPicture) {
  const std::filesystem::path folder = testing::freshFolder();
  const auto run = [&](const std::string& more, const char* name) {
    const std::string file = (folder / name).string();
    const testing::Outcome outcome = testing::glenoidProgram("run builtin:arthroscopy --steps 20 --render " + file + more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return readPng(file).value();
  };
  EXPECT_FALSE(test::alike(compareImages(run("", "plain.png"), run(" --colour contact", "contact.png"))));
}

TEST(Sheets, aRangeMayHaveUnitsAndIsWhatWasAskedFor) {
  const auto with = [](const char* range) {
    return pictureOf(std::string("builtin:arthroscopy --time 0.1 --camera anterior --size 200x150 --colour strain --colour-range ") + range);
  };
  const Image percent = with("0:2%");
  EXPECT_TRUE(test::alike(compareImages(percent, with("0:0.02"))));
  EXPECT_FALSE(test::alike(compareImages(percent, with("0:0.2"))));
}

TEST(Sheets, coloursThatCannotBeAreSaidInOneSentence) {
  const std::string file = (testing::freshFolder() / "x.png").string();
  for (const std::string& words :
       {"render builtin:arthroscopy --colour beauty --out " + file, "render builtin:arthroscopy --colour-range 0:1 --out " + file,
        "render builtin:arthroscopy --colour stress --colour-range 5 --out " + file, "render builtin:arthroscopy --colour stress --colour-range 5:1 --out " + file,
        "render builtin:arthroscopy --colour stress --colour-range 0:20% --out " + file, "render builtin:arthroscopy --colour strain --colour-range 0:1kPa --out " + file,
        "render builtin:arthroscopy --colour stress --colour-range 0:nan --out " + file, "render builtin:arthroscopy --colour contact --out " + file,
        // Hours of simulation would not end within the time of a test: it is said before.
        std::string("run builtin:arthroscopy --steps 5000000 --colour stress"), "run builtin:arthroscopy --steps 5000000 --colour beauty --render " + file}) {
    const testing::Outcome outcome = testing::glenoidProgram(words);
    EXPECT_EQ(outcome.status, 2) << words;
    EXPECT_EQ(testing::lineCount(outcome.err), 1) << words << outcome.err;
    EXPECT_NE(outcome.err.find("--colour"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(file)) << words;
  }
}

TEST(Sheets, withoutSkinThereIsOnePanelLess) {
  // Three panels of 100 pixels: bones, ligaments, muscles.
  EXPECT_EQ(pictureOf("builtin:shoulder --sheet anatomy --size 302x100").width, 300);
}

}  // namespace
}  // namespace glenoid

int main(int argc, char** argv) {
  return glenoid::test::runPictureTests(argc, argv);
}
