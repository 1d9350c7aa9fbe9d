// SPDX-License-Identifier: GPL-3.0-or-later
// A 3D mouse says how far its cap is pushed, not where it is: that is how fast the hand goes. It says nothing while nothing changes.
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>

#include "simcore/base/Turns.h"
#include "simcore/device/DevicePort.h"
#include "simcore/device/IoThread.h"
#include "simcore/device/Links.h"
#include "simcore/haptic/HapticThread.h"

// Last: it brings the macros of Xlib, which Eigen does not bear.
#include <spnav.h>

namespace glenoid {

namespace {

constexpr double kFull = 350;        // what the daemon says of a cap that is pushed as far as it goes
constexpr double kSpeed = 0.08;      // m/s then
constexpr double kTurnSpeed = 1.2;   // rad/s
constexpr int kTickMs = 4;

std::atomic<bool> inUse{false};  // libspnav knows one connection a process

class SpaceMouseLink : public DeviceLink {
 public:
  explicit SpaceMouseLink(const DeviceAnchor& anchor) : m_port(anchor, 0.1) {
    m_io.tell([](DeviceStory& story) { story.name = "spacenavd"; });
    m_io.start([this] { run(); });
  }
  ~SpaceMouseLink() override {
    m_io.stop();
    spnav_close();
    inUse = false;
  }
  HapticDevice& device() override { return m_port; }
  DeviceStory story() const override { return m_io.story(); }

 private:
  void run();
  /// The daemon's x is to the right, y up and z away from whoever sits before it, and turns are about these with the third turned round, as
  /// in the library's own spnav_posrot_moveobj.
  void pushed(const spnav_event_motion& motion) {
    const auto share = [](int value) { return std::clamp(value / kFull, -1.5, 1.5); };
    m_velocity = kSpeed * Vec3(share(motion.x), share(motion.y), -share(motion.z));
    m_turning = kTurnSpeed * Vec3(share(motion.rx), share(motion.ry), -share(motion.rz));
  }

  DevicePort m_port;
  Vec3 m_velocity = Vec3::Zero(), m_turning = Vec3::Zero();
  ToolInput m_word;
  IoThread m_io;
};

void SpaceMouseLink::run() {
  std::int64_t last = steadyNow();
  const int handle = spnav_fd();
  while (!m_io.quit()) {
    pollfd wait{handle, POLLIN, 0};
    poll(&wait, 1, kTickMs);
    char probe = 0;
    const bool ended = (wait.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0 ||
                       ((wait.revents & POLLIN) != 0 && recv(handle, &probe, 1, MSG_PEEK | MSG_DONTWAIT) == 0);
    if (ended) {  // the daemon has ended; libspnav would wait for it for ever
      m_port.leave();
      m_io.tell([](DeviceStory& story) { story.present = false, ++story.left; });
      return;
    }
    spnav_event event;
    while ((wait.revents & POLLIN) != 0 && spnav_poll_event(&event) != 0) {
      if (event.type == SPNAV_EVENT_MOTION) pushed(event.motion);
      else if (event.type == SPNAV_EVENT_BUTTON && event.button.bnum >= 0 && event.button.bnum < 32)
        m_word.buttons = event.button.press ? m_word.buttons | 1u << event.button.bnum : m_word.buttons & ~(1u << event.button.bnum);
      else if (event.type == SPNAV_EVENT_DEV && event.dev.op == SPNAV_DEV_RM) m_velocity.setZero(), m_turning.setZero();
    }
    const std::int64_t now = steadyNow();
    const double passed = std::min(0.05, 1e-9 * static_cast<double>(now - last));
    last = now;
    m_word.pose.p_WB += passed * m_velocity;
    m_word.pose.q_WB = (turnBy(passed * m_turning) * m_word.pose.q_WB).normalized();
    m_word.stamp = now;
    m_port.say(m_word);
    m_io.tell([](DeviceStory& story) { story.present = true, ++story.words; });
  }
}

}  // namespace

Result<std::unique_ptr<DeviceLink>> openSpaceMouse(const DeviceAddress& address, const DeviceAnchor& anchor) {
  if (inUse.exchange(true)) return Error{Fault::BadUsage, {}, {"“" + address.word + "”: one 3D mouse holds a tool already, and there is one in a run"}, "spnav"};
  if (!address.host.empty()) setenv("SPNAV_SOCKET", address.host.c_str(), 1);
  struct stat there{};
  const bool wrongPath = !address.host.empty() && stat(address.host.c_str(), &there) != 0;  // libspnav would fall back on another one
  if (wrongPath || spnav_open() == -1) {
    inUse = false;
    return nobodyThere(address, "start spacenavd, or name its socket as spnav:PATH");
  }
  return std::unique_ptr<DeviceLink>(new SpaceMouseLink(anchor));
}

}  // namespace glenoid
