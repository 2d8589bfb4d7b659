// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/line_reader.h"

#include <cstdint>
#include <optional>

namespace glider::simulator::remus100 {

/// How the override ended.
enum class OverrideEnd : uint8_t { Released, TimedOut, Restarted };

/// What the SBC has given the vehicle; in RECON's units.
struct Given {
  double heading_deg = 0;
  double speed_m_s = 0;
  double depth_m = 0;
};

/// The part of the vehicle's software that lets the SBC override its own mission. RECON does not
/// say what happens when goals stop: this one ends the override after `timeout_s`.
class Override {
 public:
  explicit Override(double timeout_s) : timeout_s_(timeout_s) {}

  /// Takes a line of the SBC.
  void take(const hooks::recon::Line& line, double now_s);
  /// Ends the override if its goals have stopped.
  void look(double now_s);
  /// The computer restarts.
  void restart() { end(OverrideEnd::Restarted); }

  [[nodiscard]] bool isOn() const { return on_; }
  /// What it is given; empty before it has heading, speed and depth.
  [[nodiscard]] std::optional<Given> given() const;
  /// How the override ended since the last call, if it did.
  std::optional<OverrideEnd> takeEnd();

 private:
  void end(OverrideEnd how);

  double timeout_s_;
  bool on_ = false;
  std::optional<double> heading_deg_, speed_m_s_, depth_m_;
  double heard_s_ = 0;
  std::optional<OverrideEnd> ended_;
};

}  // namespace glider::simulator::remus100
