// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/core/control.h"
#include "runtime/log/mission_log.h"

/// Writes the events of the link to the mission log: who has control, and what was refused.
namespace glider::runtime {

class LinkLog {
 public:
  /// `log` outlives this.
  explicit LinkLog(MissionLog& log) : log_(log) {}

  /// Logs what the newest tick reported about control.
  void news(const GliderContext& context, const ControlNews& news);
  /// Called once, when the client stops claiming control.
  void unanswered(const GliderContext& context, const hooks::VehicleTick& tick);
  /// Commands with unknown values since the last call.
  void refusedCommands(const GliderContext& context);
  /// The mission continues from a checkpoint: earlier refusals were already logged.
  void resume(const GliderContext& context) { told_refusals_ = context.refused_commands; }
  /// The link was refused. Written at once, because no tick may follow.
  void refusedLink(const hooks::Refusal& refusal);
  /// What has arrived damaged since the start, as a sum. What is new is logged, at most once a
  /// minute: noise must not fill the log.
  void damagedInput(const GliderContext& context, uint32_t sum);
  static constexpr uint32_t kBetweenDamages = 15;
  /// The SBC will sleep for at most so many seconds.
  void sleeps(const GliderContext& context, uint32_t seconds);
  /// What the vehicle kept made the mission do something `seconds` before it was woken for that.
  void wokenLate(const GliderContext& context, double seconds);
  /// A tick of the SBC's own clock.
  void silence(const GliderContext& context);

 private:
  MissionLog& log_;
  uint32_t told_refusals_ = 0;
  uint32_t told_damages_ = 0;
  uint32_t damage_told_ticks_ = 0;  ///< until more of it is logged
};

}  // namespace glider::runtime
