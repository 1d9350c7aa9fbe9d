// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

#include "app/Resources.h"
#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/Devices.h"
#include "simcore/file/JsonObject.h"
#include "simcore/haptic/HapticThread.h"

namespace glenoid {
namespace {

/// What was found at an address.
struct Reach {
  bool open = false, heard = false;
  DeviceStory story;
  std::string trouble;
};

Reach tryToReach(const DeviceAddress& address, double seconds) {
  Reach reach;
  const Result<std::unique_ptr<DeviceLink>> link = openDevice(address, DeviceAnchor(Quat::Identity(), {}));
  if (!link) {
    reach.trouble = link.error().arguments.front();
    return reach;
  }
  reach.open = true;
  HapticDevice& device = (*link)->device();
  for (int tick = 0; tick < static_cast<int>(1e3 * seconds) && !reach.heard; ++tick) {
    ToolInput input;
    reach.heard = device.read(steadyNow(), input);
    device.write(Vec3::Zero(), Vec3::Zero());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  reach.story = (*link)->story();
  return reach;
}

const char* whatItIs(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::Bridge: return "a program of one's own, by datagrams on this machine";
    case DeviceKind::Haply: return "Haply Inverse3 by its Inverse Service";
    case DeviceKind::SpaceMouse: return "3D mouse by spacenavd";
    case DeviceKind::Tracker: return "tracker by OpenIGTLink";
  }
  return "";
}

Result<Done> listDevices(const std::vector<std::string>& words, double seconds, bool asJson) {
  const auto profiles = readDeviceProfiles(resourceRoot() + "/devices/devices.json");
  if (!profiles) return profiles.error();
  std::vector<DeviceAddress> addresses;
  for (const std::string& word : words) {
    const Result<DeviceAddress> address = deviceAddress(word);
    if (!address) return address.error();
    addresses.push_back(*address);
  }
  JsonValue reached = JsonValue::array(), known = JsonValue::array();
  if (!asJson) std::printf("Devices that may hold a tool (glenoid run SCENARIO --realtime --device WORD):\n");
  for (const DeviceAddress& address : addresses) {
    const Reach reach = tryToReach(address, seconds);
    const char* state = !reach.open ? "not there" : reach.heard ? "there" : address.kind == DeviceKind::Bridge ? "waits for a program" : "silent";
    if (asJson)
      reached.append(jsonObject({{"device", address.word}, {"what", whatItIs(address.kind)}, {"forces", showsForces(address.kind)}, {"state", state},
                                 {"name", reach.story.name}, {"profile", profileOf(address.kind)}, {"trouble", reach.trouble}}));
    else
      std::printf("  %-14s %s, %s: %s%s\n", address.word.c_str(), whatItIs(address.kind), showsForces(address.kind) ? "with forces" : "without forces", state,
                  reach.heard && !reach.story.name.empty() ? (", " + reach.story.name).c_str() : "");
  }
  if (!asJson) std::printf("Profiles that forces are made for (--device-profile ID):\n");
  for (const DeviceProfile& profile : *profiles) {
    if (asJson)
      known.append(jsonObject({{"id", profile.id}, {"name", profile.name}, {"source", profile.source}, {"damping", profile.damping}, {"forceMax", profile.forceMax}}));
    else
      std::printf("  %-14s %s: damping %.3g N·s/m, %.3g N at most\n", profile.id.c_str(), profile.name.c_str(), profile.damping, profile.forceMax);
  }
  if (asJson) std::fputs(toText(jsonObject({{"devices", std::move(reached)}, {"profiles", std::move(known)}})).c_str(), stdout);
  return Done{};
}

}  // namespace

void addDevicesCommand(CLI::App& app, int& status) {
  struct Wishes {
    std::vector<std::string> words;
    double seconds = 0.3;
    bool json = false;
  };
  auto wishes = std::make_shared<Wishes>();
  CLI::App* command = app.add_subcommand("devices", "List the devices that may hold a tool, and which of them are there now");
  command->add_option("DEVICE", wishes->words, "Which, such as haply:HOST:PORT; without it each kind at its usual place");
  command->add_option("--seconds", wishes->seconds, "How long each may take to say something")->check(CLI::Range(0.0, 60.0));
  command->add_flag("--json", wishes->json, "Print the list as JSON");
  command->callback([wishes, &status] {
    if (wishes->words.empty()) wishes->words = {"bridge", "haply", "spnav", "igtl"};
    const Result<Done> done = listDevices(wishes->words, wishes->seconds, wishes->json);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
