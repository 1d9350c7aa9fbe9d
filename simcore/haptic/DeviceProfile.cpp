// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/DeviceProfile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/file/Json.h"

namespace glenoid {

double dampingNeeded(double stiffness, double damping, double period, double delay) {
  const double n = delay / period;
  double most = stiffness * (period / 2 + delay) - damping;  // θ → 0
  constexpr int kSteps = 20000;  // cos((n+1)θ) turns n + 1 times at most; far finer than that
  for (int i = 1; i <= kSteps; ++i) {
    const double theta = std::numbers::pi * i / kSteps;
    most = std::max(most, stiffness * period / 2 * std::sin((n + 0.5) * theta) / std::sin(theta / 2) - damping * std::cos((n + 1) * theta));
  }
  return most;
}

double dampingEnough(double stiffness, double damping, double period, double delay) {
  return stiffness * (period / 2 + delay) + std::abs(damping);
}

CouplingGains gainsFor(const DeviceProfile& device, double wishedStiffness, double rate, double addedDelay) {
  constexpr double kDamperShare = 0.1;
  const double reach = 0.5 / rate + device.delay + addedDelay;
  CouplingGains gains;
  gains.bound = device.damping / reach;
  gains.damping = kDamperShare * device.damping;
  double most = (1 - kDamperShare) * gains.bound;
  GainLimit limit = GainLimit::Damping;
  if (device.friction > 0 && device.resolution > 0)
    if (const double steps = 2 * device.friction / device.resolution; steps < gains.bound) {
      gains.bound = steps;
      if (steps < most) most = steps, limit = GainLimit::Resolution;
    }
  gains.stiffness = std::min(wishedStiffness, most);
  gains.limit = wishedStiffness > most ? limit : GainLimit::Wish;
  return gains;
}

DeviceProfile unknownDevice() {
  DeviceProfile device;
  device.id = "unknown";
  device.name = "Unknown device";
  device.source = "assumed";
  device.damping = 0.1;
  device.forceMax = 3;
  device.slewMax = 3000;
  return device;
}

namespace {

struct NumberMember {
  const char* key;
  double DeviceProfile::*value;
  double low, high;
  bool needed;
};
constexpr NumberMember kNumbers[] = {
    {"damping", &DeviceProfile::damping, 1e-4, 1e3, true},  {"friction", &DeviceProfile::friction, 0, 100, false},
    {"resolution", &DeviceProfile::resolution, 0, 0.01, false}, {"mass", &DeviceProfile::mass, 0, 100, false},
    {"forceMax", &DeviceProfile::forceMax, 0.01, 200, true},    {"slewMax", &DeviceProfile::slewMax, 1, 1e6, true},
    {"rate", &DeviceProfile::rate, 100, 10000, false},          {"delay", &DeviceProfile::delay, 0, 0.1, false}};

}  // namespace

Result<std::vector<DeviceProfile>> readDeviceProfiles(const std::string& path) {
  const Result<JsonValue> json = readJson(path);
  if (!json) return json.error();
  const auto wrong = [&](const std::string& pointer, const std::string& what) {
    return Error{Fault::SchemaMismatch, {path, pointer, "", {}}, {what}, "device profiles"};
  };
  const JsonValue& list = (*json)["devices"];
  if (!list.isArray()) return wrong("/devices", "a list of devices is missing");
  std::vector<DeviceProfile> devices;
  for (std::size_t i = 0; i < list.items().size(); ++i) {
    const JsonValue& item = list[i];
    const std::string at = pointerTo("/devices", i);
    if (!item.isObject()) return wrong(at, "a device is an object");
    DeviceProfile& device = devices.emplace_back();
    for (const auto& [key, text] : {std::pair{"id", &device.id}, {"name", &device.name}, {"source", &device.source}}) {
      *text = item[key].text();
      if (text->empty()) return wrong(pointerTo(at, key), std::string("“") + key + "” is missing");
    }
    for (const NumberMember& member : kNumbers) {
      const JsonValue* found = item.find(member.key);
      if (!found && !member.needed) continue;
      if (!found || !found->isNumber()) return wrong(pointerTo(at, member.key), std::string("“") + member.key + "” must be a number");
      const double value = found->number();
      if (!(value >= member.low && value <= member.high))
        return Error{Fault::OutOfRange, {path, pointerTo(at, member.key), device.id, {}},
                     {std::to_string(value), std::to_string(member.low), std::to_string(member.high)}, "device profiles"};
      device.*member.value = value;
    }
    for (std::size_t k = 0; k + 1 < devices.size(); ++k)
      if (devices[k].id == device.id) return Error{Fault::DuplicateId, {path, pointerTo(at, "id"), "", {}}, {device.id}, "device profiles"};
  }
  return devices;
}

}  // namespace glenoid
