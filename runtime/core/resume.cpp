// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A program that starts again: whether the mission goes on where its checkpoint is.

#include "runtime/core/lay_out.h"
#include "runtime/core/runtime.h"
#include "runtime/log/format.h"
#include "runtime/numbers/numbers.h"

using glider::hooks::HookState;
using glider::runtime::Checkpoint;
using glider::runtime::LogDetail;
using glider::runtime::LogEvent;

void GliderRuntime::lookForCheckpoint() {
  GliderContext* context = glider::runtime::layOut(context_memory_, mission_);
  switch (checkpoint_.find(*context, facts_)) {
    case Checkpoint::Found::Good:
      found_ = true;
      client_.resume(facts_.session, static_cast<uint16_t>(facts_.instruction));
      break;
    case Checkpoint::Found::Broken:
      begins_anew_ = LogDetail::NoneIsWhole;
      break;
    case Checkpoint::Found::Foreign:
      begins_anew_ = LogDetail::OtherProgram;
      break;
    case Checkpoint::Found::Nothing:
      break;
  }
}

/// Decides as soon as hookbeh says what became of the flight in which the checkpoint was made.
void GliderRuntime::considerCheckpoint(const glider::hooks::VehicleTick& tick, double sbc_time) {
  if (tick.hook_state == HookState::Ready) {
    // Since the vehicle's mission began nobody has had control: another flight.
    found_ = false;
    begins_anew_ = LogDetail::EarlierFlight;
    client_.resume(0, client_.sequence());
  }
  if (tick.hook_state != HookState::Active && tick.hook_state != HookState::Silent) {
    return;
  }
  found_ = false;
  const double outage = tick.vehicle_time_s - facts_.vehicle_time;
  if (!(outage >= 0.0 && outage <= mission_.resume_within)) {
    log_.event(0.0, LogEvent::ControlLeft,
               outage >= 0.0 ? LogDetail::TooLong : LogDetail::FromTheFuture, outage);
    client_.resume(0, client_.sequence());
    control_.release();
    return;
  }
  context_ = static_cast<GliderContext*>(context_memory_);
  clock_.resume(facts_.origin, facts_.vehicle_time, sbc_time);
  if (tick.obeys_us) {
    control_.resume();
  }
  logged_refusals_ = context_->refused_commands;
  log_.event(context_->mission_time, LogEvent::MissionResumed, LogDetail::None, outage);
}

/// A word for the vehicle's own log.
void GliderRuntime::tellVehicle(const char* what) {
  glider::hooks::MissionNote told;
  told.mission_time_s = context_->mission_time;
  glider::runtime::Text(told.text, glider::hooks::kMostNoteBytes).put(what);
  client_.tell(told);
}

/// Before the answer: what the vehicle has been told is never forgotten. The log first, so that it
/// holds whatever a checkpoint has behind it. A card that fails is told once, and never stops the
/// mission.
void GliderRuntime::commit() {
  log_.flush();
  if (context_ == nullptr) {
    return;
  }
  if (log_.isFailing() && !log_fails_) {
    tellVehicle("the SBC's log is not written");
  }
  log_fails_ = log_.isFailing();
  const Checkpoint::Kept kept = checkpoint_.keep(
      *context_, {clock_.vehicle(), clock_.origin(), client_.session(), client_.sequence()});
  const bool failed = kept == Checkpoint::Kept::Failed;
  if (failed && !not_kept_) {
    log_.event(context_->mission_time, LogEvent::CheckpointNotWritten, LogDetail::None,
               glider::runtime::unknown());
    tellVehicle("the SBC's checkpoint is not written");
  }
  if (kept != Checkpoint::Kept::NotDue) {
    not_kept_ = failed;
  }
}
