// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace glider::simulator {

/// A program that is asked and answers in lines, on its standard input and output. It is ended with
/// this.
class ProgramLines {
 public:
  /// Seconds of real time without a line after which the program counts as hung.
  static constexpr int kHangSecs = 10;

  /// Null, with the reason in `why`, if it cannot be started.
  static std::unique_ptr<ProgramLines> start(const std::vector<std::string>& command,
                                             std::string& why);
  ~ProgramLines();
  ProgramLines(const ProgramLines&) = delete;
  ProgramLines& operator=(const ProgramLines&) = delete;

  /// False if the program is gone.
  bool send(std::string_view lines);
  /// Its next line, without the end. False if it is gone, hung, or writes a line without an end.
  bool receive(std::string& line);
  /// "ended with status 2", "has not answered for 10 s": why send or receive has failed.
  [[nodiscard]] std::string trouble();

 private:
  ProgramLines(pid_t pid, int socket) : pid_(pid), socket_(socket) {}

  pid_t pid_;
  int socket_;
  std::string unread_;
  bool hung_ = false;
};

}  // namespace glider::simulator
