// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/port.h"

namespace glider::runtime {

OpenPort openPort(const char* path, uint32_t baud) {
  return openDevice(path, baud);
}

/// The boards' first port is the console; the second goes to the science computer.
const char* defaultPort() {
  return "/dev/ttyS1";
}

}  // namespace glider::runtime
