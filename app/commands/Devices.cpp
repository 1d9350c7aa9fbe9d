// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Devices.h"

#include <algorithm>

#include "app/Resources.h"
#include "app/commands/Console.h"

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

DeviceWish deviceWish(const std::string& word) {
  const std::size_t equals = word.find('=');
  return equals == std::string::npos ? DeviceWish{"", word} : DeviceWish{word.substr(0, equals), word.substr(equals + 1)};
}

Result<HeldTools> holdTools(const std::vector<DeviceWish>& wishes, const Scenario& scenario) {
  HeldTools held;
  std::vector<DeviceAddress> addresses;
  const auto taken = [&](const std::string& tool) {
    return std::any_of(held.hands.begin(), held.hands.end(), [&](const LiveHand& hand) { return hand.tool == tool; });
  };
  // Who names a tool has it before those who take what is left.
  std::vector<DeviceWish> inTurn = wishes;
  std::stable_partition(inTurn.begin(), inTurn.end(), [](const DeviceWish& wish) { return !wish.tool.empty(); });
  for (const DeviceWish& wish : inTurn) {
    const Result<DeviceAddress> address = deviceAddress(wish.address);
    if (!address) return address.error();
    std::string tool = wish.tool;
    for (const Tool& each : scenario.tools)
      if (tool.empty() && each.link.empty() && !taken(each.id)) tool = each.id;
    if (tool.empty()) return usageError("there is no tool left for “" + wish.address + "” to hold");
    const int index = findTool(scenario, tool);
    if (index < 0 || !scenario.tools[static_cast<std::size_t>(index)].link.empty()) return usageError("“" + tool + "” is no tool that a hand holds in this scenario");
    if (taken(tool)) return usageError("two devices want to hold “" + tool + "”");
    addresses.push_back(*address);
    held.hands.push_back({nullptr, address->word, tool});
  }
  // Whoever looks on sits before the screen: what he moves to the right goes to the right of the scenario's own camera.
  const Camera camera = scenario.cameras.empty() ? Camera() : scenario.cameras.front();
  const Quat axes = deviceAxes(camera.eye_W, camera.target_W, camera.up_W);
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    const Tool& tool = scenario.tools[static_cast<std::size_t>(findTool(scenario, held.hands[i].tool))];
    Result<std::unique_ptr<DeviceLink>> link = openDevice(addresses[i], DeviceAnchor(axes, tool.home));
    if (!link) return link.error();
    held.links.push_back(std::move(*link));
    held.hands[i].device = &held.links.back()->device();
  }
  return held;
}

}  // namespace glenoid
