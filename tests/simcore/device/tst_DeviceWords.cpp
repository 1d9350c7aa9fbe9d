// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "simcore/base/Turns.h"
#include "simcore/device/BridgePacket.h"
#include "simcore/device/DeviceLink.h"
#include "simcore/device/DevicePort.h"
#include "simcore/device/HaplyWords.h"
#include "simcore/file/Json.h"
#include "simcore/tool/PoseSpring.h"

namespace glenoid {
namespace {

TEST(DeviceAddress, isReadOrRefusedWithASentence) {
  const auto good = [](const char* word) { return deviceAddress(word).value(); };
  EXPECT_EQ(good("haply").port, 10001);
  EXPECT_EQ(good("haply").host, "127.0.0.1");
  EXPECT_EQ(good("haply:lab").host, "lab");
  EXPECT_EQ(good("haply:lab").port, 10001);
  EXPECT_EQ(good("haply:lab:80").port, 80);
  EXPECT_EQ(good("haply:80").port, 80);
  EXPECT_EQ(good("bridge:4000").port, 4000);
  EXPECT_EQ(good("spnav:/run/a b.sock").host, "/run/a b.sock");
  EXPECT_EQ(good("igtl:lab:18944/Probe").name, "Probe");
  EXPECT_EQ(good("igtl:lab:18944/Probe").host, "lab");
  for (const char* bad : {"", "phantom", "haply:", "haply:lab:", "haply:lab:x", "haply:lab:0", "haply:lab:70000", "haply::80", "bridge:lab", "bridge:lab:1", "bridge:0"}) {
    const auto address = deviceAddress(bad);
    ASSERT_FALSE(address) << bad;
    EXPECT_EQ(address.error().fault, Fault::BadUsage);
    EXPECT_FALSE(address.error().arguments.front().empty());
  }
  EXPECT_TRUE(namesDevice("haply:x"));
  EXPECT_FALSE(namesDevice("inverse3"));
}

TEST(DeviceAnchor, beginsAtTheToolsHomeAndMovesAsSeenFromTheCamera) {
  // Looking along −X from the front: right is −Z... as the axes of whoever stands there.
  const Quat axes = deviceAxes(Vec3(1, 0, 0), Vec3::Zero(), Vec3::UnitY());
  EXPECT_LT((axes * Vec3::UnitZ() - Vec3::UnitX()).norm(), 1e-12) << "toward him";
  EXPECT_LT((axes * Vec3::UnitX() + Vec3::UnitZ()).norm(), 1e-12) << "to his right";
  const Pose home{Vec3(0.1, 0.2, 0.3), Quat(0, 1, 0, 0)};
  DeviceAnchor anchor(axes, home);
  const Pose first{Vec3(5, 6, 7), Quat(1, 1, 0, 0).normalized()};
  EXPECT_LT((anchor.toWorld(first).p_WB - home.p_WB).norm(), 1e-12);
  Pose next = first;
  next.p_WB += Vec3(0.01, 0, 0);
  next.q_WB = (turnBy(Vec3(0, 0, 0.3)) * first.q_WB).normalized();  // about the axis toward him
  const Pose moved = anchor.toWorld(next);
  EXPECT_LT((moved.p_WB - home.p_WB - Vec3(0, 0, -0.01)).norm(), 1e-12);
  EXPECT_NEAR(turnBetween(moved.q_WB, turnBy(Vec3(0.3, 0, 0)) * home.q_WB), 0, 1e-9);
  EXPECT_LT((anchor.toDevice(Vec3(1, 2, 3)) - Vec3(-3, 2, 1)).norm(), 1e-12);
  // Gone and elsewhere again: the tool stays where it was.
  anchor.lift();
  const Pose back = anchor.toWorld({Vec3(-1, -1, -1), Quat::Identity()});
  EXPECT_LT((back.p_WB - moved.p_WB).norm(), 1e-12);
  EXPECT_NEAR(turnBetween(back.q_WB, moved.q_WB), 0, 1e-7);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isHandPose(anchor.toWorld({Vec3(nan, 0, 0), Quat::Identity()})));
  EXPECT_LT((anchor.toWorld({Vec3(-1, -1, -1), Quat::Identity()}).p_WB - moved.p_WB).norm(), 1e-12) << "what is no pose anchors nothing";
  // A last word far off, then gone: back, it goes on from where the tool was, not from there.
  anchor.toWorld({Vec3(4, 4, 4), Quat::Identity()});
  anchor.lift();
  EXPECT_LT((anchor.toWorld({Vec3(2, 2, 2), Quat::Identity()}).p_WB - moved.p_WB).norm(), 1e-12);
}

TEST(DevicePort, aDeviceWithForcesAgesAndOneWithoutIsGoneThroughEvenly) {
  DevicePort strict(DeviceAnchor(Quat::Identity(), {}), 0), slow(DeviceAnchor(Quat::Identity(), {}), 0.25);
  ToolInput input;
  EXPECT_FALSE(strict.read(0, input)) << "nobody has spoken";
  const auto say = [&](double x, std::int64_t ms) {
    ToolInput word;
    word.pose.p_WB = Vec3(x, 0, 0);
    word.stamp = ms * 1'000'000;
    strict.say(word);
    slow.say(word);
  };
  say(1, 0);
  ASSERT_TRUE(strict.read(0, input) && slow.read(0, input));
  say(1.03, 30);
  ASSERT_TRUE(strict.read(30'000'000, input));
  EXPECT_NEAR(input.pose.p_WB.x(), 0.03, 1e-12);
  ASSERT_TRUE(strict.read(90'000'000, input));
  EXPECT_EQ(input.stamp, 30'000'000) << "its silence counts";
  for (const auto& [ms, x] : {std::pair{30, 0.0}, {45, 0.015}, {60, 0.03}, {90, 0.03}}) {
    ASSERT_TRUE(slow.read(ms * 1'000'000LL, input));
    EXPECT_NEAR(input.pose.p_WB.x(), x, 1e-12) << ms;
    EXPECT_EQ(input.stamp, ms * 1'000'000LL);
  }
  ASSERT_TRUE(slow.read(400'000'000, input));
  EXPECT_EQ(input.stamp, 30'000'000) << "for so long and no longer";
  slow.leave();
  EXPECT_FALSE(slow.read(401'000'000, input));
}

TEST(BridgePacket, isWhatItsDescriptionSays) {
  BridgePose pose;
  pose.sequence = 0x01020304;
  pose.pose = {Vec3(1.5, -2, 0.25), Quat(0.5, 0.5, -0.5, 0.5)};
  pose.grip = 0.75;
  pose.buttons = 5;
  const auto bytes = bytesOf(pose);
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "GBP1");
  EXPECT_EQ(bytes[4], 4) << "little-endian";
  EXPECT_EQ(bytes[8 + 7], 0x3f) << "1.5 is 3ff8 0000 0000 0000";
  EXPECT_EQ(bytes[8 + 6], 0xf8);
  EXPECT_EQ(bytes[72], 5);
  const auto again = bridgePose(bytes);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->sequence, pose.sequence);
  EXPECT_EQ(again->pose.p_WB, pose.pose.p_WB);
  EXPECT_EQ(again->pose.q_WB.coeffs(), pose.pose.q_WB.coeffs());
  EXPECT_EQ(again->grip, 0.75);
  EXPECT_FALSE(bridgePose(std::span(bytes).first(79)));
  const BridgeForce force{7, {Vec3(1, 2, 3), Vec3(4, 5, 6)}, true};
  const auto sent = bytesOf(force);
  EXPECT_FALSE(bridgePose(sent));
  const auto got = bridgeForce(sent);
  ASSERT_TRUE(got && got->live);
  EXPECT_EQ(got->force.torque, Vec3(4, 5, 6));
}

TEST(HaplyWords, areReadFromEitherKindOfGripAndPassedByWhereTheyAreEvents) {
  const char* text = R"({"inverse3":[{"device_id":"1","state":{"cursor_position":{"x":0.01,"y":-0.12,"z":0.15},"current_cursor_force":{"x":1,"y":2,"z":3}}}],
    "verse_grip":[],"wireless_verse_grip":[{"device_id":"g","state":{"orientation":{"x":0,"y":0,"z":0.6,"w":0.8},"buttons":{"a":true,"c":true}}}]})";
  const auto word = haplyWord(text, "");
  ASSERT_TRUE(word && word->isState && word->hasPose);
  EXPECT_EQ(word->device, "1");
  EXPECT_LT((word->pose.p_WB - Vec3(0.01, 0.15, 0.12)).norm(), 1e-12);
  EXPECT_LT((rotationVector(word->pose.q_WB).normalized() - Vec3::UnitY()).norm(), 1e-9) << "about the service's up";
  EXPECT_EQ(word->buttons, 5u);
  EXPECT_LT((*word->force - Vec3(1, 3, -2)).norm(), 1e-12);
  EXPECT_TRUE(haplyWord(text, "2")->device.empty());
  EXPECT_FALSE(haplyWord(R"({"event":"battery"})", "")->isState);
  EXPECT_FALSE(haplyWord("{\"inverse3\":[{\"device_id\":\"1\",\"state\":{\"cursor_position\":{\"x\":nan", ""));
  EXPECT_FALSE(haplyWord("[]", ""));
  const auto broken = haplyWord(R"({"inverse3":[{"device_id":"1","state":{"cursor_position":{"x":null,"y":0,"z":0}}}]})", "");
  ASSERT_TRUE(broken && broken->hasPose);
  EXPECT_FALSE(isHandPose(broken->pose));
}

TEST(HaplyWords, aCommandIsWrittenInBothDialects) {
  for (const auto& [dialect, member] : {std::pair{HaplyDialect::Values, "values"}, {HaplyDialect::Vector, "vector"}}) {
    const auto json = parseJson(haplyCommand("a7", Vec3(1, 2, 3), dialect, true), "command");
    ASSERT_TRUE(json);
    EXPECT_EQ((*json)["session"]["configure"]["profile"]["name"].text(), "glenoid");
    const JsonValue& force = (*json)["inverse3"][0]["commands"]["set_cursor_force"][member];
    EXPECT_EQ((*json)["inverse3"][0]["device_id"].text(), "a7");
    EXPECT_EQ(Vec3(force["x"].number(), force["y"].number(), force["z"].number()), Vec3(1, -3, 2));
  }
  const auto later = parseJson(haplyCommand("a7", Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0), HaplyDialect::Values, false), "command");
  ASSERT_TRUE(later);
  EXPECT_FALSE(later->find("session"));
  EXPECT_EQ((*later)["inverse3"][0]["commands"]["set_cursor_force"]["values"]["x"].number(-1), 0);
}

}  // namespace
}  // namespace glenoid
