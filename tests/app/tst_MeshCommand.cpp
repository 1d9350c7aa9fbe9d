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

TEST(MeshCommand, theFormatIsTheEndings) {
  const auto folder = freshFolder();
  writeText(folder / "box.obj", openBox());
  for (const auto& [name, format] : {std::pair{"a.stl", "STL"}, {"a.obj", "OBJ"}, {"a.ply", "PLY"}, {"A.STL", "STL"}}) {
    const std::string out = (folder / name).string();
    const Outcome done = glenoidProgram("mesh repair '" + (folder / "box.obj").string() + "' --out '" + out + "' --auto --unit cm");
    EXPECT_EQ(done.status, 0) << name << done.err;
    const Outcome info = glenoidProgram("mesh info --json '" + out + "'");  // STL and OBJ by another library than wrote them
    ASSERT_EQ(info.status, 0) << name << info.err;
    const auto file = nlohmann::json::parse(info.out)[0];
    EXPECT_EQ(file["format"], format);
    EXPECT_TRUE(file["surfaces"][0]["healthy"]) << name;
    EXPECT_EQ(file["surfaces"][0]["triangles"], 12) << name;
    EXPECT_NEAR(file["surfaces"][0]["volume"].get<double>(), 0.01 * 0.012 * 0.155, 1e-12) << name;
  }
  // In place too, and what was there stays where the name has no format of ours.
  const std::string own = (folder / "a.stl").string();
  EXPECT_EQ(glenoidProgram("mesh repair '" + own + "' --out '" + own + "' --unit m").status, 0);
  EXPECT_NE(glenoidProgram("mesh info '" + own + "'").out.find("STL, 1 surface"), std::string::npos);
  for (const char* name : {"a.vtp", "a", "a.stl.gz", ".stl"}) {
    const Outcome done = glenoidProgram("mesh repair '" + own + "' --out '" + (folder / name).string() + "'");
    EXPECT_EQ(done.status, 2) << name;
    EXPECT_NE(done.err.find(".stl or .obj"), std::string::npos) << done.err;
    EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
  }
}

TEST(MeshCommand, lengthsMayHaveAUnit) {
  const auto folder = freshFolder();
  // A plate of 40 × 0.2 × 30 mm in a file without a unit.
  writeText(folder / "plate.obj", "v 0 0 0\nv 40 0 0\nv 40 0.2 0\nv 0 0.2 0\nv 0 0 30\nv 40 0 30\nv 40 0.2 30\nv 0 0.2 30\n"
                                  "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n");
  const std::string in = "mesh repair '" + (folder / "plate.obj").string() + "' --out '";
  const auto volume = [&](const char* name, const std::string& more) {
    const std::string out = (folder / name).string();
    const Outcome done = glenoidProgram(in + out + "'" + more);
    EXPECT_LE(done.status, 1) << name << done.err;
    const Outcome info = glenoidProgram("mesh info --json '" + out + "'");
    return info.status == 0 ? nlohmann::json::parse(info.out)[0]["surfaces"][0]["volume"].get<double>() : -1.0;
  };
  const double plain = volume("plain.ply", " --steps thicken=1"), metres = volume("metres.ply", " --unit mm --steps thicken=0.001");
  EXPECT_GT(plain, 2.5 * 40 * 0.2 * 30) << "in the file's unit";
  EXPECT_NEAR(metres, 1e-9 * plain, 1e-12) << "in metres where the unit is named";
  EXPECT_NEAR(volume("mm.ply", " --unit mm --steps thicken=1mm"), metres, 1e-15);
  EXPECT_NEAR(volume("cm.ply", " --unit mm --steps thicken=0.1cm"), metres, 1e-15);
  EXPECT_NEAR(volume("um.ply", " --unit mm --steps thicken=1000um"), metres, 1e-15);
  const Outcome unknown = glenoidProgram(in + (folder / "o.ply").string() + "' --steps thicken=1mm");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("unit"), std::string::npos) << unknown.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "o.ply"));
  // What info proposes says its unit and can be taken as it stands.
  const Outcome info = glenoidProgram("mesh info '" + (folder / "plate.obj").string() + "'");
  const std::size_t at = info.out.find("thicken=");
  ASSERT_NE(at, std::string::npos) << info.out;
  const std::string word = info.out.substr(at, info.out.find_first_of(" ,\n(", at) - at);
  EXPECT_TRUE(word.ends_with("mm")) << word;
  EXPECT_GT(volume("proposed.ply", " --unit mm --steps " + word), 2e-9 * 40 * 0.2 * 30);
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
