// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/RecordingFile.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/simcore/file/TemporaryFolder.h"

namespace glenoid {
namespace {

Recording sample() {
  Recording recording;
  recording.scenario = "builtin:arthroscopy";
  recording.dt = 0.004;
  recording.profile = "direct";
  recording.seed = 4000000000u;
  recording.steps = 250;
  HandTrack probe{"probe", {}}, finger{"finger", {{0, {}}}};
  for (int i = 0; i < 20; ++i)
    probe.keys.push_back(
        {i / 3.0, {{0.1 * i, 1.0 / 7.0, -1e-17}, Quat(Eigen::AngleAxisd(0.3 * i, Vec3::UnitZ()))}});
  recording.tracks = {probe, finger};
  recording.marks = {{"press", 1, 2.5, "probe", "cuff"}, {"rest", 3, 3, "", ""}};
  recording.jointHash = "0123456789abcdef";
  recording.build = "1.0";
  recording.isa = "avx2";
  recording.stateHash = "fedcba";
  return recording;
}

TEST(RecordingFile, whatIsSavedComesBackBitForBit) {
  const TemporaryFolder folder;
  ASSERT_TRUE(saveRecording(sample(), folder.path("a.recording")).ok());
  const auto back = loadRecording(folder.path("a.recording"));
  ASSERT_TRUE(back.ok()) << toLogLine(back.error());
  const Recording expected = sample();
  EXPECT_EQ(back->scenario, expected.scenario);
  EXPECT_EQ(back->dt, expected.dt);
  EXPECT_EQ(back->profile, expected.profile);
  EXPECT_EQ(back->seed, expected.seed);
  EXPECT_EQ(back->steps, expected.steps);
  EXPECT_EQ(back->jointHash, expected.jointHash);
  EXPECT_EQ(back->build, expected.build);
  EXPECT_EQ(back->isa, expected.isa);
  EXPECT_EQ(back->stateHash, expected.stateHash);
  ASSERT_EQ(back->tracks.size(), 2u);
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_EQ(back->tracks[t].tool, expected.tracks[t].tool);
    ASSERT_EQ(back->tracks[t].keys.size(), expected.tracks[t].keys.size());
    for (std::size_t i = 0; i < expected.tracks[t].keys.size(); ++i) {
      const HandKey &a = back->tracks[t].keys[i], &b = expected.tracks[t].keys[i];
      EXPECT_EQ(a.time, b.time);
      EXPECT_EQ(a.hand.p_WB, b.hand.p_WB);
      EXPECT_EQ(a.hand.q_WB.coeffs(), b.hand.q_WB.coeffs());
    }
  }
  ASSERT_EQ(back->marks.size(), 2u);
  EXPECT_EQ(back->marks[0].name, "press");
  EXPECT_EQ(back->marks[0].end, 2.5);
  EXPECT_EQ(back->marks[0].tool, "probe");
  EXPECT_EQ(back->marks[0].part, "cuff");
}

TEST(RecordingFile, slipsAreNamedWithTheirPlace) {
  struct Slip {
    const char* members;
    Fault fault;
    const char* pointer;
  };
  for (
      const Slip& slip :
      {Slip{R"("tracks": [{"tool": "a", "keys": []}])", Fault::SchemaMismatch, "/tracks/0/keys"},
       Slip{R"("tracks": [{"tool": "a", "keys": [{"time": 0, "position": [0, 0]}]}])", Fault::SchemaMismatch,
            "/tracks/0/keys/0/position"},
       Slip{
           R"("tracks": [{"tool": "a", "keys": [{"time": 1, "position": [0, 0, 0]}, {"time": 1, "position": [0, 0, 0]}]}])",
           Fault::OutOfRange, "/tracks/0/keys/1/time"},
       Slip{
           R"("tracks": [{"tool": "a", "keys": [{"time": 0, "position": [0, 0, 0], "rotation": [0, 0, 0, 2]}]}])",
           Fault::OutOfRange, "/tracks/0/keys/0/rotation"},
       Slip{R"("tracks": [{"tool": "a", "keys": [{"time": 0, "position": [0, nan, 0]}]}])", Fault::NotFinite,
            "/tracks/0/keys/0/position/1"},
       Slip{R"("tracks": [{"tool": "a", "keys": [{"time": 0, "position": [0, 0, 0]}]},
                              {"tool": "a", "keys": [{"time": 0, "position": [0, 0, 0]}]}])",
            Fault::DuplicateId, "/tracks/1/tool"},
       Slip{R"("tracks": [], "marks": [{"name": "m", "begin": 2, "end": 1}])", Fault::OutOfRange,
            "/marks/0/end"},
       Slip{R"("tracks": [], "dt": 0)", Fault::OutOfRange, "/dt"},
       Slip{R"("tracks": [], "steps": 1.5)", Fault::SchemaMismatch, "/steps"}}) {
    const TemporaryFolder folder;
    const std::string path = folder.put(
        "a.recording", std::string(R"({"schemaVersion": 1, "scenario": "s", )") + slip.members + "}");
    const auto loaded = loadRecording(path);
    ASSERT_FALSE(loaded.ok()) << slip.members;
    EXPECT_EQ(loaded.error().fault, slip.fault) << slip.members << toLogLine(loaded.error());
    EXPECT_EQ(loaded.error().place.pointer, slip.pointer) << slip.members;
    EXPECT_EQ(loaded.error().place.file, path);
  }
}

TEST(RecordingFile, savingRefusesWhatCouldNotBeLoaded) {
  const TemporaryFolder folder;
  const std::string path = folder.put("a.recording", "old");
  Recording recording = sample();
  recording.tracks[0].keys[3].hand.p_WB.x() = std::numeric_limits<double>::infinity();
  const auto saved = saveRecording(recording, path);
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.error().fault, Fault::NotFinite);
  EXPECT_EQ(saved.error().place.pointer, "/tracks/0/keys/3/position/0");
  EXPECT_EQ(folder.get("a.recording"), "old");
  recording = sample();
  recording.profile = "fast";
  EXPECT_EQ(checkRecording(recording, "r").error().fault, Fault::SchemaMismatch);
}

}  // namespace
}  // namespace glenoid
