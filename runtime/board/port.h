// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "hooks/transport/termios.h"

#include <stdint.h>

/// The serial port to the vehicle, as this board opens it: port_termios.cpp on the small boards,
/// port_host.cpp on a computer with libserialport.
namespace glider::runtime {

struct OpenPort {
  GliderByteStream stream{};
  int descriptor = -1;            ///< for poll(2)
  const char* problem = nullptr;  ///< why there is no stream; null if there is one
};

/// Opens the program's one port.
OpenPort openPort(const char* path, uint32_t baud);

/// The same for a device that Linux itself drives.
OpenPort openDevice(const char* path, uint32_t baud);

/// The port that is opened when none is named.
const char* defaultPort();

/// Why opening failed, in words, from an errno.
const char* portProblem(int error);

}  // namespace glider::runtime
