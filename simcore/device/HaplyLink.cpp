// SPDX-License-Identifier: GPL-3.0-or-later
// The service answers each message with one state, so what is sent sets the clock: a command a millisecond, never a second one before the
// first is answered. All JSON and all memory stay in this thread.
#include <libwebsockets.h>
#include <poll.h>
#include <time.h>

#include <algorithm>

#include "simcore/device/HaplyWords.h"
#include "simcore/device/IoThread.h"
#include "simcore/device/Links.h"
#include "simcore/haptic/HapticThread.h"
#include "simcore/tool/PoseSpring.h"

namespace glenoid {

namespace {

constexpr std::int64_t kPeriod = 1'000'000;          // ns
constexpr std::int64_t kTryAgain = 500'000'000;      // ns between two attempts to connect
constexpr std::int64_t kUnanswered = 500'000'000;    // ns after which a service that does not answer is asked again
constexpr double kFelt = 0.05;                       // N: a force that a service cannot fail to report
constexpr int kUnheard = 50;                         // answers without such a force, after which the other dialect is tried

class HaplyLink : public DeviceLink {
 public:
  HaplyLink(const DeviceAddress& address, const DeviceAnchor& anchor) : m_address(address), m_port(anchor, 0) {
    m_io.start([this] { run(); });
  }
  ~HaplyLink() override { m_io.stop(); }
  HapticDevice& device() override { return m_port; }
  DeviceStory story() const override { return m_io.story(); }

 private:
  static int called(lws* wsi, lws_callback_reasons reason, void*, void* in, std::size_t length);
  void run();
  void connect(lws_context* context);
  void heard(std::string_view text, bool whole);
  void answered(const HaplyWord& word);
  void send(lws* wsi);
  void gone();

  DeviceAddress m_address;
  DevicePort m_port;
  lws* m_wsi = nullptr;
  bool m_open = false, m_greeted = false, m_first = true, m_waiting = false, m_here = false;  // greeted: it has said what there is
  std::int64_t m_sentAt = 0, m_tryAt = 0;
  std::string m_text, m_device;
  std::vector<unsigned char> m_out;
  HaplyDialect m_dialect = HaplyDialect::Values;
  int m_unheard = 0;
  Vec3 m_sent = Vec3::Zero(), m_sentBefore = Vec3::Zero();
  double m_tripMs = 0;
  IoThread m_io;  // last: it ends before what it uses
};

int HaplyLink::called(lws* wsi, lws_callback_reasons reason, void*, void* in, std::size_t length) {
  auto* self = static_cast<HaplyLink*>(lws_context_user(lws_get_context(wsi)));
  switch (reason) {
    case LWS_CALLBACK_CLIENT_ESTABLISHED:
      self->m_open = self->m_first = true;
      self->m_waiting = self->m_greeted = false;
      break;
    case LWS_CALLBACK_CLIENT_RECEIVE:
      self->heard({static_cast<const char*>(in), length}, lws_is_final_fragment(wsi) && lws_remaining_packet_payload(wsi) == 0);
      break;
    case LWS_CALLBACK_CLIENT_WRITEABLE: self->send(wsi); break;
    case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
    case LWS_CALLBACK_CLIENT_CLOSED: self->gone(); break;
    default: break;
  }
  return 0;
}

void HaplyLink::gone() {
  m_wsi = nullptr;
  m_open = false;
  m_tryAt = steadyNow() + kTryAgain;
  m_text.clear();
  if (!std::exchange(m_here, false)) return;
  m_port.leave();
  m_io.tell([](DeviceStory& story) { story.present = false, ++story.left; });
}

void HaplyLink::connect(lws_context* context) {
  lws_client_connect_info info{};
  info.context = context;
  info.address = info.host = info.origin = m_address.host.c_str();
  info.port = m_address.port;
  info.path = "/";
  info.local_protocol_name = "glenoid";
  info.pwsi = &m_wsi;
  m_tryAt = steadyNow() + kTryAgain;
  if (!lws_client_connect_via_info(&info)) m_wsi = nullptr;
}

void HaplyLink::heard(std::string_view text, bool whole) {
  constexpr std::size_t kMost = 1 << 20;
  if (m_text.size() + text.size() <= kMost) m_text.append(text);
  if (!whole) return;
  const std::optional<HaplyWord> word = haplyWord(m_text, m_device);
  m_text.clear();
  if (word && word->isState) return answered(*word);
  if (!word) m_io.tell([](DeviceStory& story) { ++story.refused; });  // an event is no fault, and no answer
}

void HaplyLink::answered(const HaplyWord& word) {
  const std::int64_t now = steadyNow();
  const double trip = 1e-6 * static_cast<double>(now - m_sentAt);
  m_greeted = true;
  if (std::exchange(m_waiting, false)) m_tripMs += (trip - m_tripMs) / 64;
  if (word.device.empty()) {  // unplugged, or none yet
    if (std::exchange(m_here, false)) {
      m_port.leave();
      m_io.tell([](DeviceStory& story) { story.present = false, ++story.left; });
    }
    return;
  }
  m_device = word.device;
  if (!word.hasPose) return;  // an inventory
  if (word.force && m_sentBefore.norm() > kFelt) {
    m_unheard = word.force->norm() > 0 ? 0 : m_unheard + 1;
    if (m_unheard > kUnheard) m_unheard = 0, m_dialect = m_dialect == HaplyDialect::Values ? HaplyDialect::Vector : HaplyDialect::Values;
  }
  ToolInput input;
  input.pose = word.pose;
  input.buttons = word.buttons;
  input.stamp = now;
  m_port.say(input);
  m_here = true;
  m_io.tell([&](DeviceStory& story) {
    story.present = true;
    story.name = m_device;
    ++story.words;
    story.refused += !isHandPose(word.pose);
    story.roundTripMs = m_tripMs;
  });
}

void HaplyLink::send(lws* wsi) {
  if (m_waiting || !m_greeted) return;
  m_sentBefore = m_sent;
  m_sent = m_io.quit() || !m_here ? Vec3(Vec3::Zero()) : m_port.force().force;
  const std::string text = haplyCommand(m_device, m_sent, m_dialect, m_first);
  m_out.resize(LWS_PRE + text.size());
  std::copy(text.begin(), text.end(), m_out.begin() + LWS_PRE);
  if (lws_write(wsi, m_out.data() + LWS_PRE, text.size(), LWS_WRITE_TEXT) < static_cast<int>(text.size())) return;
  m_first = false;
  m_waiting = true;
  m_sentAt = steadyNow();
}

void HaplyLink::run() {
  lws_set_log_level(0, nullptr);
  static const lws_protocols protocols[] = {{"glenoid", &HaplyLink::called, 0, 1 << 16, 0, nullptr, 0}, {nullptr, nullptr, 0, 0, 0, nullptr, 0}};
  lws_context_creation_info info{};
  info.port = CONTEXT_PORT_NO_LISTEN;
  info.protocols = protocols;
  info.user = this;
  lws_context* context = lws_create_context(&info);
  std::int64_t due = steadyNow();
  int farewell = 0;
  while (context) {
    const std::int64_t now = steadyNow();
    if (now >= due) {
      due += kPeriod * (1 + (now - due) / kPeriod);
      if (m_io.quit() && (!m_open || ++farewell > 20 || (farewell > 1 && m_sent.isZero(0) && !m_waiting))) break;
      if (!m_wsi && now >= m_tryAt) connect(context);
      if (m_waiting && now - m_sentAt > kUnanswered) m_waiting = false;
      if (m_open && !m_waiting && m_greeted) lws_callback_on_writable(m_wsi);
    }
    lws_service(context, -1);
    const std::int64_t left = due - steadyNow();
    if (left <= 0) continue;
    pollfd wait{m_wsi && m_open ? static_cast<int>(lws_get_socket_fd(m_wsi)) : -1, POLLIN, 0};
    const timespec time{0, static_cast<long>(std::min<std::int64_t>(left, kPeriod))};
    ppoll(&wait, 1, &time, nullptr);
    if (wait.revents) lws_service(context, -1);
  }
  if (context) lws_context_destroy(context);
}

}  // namespace

Result<std::unique_ptr<DeviceLink>> openHaply(const DeviceAddress& address, const DeviceAnchor& anchor) {
  if (!somebodyListens(address.host, address.port, 1)) return nobodyThere(address, "start the Haply Inverse Service, or name where it runs as haply:HOST:PORT");
  return std::unique_ptr<DeviceLink>(new HaplyLink(address, anchor));
}

}  // namespace glenoid
