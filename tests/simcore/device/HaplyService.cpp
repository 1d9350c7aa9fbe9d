// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/device/HaplyService.h"

#include <libwebsockets.h>

#include <algorithm>

#include "simcore/file/Json.h"
#include "simcore/haptic/HapticThread.h"

namespace glenoid::test {

struct HaplyServiceCalls {
  static int called(lws* wsi, lws_callback_reasons reason, void*, void* in, std::size_t length) {
    auto* self = static_cast<HaplyService*>(lws_context_user(lws_get_context(wsi)));
    if (reason == LWS_CALLBACK_ESTABLISHED) {
      self->m_client = wsi;
      self->m_out.push_back({0, self->state(true)});
      lws_callback_on_writable(wsi);
    } else if (reason == LWS_CALLBACK_CLOSED) {
      self->m_client = nullptr;
      self->m_out.clear();
    } else if (reason == LWS_CALLBACK_RECEIVE) {
      self->m_text.append(static_cast<const char*>(in), length);
      if (lws_is_final_fragment(wsi) && lws_remaining_packet_payload(wsi) == 0) {
        self->take(self->m_text);
        self->m_text.clear();
      }
    } else if (reason == LWS_CALLBACK_SERVER_WRITEABLE && !self->m_out.empty() && self->m_out.front().due <= steadyNow()) {
      const std::string text = self->m_out.front().text;
      self->m_out.pop_front();
      self->m_bytes.resize(LWS_PRE + text.size());
      std::copy(text.begin(), text.end(), self->m_bytes.begin() + LWS_PRE);
      lws_write(wsi, self->m_bytes.data() + LWS_PRE, text.size(), LWS_WRITE_TEXT);
      if (text.find("event") == std::string::npos) ++self->answered;
      if (!self->m_out.empty()) lws_callback_on_writable(wsi);
    }
    return 0;
  }
};

HaplyService::HaplyService(const char* dialect, int port) : m_dialect(dialect) {
  lws_set_log_level(0, nullptr);
  static const lws_protocols protocols[] = {{"http-only", &HaplyServiceCalls::called, 0, 1 << 16, 0, nullptr, 0}, {nullptr, nullptr, 0, 0, 0, nullptr, 0}};
  lws_context_creation_info info{};
  info.port = port;
  info.iface = "lo";
  info.protocols = protocols;
  info.user = this;
  m_context = lws_create_context(&info);
  if (!m_context) return;
  m_port = lws_get_vhost_listen_port(lws_get_vhost_by_name(m_context, "default"));
  m_thread = std::thread([this] { run(); });
}

HaplyService::~HaplyService() {
  m_quit = true;
  if (m_thread.joinable()) m_thread.join();
  if (m_context) lws_context_destroy(m_context);
}

void HaplyService::run() {
  while (!m_quit) {
    lws_service(m_context, -1);
    if (m_client && !m_out.empty() && m_out.front().due <= steadyNow()) lws_callback_on_writable(m_client);
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

std::string HaplyService::state(bool inventory) const {
  if (!inventory && broken == 2) return "{\"inverse3\":[{\"device_id\":\"i3\",\"state\":{\"cursor_position\":{\"x\":nan,\"y\":0,\"z\":0}}}]}";
  if (!plugged) return "{\"inverse3\":[],\"verse_grip\":[]}";
  const std::string place = broken == 1 ? "null" : std::to_string(x.load());
  const std::string session = inventory ? "\"session\":{\"id\":1}," : "";
  return "{" + session + "\"inverse3\":[{\"device_id\":\"i3\",\"config\":{},\"status\":{},\"state\":{\"cursor_position\":{\"x\":" + place +
         ",\"y\":0.1,\"z\":0.2},\"cursor_velocity\":{\"x\":0,\"y\":0,\"z\":0},\"current_cursor_force\":{\"x\":" + std::to_string(force[0].load()) + ",\"y\":" +
         std::to_string(force[1].load()) + ",\"z\":" + std::to_string(force[2].load()) + "}}}],\"wireless_verse_grip\":[]}";
}

void HaplyService::take(const std::string& text) {
  ++received;
  outstandingMost = std::max(outstandingMost.load(), static_cast<int>(m_out.size()) + 1);
  const auto json = parseJson(text, "client");
  if (json) {
    sessions += (*json)["session"].isObject();
    const JsonValue& one = (*json)["inverse3"][0];
    const JsonValue& wanted = one["commands"]["set_cursor_force"][m_dialect];
    if (one["device_id"].text() == "i3" && wanted.isObject()) force[0] = wanted["x"].number(), force[1] = wanted["y"].number(), force[2] = wanted["z"].number();
  }
  const std::int64_t due = steadyNow() + 1'000'000LL * lagMs;
  if (events) m_out.push_back({due, "{\"event\":{\"type\":\"battery\",\"level\":0.4}}"});
  m_out.push_back({due, state(false)});
  if (m_client) lws_callback_on_writable(m_client);
}

}  // namespace glenoid::test
