// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/host/pty.h"

#include "hooks/transport/descriptor.h"
#include "support/diagnostics/ids/ports.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace glider::hooks {
namespace {

std::unexpected<support::Failure> failed() {
  return support::fail(support::diagnostics::noPseudoTerminal, std::strerror(errno));
}

bool setRaw(int fd) {
  termios settings{};
  if (tcgetattr(fd, &settings) != 0) {
    return false;
  }
  cfmakeraw(&settings);
  return tcsetattr(fd, TCSANOW, &settings) == 0;
}

}  // namespace

support::Result<Pty> Pty::open() {
  Pty pty;
  pty.master_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (pty.master_ < 0 || ::grantpt(pty.master_) != 0 || ::unlockpt(pty.master_) != 0) {
    return failed();
  }
  std::array<char, 128> name{};
  if (::ptsname_r(pty.master_, name.data(), name.size()) != 0) {
    return failed();
  }
  pty.name_ = name.data();
  pty.user_ = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (pty.user_ < 0 || !setRaw(pty.user_)) {
    return failed();
  }
  return pty;
}

Pty::Pty(Pty&& other) noexcept
    : master_(std::exchange(other.master_, -1)),
      user_(std::exchange(other.user_, -1)),
      name_(std::move(other.name_)) {}

Pty& Pty::operator=(Pty&& other) noexcept {
  if (this != &other) {
    close();
    master_ = std::exchange(other.master_, -1);
    user_ = std::exchange(other.user_, -1);
    name_ = std::move(other.name_);
  }
  return *this;
}

Pty::~Pty() {
  close();
}

void Pty::close() {
  releaseUserSide();
  if (master_ >= 0) {
    ::close(master_);
    master_ = -1;
  }
}

void Pty::releaseUserSide() {
  if (user_ >= 0) {
    ::close(user_);
    user_ = -1;
  }
}

GliderByteStream Pty::stream() {
  return {this, &Pty::read, &Pty::write};
}

int32_t Pty::read(void* self, uint8_t* bytes, uint32_t capacity) {
  return readDescriptor(static_cast<const Pty*>(self)->master_, bytes, capacity);
}

int32_t Pty::write(void* self, const uint8_t* bytes, uint32_t count) {
  return writeDescriptor(static_cast<const Pty*>(self)->master_, bytes, count);
}

}  // namespace glider::hooks
