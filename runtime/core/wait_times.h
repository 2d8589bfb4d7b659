// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::runtime {

/// When a wait is reported: at its begin, then once a minute, and after an hour once an hour. A
/// vehicle that never comes up must not fill the log.
class WaitTimes {
 public:
  static constexpr double kOften = 60, kSeldom = 3600;  // s

  /// It has lasted for `seconds`; NaN: there is none. True if that is to be reported now.
  bool isDue(double seconds) {
    const bool is_new = seconds != seconds || seconds < last_s_;
    next_s_ = is_new ? 0 : next_s_;
    last_s_ = is_new ? 0 : seconds;
    if (!(seconds >= next_s_)) {
      return false;
    }
    next_s_ = seconds + (seconds < kSeldom ? kOften : kSeldom);
    return true;
  }

 private:
  double last_s_ = 0, next_s_ = 0;  ///< of the wait
};

}  // namespace glider::runtime
