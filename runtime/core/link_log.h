// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/core/control.h"
#include "runtime/log/mission_log.h"

/// What the mission log has of the link: who has control, and what was refused.
namespace glider::runtime {

class LinkLog {
 public:
  /// `log` outlives this.
  explicit LinkLog(MissionLog& log) : log_(log) {}

  /// What the newest tick told of control.
  void news(const GliderContext& context, const ControlNews& news);
  /// Told once, when the client stops claiming control.
  void unanswered(const GliderContext& context, const hooks::VehicleTick& tick);
  /// Commands with unknown values since the last call.
  void refusedCommands(const GliderContext& context);
  /// Those of before are told already: the mission goes on from a checkpoint.
  void resume(const GliderContext& context) { told_refusals_ = context.refused_commands; }
  /// There is no link, for it was refused; written at once, for no tick may follow.
  void refusedLink(const hooks::Refusal& refusal);
  /// A tick of the SBC's own clock.
  void silence(const GliderContext& context);

 private:
  MissionLog& log_;
  uint32_t told_refusals_ = 0;
};

}  // namespace glider::runtime
