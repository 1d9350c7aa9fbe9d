// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/Program.h"

namespace glenoid::testing {
namespace {

/// A box of 10 × 12 × 155 mm, wound inwards, its top missing, in centimetres.
std::string openBox() {
  return "o scapula_right\nv 0 0 0\nv 1 0 0\nv 0 1.2 0\nv 1 1.2 0\nv 0 0 15.5\nv 1 0 15.5\nv 0 1.2 15.5\nv 1 1.2 15.5\n"
         "f 2 4 3 1\nf 5 6 2 1\nf 4 8 7 3\nf 3 7 5 1\nf 6 8 4 2\n";
}

TEST(MeshCommand, infoSaysWhatIsWrong) {
  const auto folder = freshFolder();
  writeText(folder / "box.obj", openBox());
  const Outcome info = glenoidProgram("mesh info '" + (folder / "box.obj").string() + "'");
  EXPECT_EQ(info.status, 0) << info.err;
  for (const char* words : {"OBJ", "scapula_right", "polygons-split", "probably in cm", "side right", "holes", "inside-out", "repair: fillHoles", "not fit"})
    EXPECT_NE(info.out.find(words), std::string::npos) << words << "\n" << info.out;
}

TEST(MeshCommand, infoForProgramsIsJson) {
  const auto folder = freshFolder();
  writeText(folder / "box.obj", openBox());
  const Outcome info = glenoidProgram("mesh info --json '" + (folder / "box.obj").string() + "'");
  ASSERT_EQ(info.status, 0) << info.err;
  const auto json = nlohmann::json::parse(info.out);
  ASSERT_EQ(json.size(), 1u);
  const auto& surface = json[0]["surfaces"][0];
  EXPECT_EQ(surface["triangles"], 10);
  EXPECT_EQ(surface["metresPerUnit"], 0.01);
  EXPECT_EQ(surface["holes"], 1);
  EXPECT_EQ(surface["openEdges"], 4);
  EXPECT_EQ(surface["side"], "right");
  EXPECT_FALSE(surface["healthy"]);
  EXPECT_EQ(surface["automaticRepairs"][0], "fillHoles");
}

TEST(MeshCommand, repairWritesASoundSurfaceInMetres) {
  const auto folder = freshFolder();
  writeText(folder / "box.obj", openBox());
  const std::string out = (folder / "box.ply").string();
  const Outcome done = glenoidProgram("mesh repair '" + (folder / "box.obj").string() + "' --out '" + out + "' --auto --unit cm --axes '-y z -x'");
  EXPECT_EQ(done.status, 0) << done.err;
  const Outcome info = glenoidProgram("mesh info --json '" + out + "'");
  ASSERT_EQ(info.status, 0) << info.err;
  const auto surface = nlohmann::json::parse(info.out)[0]["surfaces"][0];
  EXPECT_TRUE(surface["healthy"]);
  EXPECT_NEAR(surface["volume"].get<double>(), 0.01 * 0.012 * 0.155, 1e-9);
  EXPECT_NEAR(surface["high"][1].get<double>(), 0.155, 1e-9);
  EXPECT_NEAR(surface["low"][0].get<double>(), -0.012, 1e-9);
}

TEST(MeshCommand, whatRemainsIsSaidByTheStatus) {
  const auto folder = freshFolder();
  writeText(folder / "box.obj", openBox());
  const Outcome done = glenoidProgram("mesh repair '" + (folder / "box.obj").string() + "' --out '" + (folder / "box.ply").string() + "' --steps orient");
  EXPECT_EQ(done.status, 1);
  EXPECT_EQ(lineCount(done.err), 1) << done.err;
  EXPECT_NE(done.out.find("holes"), std::string::npos);
}

TEST(MeshCommand, slipsAreOneSentence) {
  const auto folder = freshFolder();
  writeText(folder / "box.obj", openBox());
  writeText(folder / "two.obj", openBox() + "o other\nv 0 0 99\nv 1 0 99\nv 0 1 99\nf 9 10 11\n");
  writeText(folder / "bad.stl", "solid x\nfacet");
  writeText(folder / "box.mesh", "not for us");
  const std::string box = "'" + (folder / "box.obj").string() + "'", out = " --out '" + (folder / "o.ply").string() + "'";
  for (const std::string& words : {std::string("mesh"), std::string("mesh info"), std::string("mesh info nowhere.stl"), "mesh info '" + (folder / "bad.stl").string() + "'",
                                   "mesh info '" + (folder / "box.mesh").string() + "'", "mesh repair " + box, "mesh repair " + box + out + " --steps polish",
                                   "mesh repair " + box + out + " --unit furlong", "mesh repair " + box + out + " --axes 'x x z'", "mesh repair " + box + out + " --surface 7",
                                   "mesh repair '" + (folder / "two.obj").string() + "'" + out, std::string("mesh polish")}) {
    const Outcome done = glenoidProgram(words);
    EXPECT_EQ(done.status, 2) << words;
    EXPECT_EQ(lineCount(done.err), 1) << words << ": " << done.err;
    EXPECT_EQ(done.err.find("Internal"), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "o.ply"));
}

}  // namespace
}  // namespace glenoid::testing
