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

TEST(Sheets, withoutSkinThereIsOnePanelLess) {
  // Three panels of 100 pixels: bones, ligaments, muscles.
  EXPECT_EQ(pictureOf("builtin:shoulder --sheet anatomy --size 302x100").width, 300);
}

}  // namespace
}  // namespace glenoid

int main(int argc, char** argv) {
  return glenoid::test::runPictureTests(argc, argv);
}
