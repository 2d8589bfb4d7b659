// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/persistence.h"

#include "runtime/core/assert.h"
#include "runtime/core/continuation.h"
#include "runtime/core/lay_out.h"
#include "runtime/core/soundness.h"
#include "runtime/log/format.h"
#include "runtime/numbers/numbers.h"

using glider::hooks::HookState;

namespace glider::runtime {

void Persistence::look(GliderContext& context) {
  const Checkpoint::Found found = checkpoint_.find(context, facts_);
  if (found == Checkpoint::Found::Good) {
    found_ = true;
    failed_ = context.failed_checks != 0;
    context.failed_checks = 0;  // those of the program that this one replaces
    parts_.client.resume(facts_.session, static_cast<uint16_t>(facts_.instruction));
  } else if (found == Checkpoint::Found::Broken) {
    begins_anew_ = LogDetail::NoneIsWhole;
  } else if (found == Checkpoint::Found::Foreign) {
    begins_anew_ = LogDetail::OtherProgram;
  }
}

bool Persistence::decide(const hooks::VehicleTick& tick, const GliderContext& context,
                         double sbc_time) {
  const bool ready = tick.hook_state == HookState::Ready;
  if (!ready && tick.hook_state != HookState::Active && tick.hook_state != HookState::Silent) {
    return false;
  }
  found_ = false;
  const GliderMission& mission = *context.mission;
  const double outage = ready ? outageByClock(tick) : tick.vehicle_time_s - facts_.vehicle_time;
  switch (continuationAfter({ready, outage, context.finished != 0, mission.resume_within,
                             mission.new_after_restart != 0, failed_})) {
    case Continuation::Begins:
      begins_anew_ = LogDetail::EarlierFlight;
      parts_.client.resume(0, parts_.client.sequence());
      return false;
    case Continuation::Leaves:
      leaveControl(mission, ready, outage);
      return false;
    case Continuation::GoesOn:
      break;
  }
  ClockAnchor anchor{facts_.anchor_vehicle, facts_.anchor_mission};
  if (ready) {  // the vehicle's time has restarted, and does not show the length of the outage
    // The outage counts from the newest frame; the mission's time may have gone on since that.
    const double reached =
        facts_.anchor_mission + (facts_.vehicle_time - facts_.anchor_vehicle) + outage;
    anchor = {tick.vehicle_time_s, reached > context.mission_time ? reached : context.mission_time};
  }
  parts_.clock.resume(anchor, ready ? tick.vehicle_time_s : facts_.vehicle_time, sbc_time);
  if (tick.obeys_us) {
    parts_.control.resume();
  }
  // Logged at the current mission time, not that of the checkpoint.
  parts_.log.event(anchor.mission + (tick.vehicle_time_s - anchor.vehicle),
                   LogEvent::MissionResumed, LogDetail::None, outage);
  return true;
}

/// The outage by the vehicle's clock, s; unknown if the clock was unknown then, or is now.
double Persistence::outageByClock(const hooks::VehicleTick& tick) const {
  return facts_.clock != 0 && tick.clock_s != 0
             ? static_cast<double>(tick.clock_s) - static_cast<double>(facts_.clock)
             : unknown();
}

/// The mission is over. The vehicle's own log says it too, because the SBC's cannot be read at sea.
void Persistence::leaveControl(const GliderMission& mission, bool restarted, double outage) {
  const LogDetail why = failed_                          ? LogDetail::CheckHadFailed
                        : outage != outage               ? LogDetail::UnknownOutage
                        : !(outage >= 0.0)               ? LogDetail::FromTheFuture
                        : outage > mission.resume_within ? LogDetail::TooLong
                                                         : LogDetail::VehicleRestarted;
  parts_.log.event(0.0, LogEvent::ControlLeft, why, outage);
  if (restarted) {
    tellVehicle(0.0, "the mission is over: the vehicle has restarted");
  }
  parts_.client.resume(0, parts_.client.sequence());
  parts_.control.release();
}

void Persistence::waits(double depth) {
  parts_.log.event(0.0, LogEvent::WaitsForSurface, LogDetail::None, depth);
  tellVehicle(0.0, "the mission waits for the surface");
}

void Persistence::bringsUp(double seconds) {
  parts_.log.event(0.0, LogEvent::SurfaceFirst, LogDetail::EarlierTargets, seconds);
  if (!(seconds > 0)) {
    tellVehicle(0.0, "the SBC commands the surface before the mission begins");
  }
}

void Persistence::logs(LogEvent what, LogDetail detail, uint32_t count) {
  const ClockAnchor anchor = parts_.clock.anchor();
  parts_.log.event(anchor.mission + (parts_.clock.vehicle() - anchor.vehicle), what, detail, count);
}

void Persistence::begun() {
  if (begins_anew_ != LogDetail::None) {
    parts_.log.event(0.0, LogEvent::BeginsAnew, begins_anew_, unknown());
  }
}

/// Sends a note to the vehicle's own log.
void Persistence::tellVehicle(double mission_time, const char* what) {
  hooks::MissionNote told;
  told.mission_time_s = mission_time;
  Text(told.text, hooks::kMostNoteBytes).put(what);
  parts_.client.tell(told);
}

/// Writes the log first, so that it contains everything that led to a checkpoint. A card failure is
/// reported once, and never stops the mission.
void Persistence::commit(const GliderContext* context) {
  parts_.log.flush();
  if (context == nullptr || context->failed_checks != 0) {
    return;
  }
  if (parts_.log.isFailing() && !log_fails_) {
    tellVehicle(context->mission_time, "the SBC's log is not written");
  }
  log_fails_ = parts_.log.isFailing();
  const Checkpoint::Kept kept = checkpoint_.keep(*context, facts());
  const bool failed = kept == Checkpoint::Kept::Failed;
  if (failed && !not_kept_) {
    parts_.log.event(context->mission_time, LogEvent::CheckpointNotWritten, LogDetail::None,
                     unknown());
    tellVehicle(context->mission_time, "the SBC's checkpoint is not written");
  }
  if (kept != Checkpoint::Kept::NotDue) {
    not_kept_ = failed;
  }
}

__attribute__((noinline)) LinkFacts Persistence::facts() const {
  return {parts_.clock.vehicle(),  parts_.clock.anchor().vehicle, parts_.clock.anchor().mission,
          parts_.client.session(), parts_.client.sequence(),      parts_.client.tick().clock_s};
}

static_assert(static_cast<uint32_t>(Check::WaitingLateral) -
                  static_cast<uint32_t>(Check::SendQueue) ==
              static_cast<uint32_t>(hooks::ClientPart::Lateral) -
                  static_cast<uint32_t>(hooks::ClientPart::SendQueue));

void Persistence::check(const GliderContext& context, const GliderMission* running) const {
  const auto link = static_cast<uint32_t>(parts_.client.brokenPart());
  Check broken = link == 0 ? parts_.control.brokenPart()
                           : static_cast<Check>(static_cast<uint32_t>(Check::SendQueue) + link - 1);
  if (parts_.log.held() > MissionLog::kBytes) {
    broken = Check::LogBytes;
  } else if (broken == Check::None && running != nullptr) {
    broken = runtime::brokenPart(context, *running);
  }
  if (broken != Check::None) {
    noteFailedCheck(context, broken);
  }
}

void Persistence::giveUp(GliderContext& context, const GliderMission& mission) {
  const uint32_t failed = context.failed_checks;
  const double time = context.mission_time;
  parts_.log.failed(time, firstFailedCheck(context), countOfFailedChecks(context));
  // What else is in the context may be broken, and is not kept.
  layOut(&context, mission);
  context.mission_time = time;
  context.failed_checks = failed;
  (void)checkpoint_.keep(context, facts());
}

}  // namespace glider::runtime
