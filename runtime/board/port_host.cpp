// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/descriptor.h"
#include "runtime/board/port.h"

#include <libserialport.h>

#include <errno.h>
#include <limits.h>
#include <stdlib.h>

namespace glider::runtime {
namespace {

int32_t readPort(void* self, uint8_t* bytes, uint32_t capacity) {
  auto* port = static_cast<sp_port*>(self);
  const int got = sp_nonblocking_read(port, bytes, capacity);
  int descriptor = -1;
  sp_get_port_handle(port, &descriptor);
  if (got == 0 && hooks::isHungUp(descriptor)) {  // an unplugged adapter
    return kGliderStreamClosed;
  }
  return got >= 0 ? got : static_cast<int32_t>(kGliderStreamFailed);
}

int32_t writePort(void* self, const uint8_t* bytes, uint32_t count) {
  const int taken = sp_nonblocking_write(static_cast<sp_port*>(self), bytes, count);
  return taken >= 0 ? taken : static_cast<int32_t>(kGliderStreamFailed);
}

bool configure(sp_port* port, uint32_t baud) {
  return sp_set_baudrate(port, static_cast<int>(baud)) == SP_OK && sp_set_bits(port, 8) == SP_OK &&
         sp_set_parity(port, SP_PARITY_NONE) == SP_OK && sp_set_stopbits(port, 1) == SP_OK &&
         sp_set_flowcontrol(port, SP_FLOWCONTROL_NONE) == SP_OK;
}

/// Pseudo-terminals, which libserialport leaves out on purpose.
OpenPort openSerial(const char* path, uint32_t baud) {
  static sp_port* port = nullptr;
  if (sp_get_port_by_name(path, &port) != SP_OK) {
    return {{}, -1, portProblem(ENOTTY)};
  }
  if (sp_open(port, SP_MODE_READ_WRITE) != SP_OK) {
    return {{}, -1, portProblem(errno)};
  }
  if (!configure(port, baud)) {
    return {{}, -1, portProblem(EINVAL)};
  }
  int descriptor = -1;
  sp_get_port_handle(port, &descriptor);
  return {{port, readPort, writePort}, descriptor, nullptr};
}

}  // namespace

OpenPort openPort(const char* path, uint32_t baud) {
  // A symbolic link may point to either kind.
  static char device[PATH_MAX];
  if (realpath(path, device) == nullptr) {
    return {{}, -1, portProblem(errno)};
  }
  return hooks::isPseudoTerminal(device) ? openDevice(device, baud) : openSerial(device, baud);
}

const char* defaultPort() {
  return "/dev/ttyUSB0";
}

}  // namespace glider::runtime
