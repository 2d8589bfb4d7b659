// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/port.h"

#include <errno.h>
#include <new>

glider::runtime::OpenPort glider::runtime::openDevice(const char* path, uint32_t baud) {
  // It lives as long as the program. For a static object with a destructor, the C library would
  // keep a list of exit handlers on the heap.
  alignas(hooks::SerialDevice) static uint8_t memory[sizeof(hooks::SerialDevice)];
  static auto* const device = ::new (memory) hooks::SerialDevice;
  const int error = device->open(path, baud);
  if (error != 0) {
    return {{}, -1, portProblem(error)};
  }
  return {device->stream(), device->descriptor(), nullptr};
}

const char* glider::runtime::portProblem(int error) {
  switch (error) {
    case ENOENT:
    case ENXIO:
    case ENODEV:
      return "there is no such device";
    case EACCES:
    case EPERM:
      return "no permission to open it";
    case EBUSY:
      return "another program has it";
    case ENOTTY:
    case EISDIR:
      return "it is not a serial port";
    case EINVAL:
      return "it cannot run at that speed";
    default:
      return "the device failed";
  }
}
