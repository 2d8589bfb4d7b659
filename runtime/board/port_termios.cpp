// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/termios.h"
#include "runtime/board/port.h"

namespace glider::runtime {

OpenPort openPort(const char* path, uint32_t baud) {
  static hooks::SerialDevice device;
  const int error = device.open(path, baud);
  if (error != 0) {
    return {{}, -1, portProblem(error)};
  }
  return {device.stream(), device.descriptor(), nullptr};
}

/// The boards' first port is the console; the second goes to the science computer.
const char* defaultPort() {
  return "/dev/ttyS1";
}

}  // namespace glider::runtime
