// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "simcore/device/DevicePort.h"

namespace glenoid {

/// Which way a service wants a force to be written. Public clients are split about evenly, and no schema is published.
enum class HaplyDialect { Values, Vector };

/// What a message of the service says of one Inverse3 and the grip on it.
struct HaplyWord {
  bool isState = false;       ///< it lists devices: an inventory or the answer to a command; else an event or what we do not know
  std::string device;         ///< id of the Inverse3; empty: none is listed, or not the wanted one
  bool hasPose = false;       ///< with a place of its cursor
  Pose pose;                  ///< D; turned as its grip is, if there is one
  unsigned buttons = 0;       ///< of the grip
  std::optional<Vec3> force;  ///< N, D: what the service says it shows
};

/// `wanted`: id of the Inverse3 to look for, or empty for the first. Nothing where the text is no JSON object: numbers that are missing
/// or no numbers make a pose that is none (not a number), which the loop refuses.
std::optional<HaplyWord> haplyWord(std::string_view text, const std::string& wanted);

/// The command for one tick; `first`: with what begins a session. Without a device one that commands nothing, and is answered too.
std::string haplyCommand(const std::string& device, const Vec3& force_D, HaplyDialect dialect, bool first);

/// The service's axes are X right, Y forward, Z up.
Vec3 haplyToDevice(const Vec3& v);
Vec3 deviceToHaply(const Vec3& v);

}  // namespace glenoid
