// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>
#include <limits>

#include "simcore/device/BridgePacket.h"
#include "tests/simcore/device/Feeling.h"

namespace glenoid {
namespace {

using test::Feeling;

/// A port of this machine that nobody has.
int freePort() {
  const int handle = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof here;
  if (bind(handle, reinterpret_cast<sockaddr*>(&here), length) != 0 || getsockname(handle, reinterpret_cast<sockaddr*>(&here), &length) != 0) return 0;
  ::close(handle);
  return ntohs(here.sin_port);
}

/// The other end: a maker's program.
class Client {
 public:
  explicit Client(int port) : m_handle(socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in there{};
    there.sin_family = AF_INET;
    there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    there.sin_port = htons(static_cast<std::uint16_t>(port));
    EXPECT_EQ(connect(m_handle, reinterpret_cast<sockaddr*>(&there), sizeof there), 0);
  }
  ~Client() { ::close(m_handle); }
  void say(const Pose& pose) {
    const auto bytes = bytesOf(BridgePose{++sequence, pose, 0.5, 3});
    raw(bytes.data(), bytes.size());
  }
  void raw(const void* bytes, std::size_t size) { EXPECT_EQ(send(m_handle, bytes, size, 0), static_cast<ssize_t>(size)); }
  std::optional<BridgeForce> hear() {
    std::optional<BridgeForce> last;
    unsigned char bytes[256];
    for (ssize_t size; (size = recv(m_handle, bytes, sizeof bytes, MSG_DONTWAIT)) > 0;) {
      last = bridgeForce({bytes, static_cast<std::size_t>(size)});
      ++answers;
    }
    return last;
  }
  std::uint32_t sequence = 0;
  long answers = 0;

 private:
  int m_handle;
};

std::unique_ptr<DeviceLink> bridgeAt(int port) {
  auto link = openDevice(*deviceAddress("bridge:" + std::to_string(port)), test::pressedHome());
  EXPECT_TRUE(link) << (link ? "" : toLogLine(link.error()));
  return link ? std::move(*link) : nullptr;
}

TEST(Bridge, eachPoseIsAnsweredWithTheForceThatItFeels) {
  const int port = freePort();
  const auto link = bridgeAt(port);
  ASSERT_TRUE(link);
  Client client(port);
  Feeling feeling(link->device());
  feeling.ticks(3);
  EXPECT_FALSE(feeling.present);
  std::optional<BridgeForce> force;
  ASSERT_TRUE(feeling.until([&] {
    force = client.hear();
    client.say({});
    return force && force->force.force.y() > 0.5;
  }));
  EXPECT_TRUE(force->live);
  EXPECT_NEAR(force->force.force.x(), 0, 1e-12);
  EXPECT_EQ(feeling.input.buttons, 3u);
  EXPECT_EQ(feeling.input.grip, 0.5);
  feeling.ticks(1);
  client.hear();
  EXPECT_LE(client.answers, static_cast<long>(client.sequence));
}

TEST(Bridge, aClientThatFallsSilentFeelsNothingAndAnotherMayComeThen) {
  const int port = freePort();
  const auto link = bridgeAt(port);
  ASSERT_TRUE(link);
  auto client = std::make_unique<Client>(port);
  Feeling feeling(link->device());
  ASSERT_TRUE(feeling.until([&] { client->say({}); return feeling.answer.force.y() > 0.5; }));
  // Silent: its last word is too old after 2 ms, and after 5 ms there is no force.
  // Counted in ticks, of which a busy machine makes fewer in that time, never more.
  int ticks = 0;
  ASSERT_TRUE(feeling.until([&] { return ++ticks, feeling.answer.force.isZero(0); }));
  EXPECT_LE(ticks, 9);
  Client other(port);
  const long refused = link->story().refused;
  ASSERT_TRUE(feeling.until([&] { client->say({}); other.say({}); return link->story().refused > refused + 3; })) << "one hand, one client";
  client.reset();
  EXPECT_TRUE(feeling.until([&] { other.say({}); return feeling.answer.force.y() > 0.5; }));
}

TEST(Bridge, whatIsNoPoseIsRefusedAndGivesNoForce) {
  const int port = freePort();
  const auto link = bridgeAt(port);
  ASSERT_TRUE(link);
  Client client(port);
  Feeling feeling(link->device());
  ASSERT_TRUE(feeling.until([&] { client.say({}); return feeling.answer.force.y() > 0.5; }));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Pose& wild : {Pose{Vec3(nan, 0, 0), Quat::Identity()}, Pose{Vec3(0.3, 0, 0), Quat::Identity()}, Pose{Vec3::Zero(), Quat(0, 0, 0, 0)}}) {
    // A jump is a jump once: from then on the hand is there, so it must go on jumping to stay wild.
    int turn = 0;
    ASSERT_TRUE(feeling.until([&] { client.say(++turn % 2 ? wild : Pose{}); return feeling.answer.force.isZero(0); }));
    ASSERT_TRUE(feeling.until([&] { client.say({}); return feeling.answer.force.y() > 0.5; }));
  }
  const long refused = link->story().refused;
  ASSERT_TRUE(feeling.until([&] { client.raw("GBP1 too short", 14); client.say({}); return link->story().refused > refused + 2; }));
  EXPECT_TRUE(feeling.until([&] { client.say({}); return feeling.answer.force.y() > 0.5; }));
}

TEST(Bridge, aPortThatIsTakenIsSaid) {
  const int port = freePort();
  const auto link = bridgeAt(port);
  const auto second = openDevice(*deviceAddress("bridge:" + std::to_string(port)), test::pressedHome());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().fault, Fault::BadUsage);
}

// The program that ships for makers, as it stands there.
TEST(Bridge, theExampleClientIsUnderstood) {
  const int port = freePort();
  const auto link = bridgeAt(port);
  ASSERT_TRUE(link);
  Feeling feeling(link->device());
  FILE* out = popen((std::string(GLENOID_BRIDGE_CLIENT) + " " + std::to_string(port) + " 1").c_str(), "r");
  ASSERT_TRUE(out);
  EXPECT_TRUE(feeling.until([&] { return link->story().words > 100; }));
  for (const std::int64_t begin = steadyNow(); steadyNow() - begin < 1'300'000'000;) feeling.tick();
  char line[200] = "";
  EXPECT_TRUE(std::fgets(line, sizeof line, out));
  pclose(out);
  long sent = 0, answers = 0;
  double most = 0;
  ASSERT_EQ(std::sscanf(line, "%ld poses sent, %ld answers, %lf N at most", &sent, &answers, &most), 3) << line;
  EXPECT_GT(answers, 50);
  EXPECT_EQ(link->story().refused, 0);
  EXPECT_GT(most, 0.1);
}

}  // namespace
}  // namespace glenoid
