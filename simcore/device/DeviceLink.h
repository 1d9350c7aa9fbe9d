// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/device/DeviceFrame.h"
#include "simcore/haptic/HapticDevice.h"

namespace glenoid {

/// How a device is spoken to.
enum class DeviceKind {
  Bridge,      ///< a program of one's own, by datagrams on this machine (README.md)
  Haply,       ///< Haply Inverse Service, WebSocket
  SpaceMouse,  ///< a 3D mouse by the daemon spacenavd
  Tracker,     ///< OpenIGTLink
};

/// What was asked for: "haply", "haply:HOST:PORT", "spnav", "spnav:SOCKET", "bridge", "bridge:PORT", "igtl:HOST:PORT", "igtl:HOST:PORT/NAME".
struct DeviceAddress {
  DeviceKind kind = DeviceKind::Bridge;
  std::string word;       ///< as it was asked for
  std::string host;       ///< or path of a socket
  int port = 0;
  std::string name;       ///< of one device among those behind the address; empty: the first
};

/// Whether a word begins like an address.
bool namesDevice(const std::string& word);
/// Fails with BadUsage.
Result<DeviceAddress> deviceAddress(const std::string& word);
/// The word of a kind: "bridge", "haply", "spnav", "igtl".
const char* deviceWord(DeviceKind kind);
/// Whether the kind can show forces.
constexpr bool showsForces(DeviceKind kind) { return kind == DeviceKind::Bridge || kind == DeviceKind::Haply; }
/// Id of the profile that its gains come from where nobody names one.
const char* profileOf(DeviceKind kind);

/// What has been heard of a device so far.
struct DeviceStory {
  std::string name;          ///< what it calls itself; may be empty
  bool present = false;      ///< it is there now
  long words = 0;            ///< poses heard
  long refused = 0;          ///< messages that were none, or whose numbers were no pose
  long left = 0;             ///< times it went away
  double roundTripMs = 0;    ///< from a message to its answer, mean; 0 where nobody answers
};

/// A device with all that is needed to talk with it. Ends its threads when it is destroyed, after a last force of zero.
class DeviceLink {
 public:
  virtual ~DeviceLink() = default;
  virtual HapticDevice& device() = 0;
  virtual DeviceStory story() const = 0;  ///< any thread but the haptic one
};

/// Begins to talk. Fails with BadUsage where nobody is there to talk with and nobody can be waited for: no service, no daemon, no
/// server, or a port that is taken. What stops talking later is told by story() and by the device's read().
Result<std::unique_ptr<DeviceLink>> openDevice(const DeviceAddress& address, const DeviceAnchor& anchor);

}  // namespace glenoid
