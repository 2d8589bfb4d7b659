// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/port.h"

#include <errno.h>

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
