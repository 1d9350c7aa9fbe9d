// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "simcore/device/DeviceLink.h"
#include "simcore/haptic/DeviceProfile.h"
#include "simcore/live/RunHaptics.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// What a bench and a run by recording are felt with when nobody says otherwise.
inline constexpr const char* kReferenceDevice = "reference";

/// The profile of a device: an id of what ships, or ID@FILE for one of a file of one's own. Fails as readDeviceProfiles does
/// and with UnknownId.
Result<DeviceProfile> deviceNamed(const std::string& word);

/// A device that somebody wants to hold a tool, from "ADDRESS" or "TOOL=ADDRESS".
struct DeviceWish {
  std::string tool;     ///< empty: the first that is free
  std::string address;
};
DeviceWish deviceWish(const std::string& word);

/// Devices that hold the tools of a run, and what the run needs to know of them.
struct HeldTools {
  std::vector<std::unique_ptr<DeviceLink>> links;
  std::vector<LiveHand> hands;
};

/// Opens a device for each wish: the first holds the first tool that a hand holds, and so on. Fails as openDevice does and with
/// BadUsage.
Result<HeldTools> holdTools(const std::vector<DeviceWish>& wishes, const Scenario& scenario);

}  // namespace glenoid
