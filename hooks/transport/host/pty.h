// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "support/result.h"

#include <string>

namespace glider::hooks {

/// A pseudo-terminal, raw from the start: this object is its master; another program opens `name()`
/// as if it were a serial port.
class Pty {
 public:
  /// Fails with GL9106.
  static support::Result<Pty> open();
  Pty(Pty&& other) noexcept;
  Pty& operator=(Pty&& other) noexcept;
  ~Pty();

  /// "/dev/pts/3".
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Valid while this object stays where it is.
  [[nodiscard]] GliderByteStream stream();
  /// For poll(2).
  [[nodiscard]] int descriptor() const { return master_; }
  /// Closes our copy of the user's side, which is held open so that what we write before the
  /// program opens it is kept, and so that the settings stay. Call it when the program runs; its
  /// end then shows as a closed stream.
  void releaseUserSide();

 private:
  Pty() = default;
  void close();
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count);

  int master_ = -1;
  int user_ = -1;
  std::string name_;
};

}  // namespace glider::hooks
