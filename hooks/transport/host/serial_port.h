// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "support/result.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace glider::hooks {

/// A serial port of this computer, raw 8N1 without flow control, locked for us alone. Real ports go
/// through libserialport; pseudo-terminals, which that library leaves out on purpose, through the
/// boards' own termios code.
class SerialPort {
 public:
  /// Opens `path` ("/dev/ttyUSB0", "/dev/pts/3" or a symbolic link to one) at `baud` bits/s. Fails
  /// with GL9100 missing, GL9101 no permission, GL9102 in use, GL9103 not a serial port, GL9104
  /// unsupported baud, GL9105 anything else.
  static support::Result<SerialPort> open(const std::string& path, uint32_t baud);

  SerialPort(SerialPort&&) noexcept;
  SerialPort& operator=(SerialPort&&) noexcept;
  ~SerialPort();

  /// Counts of the device since it was plugged in, for what its driver counts.
  struct Errors {
    uint32_t overruns = 0;  ///< bytes that this computer took too late
    uint32_t framing = 0;   ///< bytes without a stop bit, as at another baud rate
  };
  /// Empty: the device does not count. A pseudo-terminal does not.
  [[nodiscard]] std::optional<Errors> errors() const;

  /// Valid while this object, or one it was moved to, lives.
  [[nodiscard]] GliderByteStream stream() const;

 private:
  class Port;
  class LibraryPort;
  class TerminalPort;
  explicit SerialPort(std::unique_ptr<Port> port);

  std::unique_ptr<Port> port_;
};

}  // namespace glider::hooks
