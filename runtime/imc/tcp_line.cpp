// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/imc/tcp_line.h"

#include "hooks/transport/descriptor.h"

#include <errno.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace glider::runtime::imc {

void TcpLine::tell(bool connected) {
  if (report_ != nullptr && (!has_told_ || told_ != connected)) {
    report_(connected);
  }
  has_told_ = true;
  told_ = connected;
}

void TcpLine::close() {
  if (fd_ < 0) {
    return;
  }
  // The process of the card may have a copy, which would keep the connection open.
  (void)shutdown(fd_, SHUT_RDWR);
  ::close(fd_);
  fd_ = -1;
  connected_ = false;
  tell(false);
}

void TcpLine::open(double now_s) {
  if (now_s - began_s_ < kRetrySecs) {
    return;
  }
  began_s_ = now_s;
  fd_ = makeSocket(SOCK_STREAM);
  const sockaddr_in to = socketAddress(address_);
  if (fd_ >= 0 && connect(fd_, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0 &&
      errno != EINPROGRESS) {
    close();
  }
}

/// Whether the attempt has succeeded, or is to be given up.
void TcpLine::lookAtAttempt(double now_s) {
  pollfd wanted{fd_, POLLOUT, 0};
  if (poll(&wanted, 1, 0) > 0) {
    int error = 0;
    socklen_t size = sizeof error;
    connected_ = getsockopt(fd_, SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0;
    if (!connected_) {
      close();
      return;
    }
    heard_s_ = now_s;
    tell(true);
  } else if (now_s - began_s_ > kPatienceSecs) {
    close();
  }
}

int32_t TcpLine::read(void* self, uint8_t* bytes, uint32_t capacity) {
  auto& line = *static_cast<TcpLine*>(self);
  const double now_s = line.clock_.now(line.clock_.self);
  if (line.fd_ < 0) {
    line.open(now_s);
  }
  if (line.fd_ >= 0 && !line.connected_) {
    line.lookAtAttempt(now_s);
  }
  if (!line.connected_) {
    return kGliderStreamClosed;
  }
  const int32_t count = hooks::readDescriptor(line.fd_, bytes, capacity);
  line.heard_s_ = count > 0 ? now_s : line.heard_s_;
  if (count < 0 || now_s - line.heard_s_ > kPatienceSecs) {
    line.close();
    return kGliderStreamClosed;
  }
  return count;
}

int32_t TcpLine::write(void* self, const uint8_t* bytes, uint32_t count) {
  auto& line = *static_cast<TcpLine*>(self);
  if (!line.connected_) {
    return kGliderStreamClosed;
  }
  const int32_t taken = hooks::writeDescriptor(line.fd_, bytes, count);
  if (taken < 0) {
    line.close();
  }
  return taken;
}

}  // namespace glider::runtime::imc
