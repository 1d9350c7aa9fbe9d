// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/device/DeviceLink.h"

#include <charconv>
#include <iterator>

#include "simcore/device/Links.h"

namespace glenoid {

namespace {

struct Kind {
  DeviceKind kind;
  const char *word, *profile, *host;
  int port;
};
constexpr Kind kKinds[] = {{DeviceKind::Bridge, "bridge", "unknown", "127.0.0.1", kBridgePort},
                           {DeviceKind::Haply, "haply", "inverse3", "127.0.0.1", 10001},
                           {DeviceKind::SpaceMouse, "spnav", "unknown", "", 0},
                           {DeviceKind::Tracker, "igtl", "unknown", "127.0.0.1", 18944}};

const Kind* kindNamed(const std::string& word) {
  for (const Kind& kind : kKinds)
    if (word == kind.word) return &kind;
  return nullptr;
}

const Kind& kindOf(DeviceKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

}  // namespace

bool namesDevice(const std::string& word) { return kindNamed(word.substr(0, word.find(':'))) != nullptr; }
const char* deviceWord(DeviceKind kind) { return kindOf(kind).word; }
const char* profileOf(DeviceKind kind) { return kindOf(kind).profile; }

Result<DeviceAddress> deviceAddress(const std::string& word) {
  const auto wrong = [&](const std::string& what) { return Error{Fault::BadUsage, {}, {"“" + word + "” is no device: " + what}, "device address"}; };
  const std::size_t colon = word.find(':');
  const Kind* kind = kindNamed(word.substr(0, colon));
  if (!kind) return wrong("it begins with bridge, haply, spnav or igtl");
  DeviceAddress address{kind->kind, word, kind->host, kind->port, ""};
  if (colon == std::string::npos) return address;
  std::string rest = word.substr(colon + 1);
  if (rest.empty()) return wrong("an address follows the colon");
  if (kind->kind == DeviceKind::SpaceMouse) {
    address.host = rest;
    return address;
  }
  if (kind->kind == DeviceKind::Tracker)
    if (const std::size_t slash = rest.find('/'); slash != std::string::npos) {
      address.name = rest.substr(slash + 1);
      rest.resize(slash);
    }
  const std::size_t last = rest.rfind(':');
  std::string port = last == std::string::npos ? rest : rest.substr(last + 1);
  const bool number = !port.empty() && port.find_first_not_of("0123456789") == std::string::npos;
  if (last != std::string::npos) address.host = rest.substr(0, last);
  else if (!number) address.host = rest, port.clear();
  if (kind->kind == DeviceKind::Bridge && (last != std::string::npos || !number)) return wrong("a bridge has a port of this machine and no host");
  if (address.host.empty()) return wrong("a host is wanted before the port");
  if (port.empty()) return last == std::string::npos ? Result<DeviceAddress>(address) : wrong("a port is a number from 1 to 65535");
  const auto [end, fault] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (fault != std::errc() || end != port.data() + port.size() || address.port < 1 || address.port > 65535)
    return wrong("a port is a number from 1 to 65535");
  return address;
}

Result<std::unique_ptr<DeviceLink>> openDevice(const DeviceAddress& address, const DeviceAnchor& anchor) {
  switch (address.kind) {
    case DeviceKind::Bridge: return openBridge(address, anchor);
    case DeviceKind::Haply: return openHaply(address, anchor);
    case DeviceKind::SpaceMouse: return openSpaceMouse(address, anchor);
    case DeviceKind::Tracker: return openTracker(address, anchor);
  }
  return Error{Fault::Internal, {}, {}, "device kind"};
}

}  // namespace glenoid
