// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/host/serial_port.h"
#include "simulator/ports/line_turns.h"
#include "simulator/ports/sbc_port.h"
#include "support/result.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::simulator {

/// A real SBC at the other end of a serial line; it must already be running.
class SerialSbcPort final : public SbcPort {
 public:
  enum class Pace : uint8_t {
    RealTime,  ///< a second of the flight takes a second, and the SBC's own clock counts
    Lockstep   ///< the vehicle's clock waits for each answer, and the SBC's for the vehicle's
  };
  /// Real time without an answer in lockstep after which the SBC counts as hung, s.
  static constexpr double kHangSecs = 10;

  /// The line of the science computer's hookprog, bits/s.
  static constexpr uint32_t kHookBaud = 115200;

  /// Opens `device`. `turns`: of what is spoken on the line. GL9100 to GL9105.
  static support::Result<std::unique_ptr<SerialSbcPort>> open(
      const std::string& device, Pace pace, uint32_t baud = kHookBaud,
      std::unique_ptr<LineTurns> turns = hookTurns());

  [[nodiscard]] std::string way() const override { return "serial"; }
  void deliver(std::span<const uint8_t> bytes, double now_s) override;
  std::vector<uint8_t> collect() override;
  /// Its power cannot be switched from here: the line is cut instead.
  void kill() override { end("cut off"); }
  [[nodiscard]] bool alive() const override { return exit_reason_.empty(); }
  [[nodiscard]] bool keepsTime() const override { return pace_ == Pace::RealTime; }
  void plug(bool in) override { plugged_ = in; }
  [[nodiscard]] std::string exitReason() const override { return exit_reason_; }

 private:
  using Clock = std::chrono::steady_clock;

  SerialSbcPort(hooks::SerialPort port, Pace pace, std::unique_ptr<LineTurns> turns)
      : port_(std::move(port)), pace_(pace), turns_(std::move(turns)) {}
  void waitFor(double now_s);
  void read();
  void end(const char* exit_reason);
  /// How long to wait for an answer, s.
  [[nodiscard]] double patience() const;

  hooks::SerialPort port_;
  Pace pace_;
  std::unique_ptr<LineTurns> turns_;
  std::vector<uint8_t> received_;
  std::optional<Clock::time_point> origin_;  ///< vehicle time 0
  bool plugged_ = true;
  std::string exit_reason_;
};

}  // namespace glider::simulator
