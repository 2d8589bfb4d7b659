// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/imc/tcp_line.h"

#include "hooks/transport/descriptor.h"
#include "runtime/board/kernel.h"

#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

namespace glider::runtime::imc {
namespace {

/// Reads a number up to `most` and moves `text` past it; false if there is none.
bool readNumber(const char*& text, uint32_t most, uint32_t& number) {
  const char* const begin = text;
  number = 0;
  for (; *text >= '0' && *text <= '9' && number <= most; ++text) {
    number = number * 10 + static_cast<uint32_t>(*text - '0');
  }
  return text != begin && number <= most;
}

sockaddr_in socketAddress(const TcpAddress& address) {
  sockaddr_in made{};
  made.sin_family = AF_INET;
  memcpy(&made.sin_addr, address.host, sizeof address.host);
  const uint8_t port[2] = {static_cast<uint8_t>(address.port >> 8U),
                           static_cast<uint8_t>(address.port & 0xFFU)};
  memcpy(&made.sin_port, port, sizeof port);
  return made;
}

/// A socket that never blocks; -1 if there is none.
int makeSocket() {
  const int made = socket(AF_INET, SOCK_STREAM, 0);
  if (made >= 0 && controlFile(made, F_SETFL, O_RDWR | O_NONBLOCK) != 0) {
    ::close(made);
    return -1;
  }
  return made;
}

}  // namespace

bool readAddress(const char* text, TcpAddress& address) {
  TcpAddress read;
  uint32_t number = 0;
  for (uint32_t i = 0; i < 4; ++i) {
    if (!readNumber(text, 255, number) || *text++ != (i < 3 ? '.' : ':')) {
      return false;
    }
    read.host[i] = static_cast<uint8_t>(number);
  }
  if (!readNumber(text, 65535, number) || number == 0 || *text != '\0') {
    return false;
  }
  read.port = static_cast<uint16_t>(number);
  address = read;
  return true;
}

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
  fd_ = makeSocket();
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
