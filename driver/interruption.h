// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::driver {

/// While this exists, the first SIGINT (Ctrl-C) or SIGTERM is recorded instead of ending the
/// program.
class Interruption {
 public:
  /// What a second one does. Ignored is for what must be finished, and soon is.
  enum class Second : unsigned char { Ends, Ignored };
  explicit Interruption(Second second = Second::Ends);
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();
  /// The signal that was received; 0: none.
  static int signal();
};

}  // namespace glider::driver
