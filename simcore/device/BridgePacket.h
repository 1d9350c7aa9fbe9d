// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "simcore/device/DevicePort.h"

namespace glenoid {

/// The bridge's two datagrams (README.md). All numbers little-endian, lengths in metres, frame D.
struct BridgePose {
  static constexpr std::size_t kBytes = 80;
  std::uint32_t sequence = 0;
  Pose pose;
  double grip = 0;
  std::uint32_t buttons = 0;
};
struct BridgeForce {
  static constexpr std::size_t kBytes = 64;
  std::uint32_t sequence = 0;  ///< of the pose that it answers
  DeviceForce force;
  bool live = false;           ///< false: nothing is felt now, and the force is zero
};

/// Nothing where the length or the first four letters are others. Numbers are not judged here. Allocates nothing.
std::optional<BridgePose> bridgePose(std::span<const unsigned char> bytes);
std::optional<BridgeForce> bridgeForce(std::span<const unsigned char> bytes);
std::array<unsigned char, BridgePose::kBytes> bytesOf(const BridgePose& pose);
std::array<unsigned char, BridgeForce::kBytes> bytesOf(const BridgeForce& force);

}  // namespace glenoid
