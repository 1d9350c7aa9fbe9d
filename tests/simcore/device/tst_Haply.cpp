// SPDX-License-Identifier: GPL-3.0-or-later
// A client of the Inverse Service against a service of our own that keeps what is known of its manners. No device of Haply was at hand.
#include <gtest/gtest.h>

#include "tests/simcore/device/Feeling.h"
#include "tests/simcore/device/HaplyService.h"

namespace glenoid {
namespace {

using test::Feeling;
using test::HaplyService;

std::unique_ptr<DeviceLink> linkTo(int port) {
  const auto address = deviceAddress("haply:127.0.0.1:" + std::to_string(port));
  EXPECT_TRUE(address);
  auto link = openDevice(*address, test::pressedHome());
  EXPECT_TRUE(link) << (link ? "" : toLogLine(link.error()));
  return link ? std::move(*link) : nullptr;
}

TEST(Haply, sendsAMessageForEachStateAndAForceInTheServicesAxes) {
  HaplyService service;
  const auto link = linkTo(service.port());
  ASSERT_TRUE(link);
  Feeling feeling(link->device());
  // The wall pushes up, D's Y, which is the service's Z.
  ASSERT_TRUE(feeling.until([&] { return service.force[2] > 0.5; }));
  EXPECT_NEAR(service.force[0], 0, 1e-9);
  EXPECT_NEAR(service.force[1], 0, 1e-9);
  EXPECT_LE(service.outstandingMost, 1);
  EXPECT_EQ(service.sessions, 1);
  const long before = service.received;
  feeling.ticks(200);
  EXPECT_GT(service.received, before) << "it goes on by itself";
  EXPECT_LE(std::abs(service.received + 1 - service.answered), 1) << "and the inventory";
  service.x = 0.004;
  EXPECT_TRUE(feeling.until([&] { return std::abs(feeling.input.pose.p_WB.x() - 0.004) < 1e-6; }));
  const DeviceStory story = link->story();
  EXPECT_EQ(story.name, "i3");
  EXPECT_TRUE(story.present);
  EXPECT_GT(story.roundTripMs, 0);
}

TEST(Haply, findsOutWhichDialectIsUnderstood) {
  HaplyService service("vector");
  const auto link = linkTo(service.port());
  ASSERT_TRUE(link);
  Feeling feeling(link->device());
  EXPECT_TRUE(feeling.until([&] { return service.force[2] > 0.5; }));
}

TEST(Haply, eventsAreNoAnswers) {
  HaplyService service;
  service.events = true;
  const auto link = linkTo(service.port());
  ASSERT_TRUE(link);
  Feeling feeling(link->device());
  EXPECT_TRUE(feeling.until([&] { return service.received > 50; }));
  EXPECT_LE(service.outstandingMost, 2) << "the event that waits beside the answer";
  EXPECT_EQ(link->story().refused, 0);
}

TEST(Haply, aServiceThatLagsGetsFewerMessagesAndNoForce) {
  HaplyService service;
  const auto link = linkTo(service.port());
  ASSERT_TRUE(link);
  Feeling feeling(link->device());
  ASSERT_TRUE(feeling.until([&] { return service.force[2] > 0.5; }));
  service.lagMs = 30;
  ASSERT_TRUE(feeling.until([&] { return feeling.counts().lost > 20 && feeling.answer.force.isZero(0); }));
  const long before = service.received;
  const std::int64_t begin = steadyNow();
  feeling.ticks(200);
  EXPECT_LE(service.received - before, 2 + (steadyNow() - begin) / 30'000'000);
  EXPECT_LE(service.outstandingMost, 1);
}

TEST(Haply, aServiceThatGoesAndADeviceThatIsUnpluggedGiveNoForceAndComeBack) {
  auto service = std::make_unique<HaplyService>();
  const int port = service->port();
  const auto link = linkTo(port);
  ASSERT_TRUE(link);
  Feeling feeling(link->device());
  ASSERT_TRUE(feeling.until([&] { return service->force[2] > 0.5; }));
  service->plugged = false;
  ASSERT_TRUE(feeling.until([&] { return !feeling.present; }));
  feeling.ticks(6);
  EXPECT_TRUE(feeling.answer.force.isZero(0));
  EXPECT_TRUE(feeling.until([&] { return service->force[2] == 0; })) << "the last word is no force";
  service->plugged = true;
  ASSERT_TRUE(feeling.until([&] { return feeling.answer.force.y() > 0.5; }));
  service.reset();
  ASSERT_TRUE(feeling.until([&] { return !feeling.present && feeling.answer.force.isZero(0); }));
  EXPECT_FALSE(link->story().present);
  service = std::make_unique<HaplyService>("values", port);
  ASSERT_EQ(service->port(), port);
  EXPECT_TRUE(feeling.until([&] { return service->force[2] > 0.5; }));
  EXPECT_EQ(link->story().left, 2);
  EXPECT_LE(service->outstandingMost, 1);
}

TEST(Haply, aDeviceThatIsPluggedInLaterIsFound) {
  HaplyService service;
  service.plugged = false;
  const auto link = linkTo(service.port());
  ASSERT_TRUE(link);
  Feeling feeling(link->device());
  ASSERT_TRUE(feeling.until([&] { return service.received > 5; }));
  EXPECT_FALSE(feeling.present);
  service.plugged = true;
  EXPECT_TRUE(feeling.until([&] { return service.force[2] > 0.5; }));
}

TEST(Haply, whatIsNoNumberNeverBecomesAForce) {
  HaplyService service;
  const auto link = linkTo(service.port());
  ASSERT_TRUE(link);
  Feeling feeling(link->device());
  ASSERT_TRUE(feeling.until([&] { return service.force[2] > 0.5; }));
  for (const int kind : {1, 2}) {
    service.broken = kind;
    const long refused = link->story().refused;
    ASSERT_TRUE(feeling.until([&] { return link->story().refused > refused && feeling.answer.force.isZero(0); })) << kind;
    service.broken = 0;
    ASSERT_TRUE(feeling.until([&] { return feeling.answer.force.y() > 0.5; })) << kind;
  }
}

TEST(Haply, whereNobodyListensTheAnswerIsASentence) {
  int port = 0;
  { port = HaplyService().port(); }
  const auto link = openDevice(*deviceAddress("haply:127.0.0.1:" + std::to_string(port)), test::pressedHome());
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().fault, Fault::BadUsage);
  EXPECT_NE(link.error().arguments.front().find("Inverse Service"), std::string::npos);
}

}  // namespace
}  // namespace glenoid
