// SPDX-License-Identifier: GPL-3.0-or-later
// The real daemon, with a pseudo terminal that answers as a serial Spaceball does: no hardware, no root.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "simcore/base/Turns.h"
#include "tests/simcore/device/Feeling.h"

namespace glenoid {
namespace {

using test::Feeling;

class Spaceball {
 public:
  Spaceball() : m_folder(std::filesystem::path(GLENOID_BUILD_DIR) / ("spacenavd-" + std::to_string(getpid()))) {
    m_handle = posix_openpt(O_RDWR | O_NOCTTY);
    if (m_handle < 0 || grantpt(m_handle) != 0 || unlockpt(m_handle) != 0) return;
    termios raw{};
    tcgetattr(m_handle, &raw);
    cfmakeraw(&raw);
    tcsetattr(m_handle, TCSANOW, &raw);
    m_keep = open(ptsname(m_handle), O_RDWR | O_NOCTTY);  // else the first close of the daemon hangs it up
    std::filesystem::create_directories(m_folder / "run");
    std::ofstream(m_folder / "spnavrc") << "serial = " << ptsname(m_handle) << "\n";
    m_thread = std::thread([this] { answer(); });
    m_daemon = fork();
    if (m_daemon != 0) return;
    if (chdir(m_folder.c_str()) != 0) _exit(2);
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, 1);
    dup2(nothing, 2);
    execlp("spacenavd", "spacenavd", "-d", "-c", "spnavrc", nullptr);
    _exit(3);
  }
  ~Spaceball() {
    endDaemon();
    m_quit = true;
    if (m_thread.joinable()) m_thread.join();
    if (m_keep >= 0) close(m_keep);
    if (m_handle >= 0) close(m_handle);
    std::filesystem::remove_all(m_folder);
  }
  void endDaemon() {
    if (m_daemon <= 0) return;
    kill(m_daemon, SIGTERM);
    waitpid(std::exchange(m_daemon, 0), nullptr, 0);
  }
  std::string socket() const { return (m_folder / "run/spnav.sock").string(); }
  bool ready() const {
    for (int i = 0; i < 500; ++i) {
      if (asked && std::filesystem::exists(socket())) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
  }
  /// Displacement x, y, z and turn, as the ball's own numbers.
  void push(const std::array<int, 6>& axes) {
    std::string packet("D\0\xa0", 3);
    for (const int axis : axes) packet += {static_cast<char>(axis >> 8), static_cast<char>(axis & 255)};
    packet += '\r';
    EXPECT_EQ(write(m_handle, packet.data(), packet.size()), static_cast<ssize_t>(packet.size()));
  }
  std::atomic<bool> asked{false};

 private:
  void answer() {
    std::string heard;
    while (!m_quit) {
      pollfd wait{m_handle, POLLIN, 0};
      if (poll(&wait, 1, 50) != 1 || !(wait.revents & POLLIN)) continue;
      char bytes[100];
      const ssize_t size = read(m_handle, bytes, sizeof bytes);
      if (size <= 0) return;
      heard.append(bytes, static_cast<std::size_t>(size));
      if (heard.find("@RESET") == std::string::npos) continue;
      heard.clear();
      const std::string alive = "\r@1 Spaceball alive and well after a software reset.\r\r@2 Firmware version 2.35 created on 24-Sep-1996.\r";
      EXPECT_EQ(write(m_handle, alive.data(), alive.size()), static_cast<ssize_t>(alive.size()));
      asked = true;
    }
  }

  std::filesystem::path m_folder;
  int m_handle = -1, m_keep = -1;
  pid_t m_daemon = 0;
  std::atomic<bool> m_quit{false};
  std::thread m_thread;
};

TEST(SpaceMouse, pushingItMovesTheHandAndLettingGoStopsIt) {
  Spaceball ball;
  ASSERT_TRUE(ball.ready()) << "spacenavd is wanted";
  const auto opened = openDevice(*deviceAddress("spnav:" + ball.socket()), DeviceAnchor(Quat::Identity(), {}));
  ASSERT_TRUE(opened) << toLogLine(opened.error());
  DeviceLink& link = **opened;
  Feeling feeling(link.device());
  ASSERT_TRUE(feeling.until([&] { return feeling.present; }));
  EXPECT_FALSE(openDevice(*deviceAddress("spnav"), DeviceAnchor(Quat::Identity(), {}))) << "one a process";
  // Pushed to the right and, half as far, away from whoever sits there.
  ASSERT_TRUE(feeling.until([&] { ball.push({200, 0, 100, 0, 0, 0}); return feeling.input.pose.p_WB.x() > 0.005; }));
  const Vec3 went = feeling.input.pose.p_WB;
  EXPECT_NEAR(went.z() / went.x(), -0.5, 0.1);
  EXPECT_NEAR(went.y(), 0, 1e-6);
  ASSERT_TRUE(feeling.until([&] { ball.push({0, 0, 0, 0, 0, 0}); const Vec3 p = feeling.input.pose.p_WB; feeling.ticks(30); return (feeling.input.pose.p_WB - p).norm() < 1e-9; }));
  const Quat before = feeling.input.pose.q_WB;
  ASSERT_TRUE(feeling.until([&] { ball.push({0, 0, 0, 0, 200, 0}); return turnBetween(feeling.input.pose.q_WB, before) > 0.1; }));
  EXPECT_GT(rotationVector(feeling.input.pose.q_WB * before.conjugate()).y(), 0.09);
  // The daemon ends: the hand is gone, and there is no force.
  ball.endDaemon();
  ASSERT_TRUE(feeling.until([&] { return !feeling.present; }));
  feeling.ticks(6);
  EXPECT_TRUE(feeling.answer.force.isZero(0));
  EXPECT_EQ(link.story().left, 1);
}

TEST(SpaceMouse, withoutADaemonTheAnswerIsASentence) {
  const auto link = openDevice(*deviceAddress("spnav:/nowhere/spnav.sock"), DeviceAnchor(Quat::Identity(), {}));
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().fault, Fault::BadUsage);
  EXPECT_NE(link.error().arguments.front().find("spacenavd"), std::string::npos);
}

}  // namespace
}  // namespace glenoid
