// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/device/DeviceLink.h"

/// The kinds of link, each in a file of its own. Used by openDevice.
namespace glenoid {

inline constexpr int kBridgePort = 9310;

Result<std::unique_ptr<DeviceLink>> openBridge(const DeviceAddress& address, const DeviceAnchor& anchor);
Result<std::unique_ptr<DeviceLink>> openHaply(const DeviceAddress& address, const DeviceAnchor& anchor);
Result<std::unique_ptr<DeviceLink>> openSpaceMouse(const DeviceAddress& address, const DeviceAnchor& anchor);
Result<std::unique_ptr<DeviceLink>> openTracker(const DeviceAddress& address, const DeviceAnchor& anchor);

/// Whether somebody listens at a TCP address, within `seconds`.
bool somebodyListens(const std::string& host, int port, double seconds);

/// "Nobody answers …", with what to do.
Error nobodyThere(const DeviceAddress& address, const std::string& remedy);

}  // namespace glenoid
