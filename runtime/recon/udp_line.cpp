// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/recon/udp_line.h"

#include <errno.h>
#include <poll.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

namespace glider::runtime::recon {
namespace {

bool bindTo(int descriptor, const sockaddr_in& address) {
  return bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

/// This computer's address on the way to `vehicle`, with its port; false if there is no way.
bool ownAddress(const NetworkAddress& vehicle, sockaddr_in& own) {
  const int probe = makeSocket(SOCK_DGRAM);
  if (probe < 0) {
    return false;
  }
  const sockaddr_in to = socketAddress(vehicle);
  socklen_t size = sizeof own;
  const bool found = connect(probe, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0 &&
                     getsockname(probe, reinterpret_cast<sockaddr*>(&own), &size) == 0;
  close(probe);
  own.sin_port = to.sin_port;
  return found;
}

/// Up to its line feed.
uint32_t lineSize(const uint8_t* bytes, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    if (bytes[i] == '\n') {
      return i + 1;
    }
  }
  return count;
}

}  // namespace

void UdpLine::tell(News news, uint32_t count) const {
  if (report_ != nullptr) {
    report_(news, count);
  }
}

void UdpLine::close() {
  if (fd_ >= 0) {
    ::close(fd_);
  }
  fd_ = -1;
}

/// At all addresses of this computer, so that it may be given another one meanwhile. If a program
/// has the port at one of them, such as a simulated vehicle, only at that from which the vehicle is
/// reached. Never together with another program that steers a vehicle.
bool UdpLine::bindPort() const {
  sockaddr_in own = socketAddress({{}, vehicle_.port});
  return bindTo(fd_, own) || (ownAddress(vehicle_, own) && bindTo(fd_, own));
}

bool UdpLine::open() {
  const double now_s = clock_.now(clock_.self);
  if (now_s - began_s_ < kRetrySecs) {
    return false;
  }
  began_s_ = now_s;
  fd_ = makeSocket(SOCK_DGRAM);
  if (fd_ >= 0 && bindPort()) {
    return true;
  }
  close();
  if (!told_no_port_) {
    tell(News::NoPort, 0);
  }
  told_no_port_ = true;
  return false;
}

void UdpLine::noteStranger() {
  constexpr uint32_t kMost = 1000000000;
  strangers_ += strangers_ < UINT32_MAX ? 1 : 0;
  if (strangers_ == tells_at_) {
    tell(News::Stranger, strangers_);
    tells_at_ = tells_at_ < kMost ? tells_at_ * 10 : 0;
  }
}

void UdpLine::noteHeard() {
  if (!heard_) {
    tell(News::Heard, 0);
  }
  heard_ = true;
}

/// Takes the vehicle's next datagram; false if there is none. It may come from any port: what is
/// known of RECON does not say that the vehicle sends from the port at which it listens.
bool UdpLine::receive() {
  for (uint32_t i = 0; i < kMostStrangersAtOnce; ++i) {
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t got =
        recvfrom(fd_, in_, sizeof in_ - 1, 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (got < 0) {
      if (errno != EAGAIN && errno != EINTR && errno != ECONNREFUSED) {
        close();
      }
      return false;
    }
    if (memcmp(&from.sin_addr, vehicle_.host, sizeof vehicle_.host) != 0) {
      noteStranger();
    } else if (got > 0) {
      noteHeard();
      next_ = 0;
      end_ = static_cast<uint32_t>(got);
      if (in_[end_ - 1] != '\n') {
        in_[end_++] = '\n';
      }
      return true;
    }
  }
  return false;
}

int32_t UdpLine::read(void* self, uint8_t* bytes, uint32_t capacity) {
  auto& line = *static_cast<UdpLine*>(self);
  if (line.next_ == line.end_ && ((line.fd_ < 0 && !line.open()) || !line.receive())) {
    return 0;
  }
  const uint32_t left = line.end_ - line.next_;
  const uint32_t count = left < capacity ? left : capacity;
  memcpy(bytes, line.in_ + line.next_, count);
  line.next_ += count;
  return static_cast<int32_t>(count);
}

/// One line. The pause is before it, as the vehicle's known driver has it, and not measured: the
/// clock of an old kernel is too coarse. No error of sending is one of the line: the vehicle may
/// not be up, or the network not yet.
int32_t UdpLine::write(void* self, const uint8_t* bytes, uint32_t count) {
  auto& line = *static_cast<UdpLine*>(self);
  const uint32_t size = lineSize(bytes, count);
  if (line.fd_ >= 0) {
    const sockaddr_in to = socketAddress(line.vehicle_);
    (void)poll(nullptr, 0, kPauseMs);
    (void)sendto(line.fd_, bytes, size, 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }
  return static_cast<int32_t>(size);
}

}  // namespace glider::runtime::recon
