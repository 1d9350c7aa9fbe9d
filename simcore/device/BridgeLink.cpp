// SPDX-License-Identifier: GPL-3.0-or-later
// The bridge needs no thread of its own: a datagram is read and written without waiting, so the haptic thread does both itself and a
// force is no older than a tick.
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>

#include "simcore/device/BridgePacket.h"
#include "simcore/device/Links.h"
#include "simcore/tool/PoseSpring.h"

namespace glenoid {

namespace {

constexpr std::int64_t kGone = 500'000'000;  // ns without a word: whoever spoke has gone, and another one may speak

class BridgeLink : public DeviceLink, private HapticDevice {
 public:
  BridgeLink(int socket, const DeviceAnchor& anchor) : m_socket(socket), m_anchor(anchor) {}
  ~BridgeLink() override { ::close(m_socket); }

  HapticDevice& device() override { return *this; }
  DeviceStory story() const override {
    DeviceStory story;
    story.name = "bridge";
    story.present = m_present.load();
    story.words = m_words.load();
    story.refused = m_refused.load();
    story.left = m_left.load();
    return story;
  }

 private:
  bool read(std::int64_t now, ToolInput& input) noexcept override {
    unsigned char bytes[256];
    sockaddr_in from{};
    for (int n = 0; n < 64; ++n) {  // a flood does not keep a tick
      socklen_t length = sizeof from;
      const ssize_t size = recvfrom(m_socket, bytes, sizeof bytes, MSG_DONTWAIT, reinterpret_cast<sockaddr*>(&from), &length);
      if (size < 0) break;
      const auto word = bridgePose({bytes, static_cast<std::size_t>(size)});
      const bool other = m_there && (from.sin_port != m_peer.sin_port || from.sin_addr.s_addr != m_peer.sin_addr.s_addr);
      const bool stale = m_there && static_cast<std::int32_t>(word ? word->sequence - m_sequence : 0) < 0;
      if (!word || other || stale || !isHandPose(word->pose)) {
        m_refused.fetch_add(1, std::memory_order_relaxed);
        if (!word || other || stale) continue;
      }
      m_peer = from;
      m_sequence = word->sequence;
      m_word.pose = m_anchor.toWorld(word->pose);
      m_word.grip = word->grip;
      m_word.buttons = word->buttons;
      m_word.stamp = now;
      m_there = m_asked = true;
      m_words.fetch_add(1, std::memory_order_relaxed);
    }
    if (m_there && now - m_word.stamp > kGone) {
      m_there = m_asked = false;
      m_anchor.lift();
      m_left.fetch_add(1, std::memory_order_relaxed);
    }
    m_present.store(m_there, std::memory_order_relaxed);
    if (m_there) input = m_word;
    return m_there;
  }

  void write(const Vec3& force, const Vec3& torque) noexcept override {
    if (!m_asked) return;
    m_asked = false;
    const auto bytes = bytesOf(BridgeForce{m_sequence, {m_anchor.toDevice(force), m_anchor.toDevice(torque)}, !force.isZero(0)});
    (void)sendto(m_socket, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&m_peer), sizeof m_peer);
  }

  int m_socket;
  DeviceAnchor m_anchor;
  sockaddr_in m_peer{};
  ToolInput m_word;
  std::uint32_t m_sequence = 0;
  bool m_there = false, m_asked = false;
  std::atomic<bool> m_present{false};
  std::atomic<long> m_words{0}, m_refused{0}, m_left{0};
};

}  // namespace

Result<std::unique_ptr<DeviceLink>> openBridge(const DeviceAddress& address, const DeviceAnchor& anchor) {
  const int handle = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  here.sin_port = htons(static_cast<std::uint16_t>(address.port));
  if (handle < 0 || bind(handle, reinterpret_cast<const sockaddr*>(&here), sizeof here) != 0) {
    if (handle >= 0) ::close(handle);
    return Error{Fault::BadUsage, {}, {"“" + address.word + "”: the port " + std::to_string(address.port) + " of this machine is taken; end the program that "
                 "has it, or name another one as bridge:PORT"}, "bridge"};
  }
  return std::unique_ptr<DeviceLink>(new BridgeLink(handle, anchor));
}

}  // namespace glenoid
