// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/terminal.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace glider::driver {

/// The current step of a check, on the last line of a terminal, once the check has taken longer
/// than a second: "survey.mission: proving 3 of 5: require exit within 90 min, 12 s", and
/// "(proofs: at most 60 s)" if there is a limit. The line is
/// removed at the end. In a file or a pipe it is a line a minute.
class CheckProgress {
 public:
  /// `mission`: the file, as the user named it.
  /// `limit_s`: how long its proofs may take; 0: no limit.
  explicit CheckProgress(std::string mission, double limit_s = 0);
  CheckProgress(const CheckProgress&) = delete;
  CheckProgress& operator=(const CheckProgress&) = delete;
  ~CheckProgress();

  /// What is done from now on, in a few words; line breaks in it are shown as spaces.
  void at(const std::string& work);
  /// Removes the line, so that something else can be printed; it comes back if the check goes on.
  void clear();

 private:
  void run();

  ProgressLine line_;
  std::string mission_;
  double limit_s_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;  // of what follows
  std::condition_variable ended_;
  std::string work_;
  bool end_ = false;
  std::thread teller_;  // last: it uses all of this
};

}  // namespace glider::driver
