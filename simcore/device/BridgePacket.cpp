// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/device/BridgePacket.h"

#include <bit>
#include <cstring>

namespace glenoid {

namespace {

constexpr char kPose[] = "GBP1", kForce[] = "GBF1";
static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie");

/// Goes through a datagram from its fifth byte.
template <class Byte>
struct Cursor {
  Byte* at;
  void number(auto& value) {
    if constexpr (std::is_const_v<Byte>) std::memcpy(&value, at, sizeof value);
    else std::memcpy(at, &value, sizeof value);
    at += sizeof value;
  }
  void vector(auto& v) {
    for (int i = 0; i < 3; ++i) number(v[i]);
  }
};

}  // namespace

std::optional<BridgePose> bridgePose(std::span<const unsigned char> bytes) {
  if (bytes.size() != BridgePose::kBytes || std::memcmp(bytes.data(), kPose, 4) != 0) return {};
  BridgePose pose;
  Cursor<const unsigned char> in{bytes.data() + 4};
  in.number(pose.sequence);
  in.vector(pose.pose.p_WB);
  in.number(pose.pose.q_WB.w());
  in.number(pose.pose.q_WB.x());
  in.number(pose.pose.q_WB.y());
  in.number(pose.pose.q_WB.z());
  in.number(pose.grip);
  in.number(pose.buttons);
  return pose;
}

std::array<unsigned char, BridgePose::kBytes> bytesOf(const BridgePose& pose) {
  std::array<unsigned char, BridgePose::kBytes> bytes{};
  std::memcpy(bytes.data(), kPose, 4);
  Cursor<unsigned char> out{bytes.data() + 4};
  out.number(pose.sequence);
  out.vector(pose.pose.p_WB);
  for (const double value : {pose.pose.q_WB.w(), pose.pose.q_WB.x(), pose.pose.q_WB.y(), pose.pose.q_WB.z(), pose.grip}) out.number(value);
  out.number(pose.buttons);
  return bytes;
}

std::optional<BridgeForce> bridgeForce(std::span<const unsigned char> bytes) {
  if (bytes.size() != BridgeForce::kBytes || std::memcmp(bytes.data(), kForce, 4) != 0) return {};
  BridgeForce force;
  Cursor<const unsigned char> in{bytes.data() + 4};
  in.number(force.sequence);
  in.vector(force.force.force);
  in.vector(force.force.torque);
  std::uint32_t flags = 0;
  in.number(flags);
  force.live = (flags & 1) != 0;
  return force;
}

std::array<unsigned char, BridgeForce::kBytes> bytesOf(const BridgeForce& force) {
  std::array<unsigned char, BridgeForce::kBytes> bytes{};
  std::memcpy(bytes.data(), kForce, 4);
  Cursor<unsigned char> out{bytes.data() + 4};
  out.number(force.sequence);
  out.vector(force.force.force);
  out.vector(force.force.torque);
  const std::uint32_t flags = force.live;
  out.number(flags);
  return bytes;
}

}  // namespace glenoid
