// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/sentence.h"
#include "vehicles/dock.h"

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace glider::slocum {

/// Sentences on the line of a check, counted.
class DockLine {
 public:
  explicit DockLine(const vehicles::DockHost& host) : host_(host) {}

  /// Counted from the first good sentence on: what arrives before may have begun before the check.
  struct Counts {
    uint64_t bytes = 0;  ///< all, from the first on
    uint64_t sentences = 0;
    uint32_t damaged = 0;  ///< sentences with a wrong sum, cut off, or too long
    uint64_t stray = 0;    ///< bytes that belong to no good sentence
    uint32_t echoes = 0;   ///< sentences that came back as they were sent
    uint64_t sent_bytes = 0;
    uint64_t sent_sentences = 0;
  };

  /// The bodies that have arrived since the last call, without echoes. Also sends what waits.
  std::vector<std::string> hear();
  void say(const std::string& body);
  /// Everything that was said has left.
  [[nodiscard]] bool isIdle() const { return out_.empty(); }
  [[nodiscard]] bool gone() const { return gone_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  /// The first bytes that arrived: what they look like says what is there.
  [[nodiscard]] const std::string& beginning() const { return beginning_; }
  static constexpr size_t kMostBeginning = 200;
  /// Reads and forgets what has arrived, and counts from 0.
  void restart();

 private:
  bool take(uint8_t byte);
  bool isEcho(const std::string& body);
  void flush();

  const vehicles::DockHost& host_;
  hooks::extctl::SentenceReader reader_;
  uint32_t bad_before_ = 0;   ///< of the reader
  uint64_t in_sentence_ = 0;  ///< bytes since the end of the last one
  Counts counts_;
  std::deque<std::string> said_;  ///< the newest
  std::string beginning_;
  std::string out_;
  bool gone_ = false;
};

}  // namespace glider::slocum
