// SPDX-License-Identifier: GPL-3.0-or-later
// A tracker by OpenIGTLink: this side connects, and takes TRANSFORM, POSITION and QTDATA as poses in millimetres. Anything else is passed over.
#include <igtlClientSocket.h>
#include <igtlMessageHeader.h>
#include <igtlPositionMessage.h>
#include <igtlQuaternionTrackingDataMessage.h>
#include <igtlTransformMessage.h>
#include <sys/socket.h>

#include <optional>

#include "simcore/device/DevicePort.h"
#include "simcore/device/IoThread.h"
#include "simcore/device/Links.h"
#include "simcore/haptic/HapticThread.h"
#include "simcore/tool/PoseSpring.h"

namespace glenoid {

namespace {

constexpr int kPatienceMs = 200;
constexpr double kHold = 0.25;          // s: trackers speak some thirty times a second
constexpr int kWaits = 10;
constexpr int kMost = 1 << 24;          // bytes of a message: images come by too

Pose poseOf(const float* position, const float* quaternion) {
  Pose pose;
  pose.p_WB = 1e-3 * Vec3(position[0], position[1], position[2]);
  pose.q_WB = Quat(quaternion[3], quaternion[0], quaternion[1], quaternion[2]);
  if (const double size = pose.q_WB.norm(); std::abs(size - 1) < 1e-3) pose.q_WB.coeffs() /= size;  // single precision
  return pose;
}

class TrackerLink : public DeviceLink {
 public:
  TrackerLink(igtl::ClientSocket::Pointer socket, const DeviceAddress& address, const DeviceAnchor& anchor)
      : m_socket(std::move(socket)), m_address(address), m_port(anchor, kHold) {
    m_socket->SetReceiveTimeout(kPatienceMs);
    m_io.start([this] { run(); });
  }
  ~TrackerLink() override {
    m_io.stop();
    m_socket->CloseSocket();
  }
  HapticDevice& device() override { return m_port; }
  DeviceStory story() const override { return m_io.story(); }

 private:
  void run();
  bool message(igtl::MessageHeader& header);
  enum class Came { All, Nothing, End };
  Came receive(void* to, int size);
  Came receiveBody(void* to, int size);
  template <class Message>
  std::optional<typename Message::Pointer> body(igtl::MessageHeader& header);
  void refuse() { m_io.tell([](DeviceStory& story) { ++story.refused; }); }

  igtl::ClientSocket::Pointer m_socket;
  DeviceAddress m_address;
  DevicePort m_port;
  std::string m_name;
  std::vector<char> m_skipped;
  IoThread m_io;
};

/// Nothing: not a byte within the patience. What has begun must come to its end within ten times that.
TrackerLink::Came TrackerLink::receive(void* to, int size) {
  int have = 0;
  for (int waits = 0; have < size && !m_io.quit();) {
    const int more = m_socket->Receive(static_cast<char*>(to) + have, size - have, 0);
    if (more > 0) have += more;
    else if (more == 0 || ++waits >= kWaits) return Came::End;
    else if (have == 0) return Came::Nothing;
  }
  return have == size ? Came::All : Came::End;
}

/// What follows a header: it comes, though it may be late.
TrackerLink::Came TrackerLink::receiveBody(void* to, int size) {
  Came came = Came::Nothing;
  for (int waits = 0; came == Came::Nothing && waits < kWaits; ++waits) came = receive(to, size);
  return came;
}

template <class Message>
std::optional<typename Message::Pointer> TrackerLink::body(igtl::MessageHeader& header) {
  auto whole = Message::New();
  whole->SetMessageHeader(&header);
  whole->AllocatePack();
  if (receiveBody(whole->GetPackBodyPointer(), whole->GetPackBodySize()) != Came::All) return {};
  if (!(whole->Unpack(1) & igtl::MessageHeader::UNPACK_BODY)) {  // its check sum is wrong
    refuse();
    return typename Message::Pointer();
  }
  return whole;
}

/// False: the connection is out of step or at its end.
bool TrackerLink::message(igtl::MessageHeader& header) {
  const std::string type = header.GetDeviceType(), name = header.GetDeviceName();
  std::optional<Pose> pose;
  if (type == "TRANSFORM") {
    const auto whole = body<igtl::TransformMessage>(header);
    if (!whole) return false;
    if (whole->IsNull()) return true;
    igtl::Matrix4x4 matrix;
    (*whole)->GetMatrix(matrix);
    Mat3 turn;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) turn(r, c) = matrix[r][c];
    pose = Pose{1e-3 * Vec3(matrix[0][3], matrix[1][3], matrix[2][3]), Quat(turn)};
    if ((turn.transpose() * turn - Mat3::Identity()).norm() < 1e-3) pose->q_WB.normalize();
    else pose->q_WB.coeffs().setZero();  // no rotation: the loop refuses it
  } else if (type == "POSITION") {
    const auto whole = body<igtl::PositionMessage>(header);
    if (!whole) return false;
    if (whole->IsNull()) return true;
    float position[3], quaternion[4];
    (*whole)->GetPosition(position);
    (*whole)->GetQuaternion(quaternion);
    pose = poseOf(position, quaternion);
  } else if (type == "QTDATA") {
    const auto whole = body<igtl::QuaternionTrackingDataMessage>(header);
    if (!whole) return false;
    if (whole->IsNull()) return true;
    for (int i = 0; i < (*whole)->GetNumberOfQuaternionTrackingDataElements() && !pose; ++i) {
      igtl::QuaternionTrackingDataElement::Pointer element;
      (*whole)->GetQuaternionTrackingDataElement(i, element);
      if (!m_address.name.empty() && m_address.name != element->GetName()) continue;
      float position[3], quaternion[4];
      element->GetPosition(position);
      element->GetQuaternion(quaternion);
      pose = poseOf(position, quaternion);
    }
  } else {
    m_skipped.resize(static_cast<std::size_t>(header.GetBodySizeToRead()));
    return m_skipped.empty() || receiveBody(m_skipped.data(), static_cast<int>(m_skipped.size())) == Came::All;
  }
  if (!pose || (type != "QTDATA" && !m_address.name.empty() && m_address.name != name)) return true;
  if (m_name.empty()) m_name = name;
  if (type != "QTDATA" && name != m_name) return true;  // the first that spoke, where none was named
  ToolInput word;
  word.pose = *pose;
  word.stamp = steadyNow();
  m_port.say(word);
  m_io.tell([&](DeviceStory& story) { story.present = true, story.name = m_name, ++story.words, story.refused += !isHandPose(*pose); });
  return true;
}

void TrackerLink::run() {
  bool connected = true;
  while (connected && !m_io.quit()) {
    auto header = igtl::MessageHeader::New();
    header->InitPack();
    const Came came = receive(header->GetPackPointer(), header->GetPackSize());
    if (came == Came::Nothing) continue;
    if (came == Came::End) break;
    if (!(header->Unpack() & igtl::MessageHeader::UNPACK_HEADER) || header->GetBodySizeToRead() > kMost || header->GetBodySizeToRead() < 0) {
      refuse();
      break;
    }
    connected = message(*header);
  }
  if (m_io.quit()) return;
  m_port.leave();
  m_io.tell([](DeviceStory& story) { story.present = false, ++story.left; });
}

}  // namespace

Result<std::unique_ptr<DeviceLink>> openTracker(const DeviceAddress& address, const DeviceAnchor& anchor) {
  const Error nobody = nobodyThere(address, "start an OpenIGTLink server, or name where it runs as igtl:HOST:PORT");
  if (!somebodyListens(address.host, address.port, 1)) return nobody;
  auto socket = igtl::ClientSocket::New();
  if (socket->ConnectToServer(address.host.c_str(), address.port) != 0) return nobody;
  return std::unique_ptr<DeviceLink>(new TrackerLink(std::move(socket), address, anchor));
}

}  // namespace glenoid
