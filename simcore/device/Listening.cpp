// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

#include "simcore/device/Links.h"

namespace glenoid {

bool somebodyListens(const std::string& host, int port, double seconds) {
  addrinfo hints{}, *list = nullptr;
  hints.ai_socktype = SOCK_STREAM;
  if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &list) != 0) return false;
  bool there = false;
  for (const addrinfo* at = list; at && !there; at = at->ai_next) {
    const int handle = socket(at->ai_family, at->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, at->ai_protocol);
    if (handle < 0) continue;
    there = connect(handle, at->ai_addr, at->ai_addrlen) == 0;
    if (!there && errno == EINPROGRESS) {
      pollfd wait{handle, POLLOUT, 0};
      int fault = 0;
      socklen_t length = sizeof fault;
      there = poll(&wait, 1, static_cast<int>(1e3 * seconds)) == 1 && getsockopt(handle, SOL_SOCKET, SO_ERROR, &fault, &length) == 0 && fault == 0;
    }
    ::close(handle);
  }
  freeaddrinfo(list);
  return there;
}

Error nobodyThere(const DeviceAddress& address, const std::string& remedy) {
  std::string said("“");
  said.append(address.word).append("”: nobody answers");
  if (!address.host.empty()) said.append(" at ").append(address.host);
  if (address.port > 0) said.append(":").append(std::to_string(address.port));
  return {Fault::BadUsage, {}, {said.append("; ").append(remedy)}, "device"};
}

}  // namespace glenoid
