// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"

#include <stdint.h>

namespace glider::hooks {

/// A serial device or pseudo-terminal of Linux, raw, 8N1, no flow control, never blocking. Uses
/// only what Linux 2.4 has.
class SerialDevice {
 public:
  SerialDevice() = default;
  SerialDevice(const SerialDevice&) = delete;
  SerialDevice& operator=(const SerialDevice&) = delete;
  ~SerialDevice() { close(); }

  /// Opens `path` at `baud` bits/s. Returns 0, or the errno of what failed: ENOENT no such device,
  /// EACCES no permission, ENOTTY no serial line, EINVAL a speed that the device or the kernel does
  /// not support. Unread bytes of an earlier user are discarded on a real line, but not on a
  /// pseudo-terminal, where they may be the peer's first bytes.
  int open(const char* path, uint32_t baud);
  void close();
  [[nodiscard]] bool isOpen() const { return fd_ >= 0; }
  /// For poll(2); -1 when closed.
  [[nodiscard]] int descriptor() const { return fd_; }
  /// Points into this object.
  [[nodiscard]] GliderByteStream stream();

 private:
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count);

  int fd_ = -1;
};

/// True for the path of a pseudo-terminal's user side (/dev/pts/N).
bool isPseudoTerminal(const char* path);

}  // namespace glider::hooks
