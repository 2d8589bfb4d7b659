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

/// What a check is at, on the last line of a terminal, once it has taken longer than a second:
/// "survey.mission: proving 3 of 5: require exit within 90 min, 12 s". The line is gone at the end;
/// where standard error is no terminal there is none.
class CheckProgress {
 public:
  /// `mission`: the file, as it was named.
  explicit CheckProgress(std::string mission);
  CheckProgress(const CheckProgress&) = delete;
  CheckProgress& operator=(const CheckProgress&) = delete;
  ~CheckProgress();

  /// What is done from now on, in a few words; line ends in it are shown as spaces.
  void at(const std::string& work);

 private:
  void run();

  ProgressLine line_;
  std::string mission_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;  // of what follows
  std::condition_variable ended_;
  std::string work_;
  bool end_ = false;
  std::thread teller_;  // last: it uses all of this
};

}  // namespace glider::driver
