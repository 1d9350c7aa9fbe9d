// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/haptic/DeviceProfile.h"

namespace glenoid {

/// What a bench and a run by recording are felt with when nobody says otherwise.
inline constexpr const char* kReferenceDevice = "reference";

/// The profile of a device: an id of what ships, or ID@FILE for one of a file of one's own. Fails as readDeviceProfiles does
/// and with UnknownId.
Result<DeviceProfile> deviceNamed(const std::string& word);

}  // namespace glenoid
