// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Devices.h"

#include "app/Resources.h"

namespace glenoid {

Result<DeviceProfile> deviceNamed(const std::string& word) {
  const std::size_t at = word.find('@');
  const std::string id = word.substr(0, at);
  const std::string path = at == std::string::npos ? resourceRoot() + "/devices/devices.json" : word.substr(at + 1);
  const auto devices = readDeviceProfiles(path);
  if (!devices) return devices.error();
  for (const DeviceProfile& device : *devices)
    if (device.id == id) return device;
  return Error{Fault::UnknownId, {path, "/devices", "", {}}, {id, "device"}, "device profile"};
}

}  // namespace glenoid
