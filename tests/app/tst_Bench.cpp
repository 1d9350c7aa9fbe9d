// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/app/Program.h"

namespace glenoid::testing {
namespace {

using Json = nlohmann::json;

const Json* tableOf(const Json& report, const std::string& id) {
  for (const Json& table : report["tables"])
    if (table["id"] == id) return &table;
  return nullptr;
}

TEST(BenchCommand, measuresEveryProfileAtBothNumbersOfContacts) {
  const Outcome outcome = glenoidProgram("bench --json --smallest");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const Json report = Json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << outcome.out;
  for (const char* field : {"build", "isa", "processor", "threads", "scenario", "jointHash", "dt", "extent"})
    EXPECT_TRUE(report.contains(field)) << field;
  EXPECT_EQ(report["threads"], 1);

  const Json* states = tableOf(report, "states");
  ASSERT_TRUE(states);
  ASSERT_EQ((*states)["rows"].size(), 2u);
  EXPECT_NEAR((*states)["rows"][0]["contacts"].get<int>(), 65, 4);
  EXPECT_NEAR((*states)["rows"][1]["contacts"].get<int>(), 153, 6);
  // Wanted were 25 and 60; what presses in the shoulder that ships is less (see simcore/study/README.md).
  for (const Json& row : (*states)["rows"]) EXPECT_GE(row["pressing"].get<int>(), 15) << row.dump();
  for (const Json& row : (*states)["rows"]) EXPECT_EQ(row["stateHash"].get<std::string>().size(), 32u);

  const Json* profiles = tableOf(report, "profiles");
  ASSERT_TRUE(profiles);
  ASSERT_EQ((*profiles)["rows"].size(), 6u);
  for (const Json& row : (*profiles)["rows"]) {
    EXPECT_GT(row["stepMedianMs"], 0.0) << row.dump();
    EXPECT_LE(row["stepMedianMs"], row["stepP99Ms"]) << row.dump();
    EXPECT_LT(row["solveMedianMs"], row["stepMedianMs"]) << row.dump();
    EXPECT_GE(row["repeats"], 3) << row.dump();
    if (row["profile"] == "reference") {
      EXPECT_EQ(row["velocityError"], 0.0);
    }
    // The same problem solved another way: 7e-11 here. Impulses may differ where more contacts press than bodies have
    // freedoms, velocities do not.
    if (row["profile"] == "direct") {
      EXPECT_LT(row["velocityError"], 1e-6) << row.dump();
      EXPECT_LT(row["complementarityMPerS"], 1e-8) << row.dump();
    }
  }
  const Json* stages = tableOf(report, "stages");
  ASSERT_TRUE(stages);
  EXPECT_GT((*stages)["rows"][0]["collideMedianMs"], 0.0);

  const Json* friction = tableOf(report, "friction");
  ASSERT_TRUE(friction);
  EXPECT_EQ((*friction)["rows"].size(), 4u);  // without and with, at both numbers of contacts

  const Json* bursa = tableOf(report, "bursa");
  ASSERT_TRUE(bursa);
  ASSERT_EQ((*bursa)["rows"].size(), 4u);
  EXPECT_EQ((*bursa)["rows"][0]["bursa"], "off");
  EXPECT_EQ((*bursa)["rows"][1]["bursa"], "on");  // the built-in joint has one
  EXPECT_GT((*bursa)["rows"][1]["ratio"], 0.0);

  const Json* growth = tableOf(report, "growth");
  ASSERT_TRUE(growth);
  ASSERT_EQ((*growth)["rows"].size(), 1u);
  EXPECT_NEAR((*growth)["rows"][0]["tetrahedra"].get<int>(), 750, 20);
  EXPECT_TRUE((*growth)["facts"]["stepExponent"].is_null());  // one size has no slope
  EXPECT_GT((*growth)["rows"][0]["memoryMiB"], 1.0);
}

TEST(BenchCommand, oneSectionIsReadable) {
  const Outcome outcome = glenoidProgram("bench --smallest --sections friction");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nFriction:"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("step median, ms"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("Growth"), std::string::npos) << outcome.out;
}

TEST(BenchCommand, hapticsIsJudgedInATimeOfItsOwn) {
  const std::string csv = "z-width-test.csv";
  const Outcome outcome = glenoidProgram("bench haptics --json --minutes 0 --seconds 2.5 --csv " + csv);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json report = Json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << outcome.out;
  const Json* contact = tableOf(report, "haptic-contact");
  ASSERT_TRUE(contact);
  ASSERT_EQ((*contact)["rows"].size(), 12u);
  for (const Json& row : (*contact)["rows"]) {
    EXPECT_EQ(row["kept"], true) << row.dump();
    EXPECT_EQ(row["forceErrorRmsN"].is_number(), row["addedDelayMs"] == 0.0) << row.dump();
  }
  EXPECT_TRUE(tableOf(report, "haptic-z-width"));
  EXPECT_FALSE(tableOf(report, "haptic-clock"));
  std::ifstream table(csv);
  std::string line;
  std::getline(table, line);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  EXPECT_EQ(line, "addedDelayMs,wallDampingNsPerM,stableNPerM,passiveNPerM,chosenNPerM");
  int rows = 0;
  while (std::getline(table, line)) ++rows;
  EXPECT_EQ(rows, 4 * 21);
  std::remove(csv.c_str());
}

}  // namespace
}  // namespace glenoid::testing
