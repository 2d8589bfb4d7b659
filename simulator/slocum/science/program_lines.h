// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <chrono>
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
  /// Seconds of real time in which it must take what it is sent and answer all of it.
  static constexpr int kHangSecs = 10;
  /// Bytes of its answer at most.
  static constexpr size_t kMostAnswer = 1U << 20U;

  /// Null, with the reason in `why`, if it cannot be started.
  static std::unique_ptr<ProgramLines> start(const std::vector<std::string>& command,
                                             std::string& why);
  ~ProgramLines();
  ProgramLines(const ProgramLines&) = delete;
  ProgramLines& operator=(const ProgramLines&) = delete;

  /// Sends it lines, whose answer is then received. False if the program is gone or hung.
  bool send(std::string_view lines);
  /// Its next line, without the end. False if it is gone or hung, or its answer has no end.
  bool receive(std::string& line);
  /// "ended with status 2", "has not answered for 10 s": why send or receive has failed.
  [[nodiscard]] std::string trouble();

 private:
  ProgramLines(pid_t pid, int socket) : pid_(pid), socket_(socket) {}

  /// Waits until the socket is ready. False after the time for an answer.
  bool wait(short events);

  pid_t pid_;
  int socket_;
  std::string unread_;
  std::chrono::steady_clock::time_point until_;  ///< the answer must be there
  size_t received_ = 0;                          ///< bytes of this answer
  std::string trouble_;
};

}  // namespace glider::simulator
