// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/host/pty.h"
#include "simulator/ports/line_turns.h"
#include "simulator/ports/sbc_port.h"
#include "support/result.h"

#include <filesystem>
#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace glider::simulator {

/// An SBC that is a separate program behind a pseudo-terminal: the host's binary, or a board's
/// under an emulator.
class ProcessSbcPort final : public SbcPort {
 public:
  /// Seconds of real time without an answer after which the program counts as hung.
  static constexpr double kHangSecs = 10;

  /// Starts `command`, a program found by PATH and its arguments; the argument "{port}" is replaced
  /// by the terminal's name. Its standard output is discarded. It ends with this process. `card`:
  /// the file of its checkpoints, for faults of the card; may be empty. `turns`: of what the
  /// program speaks. GL9150 when it cannot be started, GL9106 without a terminal.
  static support::Result<std::unique_ptr<ProcessSbcPort>> start(
      std::string way, std::vector<std::string> command, double hang_secs = kHangSecs,
      std::filesystem::path card = {}, std::unique_ptr<LineTurns> turns = hookTurns());
  ~ProcessSbcPort() override;

  [[nodiscard]] std::string way() const override { return way_; }
  void deliver(std::span<const uint8_t> bytes, double now_s) override;
  std::vector<uint8_t> collect() override;
  void kill() override;
  [[nodiscard]] bool alive() const override { return pid_ > 0; }
  void damageCard(const CardFault& fault, uint64_t seed) override;
  [[nodiscard]] std::string exitReason() const override { return exit_reason_; }
  /// For tests and logs; 0 when it is gone.
  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  ProcessSbcPort(std::string way, hooks::Pty pty, double hang_secs,
                 std::unique_ptr<LineTurns> turns)
      : way_(std::move(way)),
        pty_(std::move(pty)),
        hang_secs_(hang_secs),
        turns_(std::move(turns)) {}
  /// Waits up to `milliseconds` for the terminal to be readable, or writable too; reads what is
  /// there.
  void wait(bool to_write, int milliseconds);
  void read();
  /// True when it owes an answer. Only then is its end noticed: the moment at which a program ends
  /// by itself is in real time, and a flight must not depend on that.
  [[nodiscard]] bool missed() const { return alive() && !turns_->settled(); }
  /// Collects the exit status if the program has ended; `block` waits for it. `killed` is the exit
  /// reason if SIGKILL ended it.
  void reap(bool block, const std::string& killed = "");
  void destroy(const std::string& exit_reason);
  /// The program has closed the terminal: it has ended, or will be ended.
  void closed();

  std::string way_;
  hooks::Pty pty_;
  double hang_secs_;
  std::filesystem::path card_;
  std::unique_ptr<LineTurns> turns_;
  std::vector<uint8_t> received_;
  bool heard_ = false;  ///< it has opened the terminal and sent bytes
  pid_t pid_ = 0;
  std::string exit_reason_;
};

}  // namespace glider::simulator
