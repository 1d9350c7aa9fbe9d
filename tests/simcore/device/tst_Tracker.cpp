// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <igtlPositionMessage.h>
#include <igtlServerSocket.h>
#include <igtlStatusMessage.h>
#include <igtlTransformMessage.h>

#include <limits>

#include "simcore/base/Turns.h"
#include "tests/simcore/device/Feeling.h"

namespace glenoid {
namespace {

using test::Feeling;

/// A server as trackers are behind it, by the library itself.
class Server {
 public:
  Server() : m_server(igtl::ServerSocket::New()) {
    for (port = 20944; port < 20999 && m_server->CreateServer(port) < 0;) ++port;
  }
  ~Server() {
    if (m_client.IsNotNull()) m_client->CloseSocket();
    m_server->CloseSocket();
  }
  /// Whoever connects last: openDevice() first looks whether anybody listens.
  bool accept() {
    for (int i = 0; i < 2; ++i)
      if (auto next = m_server->WaitForConnection(i == 0 ? 3000 : 1000); next.IsNotNull()) m_client = next;
    return m_client.IsNotNull();
  }
  void hangUp() {
    m_client->CloseSocket();
    m_client = nullptr;
  }
  void transform(const char* name, const Pose& pose, bool spoilt = false) {
    auto message = igtl::TransformMessage::New();
    message->SetDeviceName(name);
    igtl::Matrix4x4 matrix;
    igtl::IdentityMatrix(matrix);
    const Mat3 turn = pose.q_WB.toRotationMatrix();
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) matrix[r][c] = static_cast<float>(turn(r, c));
      matrix[r][3] = static_cast<float>(1e3 * pose.p_WB[r]);
    }
    message->SetMatrix(matrix);
    message->Pack();
    if (spoilt) static_cast<char*>(message->GetPackBodyPointer())[5] ^= 1;
    m_client->Send(message->GetPackPointer(), message->GetPackSize());
  }
  void position(const char* name, const Vec3& p) {
    auto message = igtl::PositionMessage::New();
    message->SetDeviceName(name);
    message->SetPosition(static_cast<float>(1e3 * p.x()), static_cast<float>(1e3 * p.y()), static_cast<float>(1e3 * p.z()));
    message->SetQuaternion(0, 0, 0, 1);
    message->Pack();
    m_client->Send(message->GetPackPointer(), message->GetPackSize());
  }
  void status() {
    auto message = igtl::StatusMessage::New();
    message->SetDeviceName("Tracker");
    message->SetStatusString("all is well");
    message->Pack();
    m_client->Send(message->GetPackPointer(), message->GetPackSize());
  }
  int port = 0;

 private:
  igtl::ServerSocket::Pointer m_server;
  igtl::ClientSocket::Pointer m_client;
};

std::unique_ptr<DeviceLink> linkTo(const Server& server, const std::string& name = "") {
  auto link = openDevice(*deviceAddress("igtl:127.0.0.1:" + std::to_string(server.port) + (name.empty() ? "" : "/" + name)), DeviceAnchor(Quat::Identity(), {}));
  EXPECT_TRUE(link) << (link ? "" : toLogLine(link.error()));
  return link ? std::move(*link) : nullptr;
}

TEST(Tracker, movesTheToolInMetresAndPassesOverWhatIsNoPose) {
  Server server;
  const auto link = linkTo(server);
  ASSERT_TRUE(link && server.accept());
  Feeling feeling(link->device());
  ASSERT_TRUE(feeling.until([&] { server.transform("Probe", {}); return feeling.present; }));
  const Pose there{Vec3(0.012, -0.003, 0.1), turnBy(Vec3(0.2, 0, 0.1))};
  ASSERT_TRUE(feeling.until([&] {
    server.status();
    server.transform("Probe", there);
    server.transform("Another", {Vec3(9, 9, 9), Quat::Identity()});
    return (feeling.input.pose.p_WB - there.p_WB).norm() < 1e-6;
  }));
  EXPECT_NEAR(turnBetween(feeling.input.pose.q_WB, there.q_WB), 0, 1e-5);
  EXPECT_EQ(link->story().name, "Probe");
  EXPECT_EQ(link->story().refused, 0);
}

TEST(Tracker, findsTheOneThatIsNamedAndReadsPositionsToo) {
  Server server;
  const auto link = linkTo(server, "Second");
  ASSERT_TRUE(link && server.accept());
  Feeling feeling(link->device());
  ASSERT_TRUE(feeling.until([&] { server.position("First", Vec3(1, 1, 1)); server.position("Second", Vec3::Zero()); return feeling.present; }));
  EXPECT_TRUE(feeling.until([&] { server.position("First", Vec3(2, 2, 2)); server.position("Second", Vec3(0.01, 0, 0)); return std::abs(feeling.input.pose.p_WB.x() - 0.01) < 1e-7; }));
}

TEST(Tracker, aSpoiltMessageIsRefusedAndAWildOneMovesNothing) {
  Server server;
  const auto link = linkTo(server);
  ASSERT_TRUE(link && server.accept());
  Feeling feeling(link->device());
  ASSERT_TRUE(feeling.until([&] { server.transform("Probe", {}); return feeling.present; }));
  server.transform("Probe", {Vec3(0.5, 0, 0), Quat::Identity()}, true);
  ASSERT_TRUE(feeling.until([&] { return link->story().refused == 1; }));
  EXPECT_LT(feeling.input.pose.p_WB.norm(), 1e-9);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(feeling.until([&] { server.transform("Probe", {Vec3(nan, 0, 0), Quat::Identity()}); return feeling.counts().lost > 0; }));
  EXPECT_TRUE(feeling.answer.force.allFinite());
}

TEST(Tracker, aServerThatHangsUpOrFallsSilentIsNoHandAnyMore) {
  Server server;
  {
    const auto link = linkTo(server);
    ASSERT_TRUE(link && server.accept());
    Feeling feeling(link->device());
    ASSERT_TRUE(feeling.until([&] { server.transform("Probe", {}); return feeling.present; }));
    EXPECT_TRUE(feeling.until([&] { return steadyNow() - feeling.input.stamp > 5'000'000; })) << "silent for longer than trackers are";
    server.hangUp();
    EXPECT_TRUE(feeling.until([&] { return !feeling.present; }));
    EXPECT_EQ(link->story().left, 1);
  }
}

TEST(Tracker, whereNobodyListensTheAnswerIsASentence) {
  const auto link = openDevice(*deviceAddress("igtl:127.0.0.1:1"), DeviceAnchor(Quat::Identity(), {}));
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().fault, Fault::BadUsage);
}

}  // namespace
}  // namespace glenoid
