// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/termios.h"

#include "hooks/transport/descriptor.h"

#include <errno.h>
#include <fcntl.h>
#include <termios.h>
#include <unistd.h>
#ifndef __GLIBC__
#include <sys/ioctl.h>
#include <sys/syscall.h>
#endif

namespace glider::hooks {
namespace {

#ifdef __GLIBC__
int readSettings(int fd, termios* settings) {
  return tcgetattr(fd, settings);
}
int writeSettings(int fd, const termios& settings) {
  return tcsetattr(fd, TCSANOW, &settings);
}
int dropInput(int fd) {
  return tcflush(fd, TCIFLUSH);
}
#else
// The same as musl's tcgetattr, tcsetattr and tcflush, but without its ioctl, which adds 1.5 KB of
// conversions for other devices on old kernels; a board's program has a size limit.
int readSettings(int fd, termios* settings) {
  return static_cast<int>(syscall(SYS_ioctl, fd, TCGETS, settings));
}
int writeSettings(int fd, const termios& settings) {
  return static_cast<int>(syscall(SYS_ioctl, fd, TCSETS, &settings));
}
int dropInput(int fd) {
  return static_cast<int>(syscall(SYS_ioctl, fd, TCFLSH, TCIFLUSH));
}
#endif

struct Speed {
  uint32_t baud;
  speed_t code;
};

constexpr Speed kSpeeds[] = {{1200, B1200},   {2400, B2400},     {4800, B4800},
                             {9600, B9600},   {19200, B19200},   {38400, B38400},
                             {57600, B57600}, {115200, B115200}, {230400, B230400}};

bool speedCode(uint32_t baud, speed_t* code) {
  for (const Speed& speed : kSpeeds) {
    if (speed.baud == baud) {
      *code = speed.code;
      return true;
    }
  }
  return false;
}

/// Raw, 8N1, no flow control. VMIN 1 lets read distinguish "nothing yet" (EAGAIN) from "hung up"
/// (0).
int setRaw(int fd, uint32_t baud) {
  speed_t code = B0;
  if (!speedCode(baud, &code)) {
    return EINVAL;
  }
  termios settings{};
  if (readSettings(fd, &settings) != 0) {
    return errno;
  }
  settings.c_iflag = 0;
  settings.c_oflag = 0;
  settings.c_lflag = 0;
  settings.c_cflag = CS8 | CREAD | CLOCAL;
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  if (cfsetispeed(&settings, code) != 0 || cfsetospeed(&settings, code) != 0 ||
      writeSettings(fd, settings) != 0) {
    return errno;
  }
  // The kernel reports success if any of the changes was made: check whether the speed was one of
  // them.
  termios made{};
  if (readSettings(fd, &made) != 0) {
    return errno;
  }
  return cfgetospeed(&made) == code ? 0 : EINVAL;
}

}  // namespace

bool isPseudoTerminal(const char* path) {
  const char* prefix = "/dev/pts/";
  while (*prefix != 0 && *path == *prefix) {
    ++path;
    ++prefix;
  }
  return *prefix == 0;
}

int SerialDevice::open(const char* path, uint32_t baud) {
  close();
  const int fd = ::open(path, O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (fd < 0) {
    return errno;
  }
  const int error = setRaw(fd, baud);
  if (error != 0) {
    ::close(fd);
    return error;
  }
  if (!isPseudoTerminal(path)) {
    (void)dropInput(fd);
  }
  fd_ = fd;
  return 0;
}

void SerialDevice::close() {
  if (fd_ >= 0) {
    ::close(fd_);
    fd_ = -1;
  }
}

GliderByteStream SerialDevice::stream() {
  return {this, &SerialDevice::read, &SerialDevice::write};
}

int32_t SerialDevice::read(void* self, uint8_t* bytes, uint32_t capacity) {
  return readDescriptor(static_cast<const SerialDevice*>(self)->fd_, bytes, capacity);
}

int32_t SerialDevice::write(void* self, const uint8_t* bytes, uint32_t count) {
  return writeDescriptor(static_cast<const SerialDevice*>(self)->fd_, bytes, count);
}

}  // namespace glider::hooks
