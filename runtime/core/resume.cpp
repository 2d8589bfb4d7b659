// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A program that starts again: whether the mission goes on where its checkpoint is.

#include "runtime/core/lay_out.h"
#include "runtime/core/runtime.h"
#include "runtime/numbers/numbers.h"

using glider::hooks::HookState;
using glider::runtime::Checkpoint;

void GliderRuntime::lookForCheckpoint() {
  GliderContext* context = glider::runtime::layOut(context_memory_, mission_);
  switch (checkpoint_.find(*context, facts_)) {
    case Checkpoint::Found::Good:
      found_ = true;
      client_.resume(facts_.session, static_cast<uint16_t>(facts_.instruction));
      break;
    case Checkpoint::Found::Broken:
      begins_anew_ = "no checkpoint is whole";
      break;
    case Checkpoint::Found::Foreign:
      begins_anew_ = "the checkpoint is another program's";
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
    begins_anew_ = "the checkpoint is of an earlier flight";
    client_.resume(0, client_.sequence());
  }
  if (tick.hook_state != HookState::Active && tick.hook_state != HookState::Silent) {
    return;
  }
  found_ = false;
  const double outage = tick.vehicle_time_s - facts_.vehicle_time;
  if (!(outage >= 0.0 && outage <= mission_.resume_within)) {
    log_.event(0.0, "control left to the vehicle",
               outage >= 0.0 ? "the outage was too long" : "the checkpoint is from the future",
               outage);
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
  log_.event(context_->mission_time, "mission resumed", "", outage);
}

/// Before the answer: what the vehicle has been told is never forgotten.
void GliderRuntime::keepCheckpoint() {
  const Checkpoint::Kept kept = checkpoint_.keep(
      *context_, {clock_.vehicle(), clock_.origin(), client_.session(), client_.sequence()});
  if (kept == Checkpoint::Kept::Failed && !not_kept_) {
    log_.event(context_->mission_time, "checkpoint not written", "", glider::runtime::unknown());
  }
  if (kept != Checkpoint::Kept::NotDue) {
    not_kept_ = kept == Checkpoint::Kept::Failed;
  }
}
