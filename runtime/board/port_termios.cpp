// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/termios.h"
#include "runtime/board/port.h"

#include <new>

namespace glider::runtime {

OpenPort openPort(const char* path, uint32_t baud) {
  // Without a destructor, which would bring musl's heap along: the port closes with the program.
  alignas(hooks::SerialDevice) static uint8_t memory[sizeof(hooks::SerialDevice)];
  static hooks::SerialDevice& device = *::new (memory) hooks::SerialDevice;
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
