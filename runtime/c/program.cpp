// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/c/program.h"

#include "runtime/abi/behaviour.h"
#include "runtime/abi/context_layout.h"
#include "runtime/c/glider.h"
#include "runtime/c/vehicle.h"
#include "runtime/core/instruction.h"
#include "runtime/core/lay_out.h"
#include "runtime/core/tell_notes.h"
#include "runtime/numbers/numbers.h"

#include <new>
#include <string.h>

/// Linked only if the mission calls them, or setPitchBattery.
extern "C" __attribute__((weak)) void holdFin(double angle);
extern "C" __attribute__((weak)) void setPump(double cc);

namespace glider::runtime {
namespace {

/// The default of the mission language, s.
constexpr double kResumeWithin = 300;

/// The number of doubles that hold `bytes` bytes.
uint32_t slotsFor(size_t bytes) {
  return static_cast<uint32_t>((bytes + sizeof(double) - 1) / sizeof(double));
}

/// Copies the commands that the program gave before its mission began.
void keepCommands(const GliderContext& from, GliderContext& to) {
  to.vertical = from.vertical;
  to.lateral = from.lateral;
  to.depth = from.depth;
  to.pitch = from.pitch;
  to.heading = from.heading;
  to.magnetic = from.magnetic;
  to.latitude = from.latitude;
  to.longitude = from.longitude;
  to.refused_commands = from.refused_commands;
}

}  // namespace

Program& Program::instance() {
  static Program program;
  return program;
}

Program::Program()
    : compass_{unknown(), gliderVehicle.dictionary->roles[kGliderRoleMagneticVariation], 0,
               gliderConvertHeadings},
      variation_(unknown()) {
  state_.name = "program";
  mission_.abi_version = GLIDER_ABI_VERSION;
  mission_.state_count = 1;
  mission_.states = states_;
  mission_.sensors = sensors_;  // what the program does is in its own code, between the ticks
  mission_.resume_within = kResumeWithin;
  mission_.compass = &compass_;
  mission_.dictionary = gliderVehicle.dictionary;
  wanted_.mission = &nothing_;
  water_.column.clear();
}

bool Program::use(uint32_t sensor) {
  for (uint32_t i = 0; i < mission_.sensor_count; ++i) {
    if (sensors_[i].id == sensor) {
      return true;
    }
  }
  if (client_ != nullptr || sensor >= gliderVehicle.dictionary->count ||
      mission_.sensor_count == kMost) {
    return false;
  }
  hookUsualSubscription(gliderVehicle.dictionary, static_cast<uint16_t>(sensor),
                        &subscription_[mission_.sensor_count]);
  sensors_[mission_.sensor_count] = gliderVehicle.sensors[sensor];
  ++mission_.sensor_count;
  return true;
}

void Program::open() {
  (void)use(compass_.variation);  // if there is no room for it, the declination is used
  hooks::ClientOptions options;
  options.mission_name = link_.mission_name;
  options.sensors = subscription_;
  options.sensor_count = mission_.sensor_count;
  options.features.needs =
      static_cast<uint16_t>((holdFin != nullptr ? hooks::kFeatureFixedFin : 0) |
                            (setPump != nullptr ? hooks::kFeatureActuators : 0));
  mission_.name = link_.mission_name;
  client_ = ::new (client_memory_) hooks::Client(*gliderVehicle.dictionary, options);
  log_ = ::new (log_memory_) MissionLog(link_.log, mission_);
  link_log_ = ::new (link_log_memory_) LinkLog(*log_);
  // A change of a variable requires a checkpoint; a change of the water column does not.
  mission_.variable_count = slotsFor(sizeof limits_ + kept_.size());
  mission_.temporal_slots = slotsFor(sizeof water_);
  mission_.context_bytes = static_cast<uint32_t>(gliderContextLayout(&mission_).bytes);
  persistence_ = ::new (persistence_memory_) Persistence(
      Checkpoint(link_.checkpoints, link_.program), {*client_, control_, clock_, *log_});
  persistence_->look(*layOut(memory_, mission_));
}

bool Program::nextTick() {
  if (!isAttached()) {
    return false;
  }
  if (client_ == nullptr) {
    open();
  }
  if (look_again_) {
    look_again_ = false;
    return true;
  }
  answer();
  while (!isBroken() && !control_.released()) {
    switch (client_->poll(link_.stream, link_.clock)) {
      case hooks::ClientEvent::Nothing:
        if (link_.wait() == 0) {
          return false;
        }
        break;
      case hooks::ClientEvent::Closed:
        return false;
      case hooks::ClientEvent::Tick:
        if (takeTick()) {
          return true;
        }
        answer();
        break;
      case hooks::ClientEvent::Refused:
        link_log_->refusedLink(client_->refusal());
        break;
      case hooks::ClientEvent::SilentLink:
        if (tickOfClockAlone()) {
          return true;
        }
        break;
      case hooks::ClientEvent::Handled:
        break;
    }
  }
  return false;
}

bool Program::require(bool holds, Check check) {
  if (!holds) {
    noteFailedCheck(*context_, check);
  }
  return holds;
}

/// True if a check of the program's own memory has failed. The first time, the log reports it.
bool Program::isBroken() {
  if (silent_) {
    return true;
  }
  persistence_->check(*context_, started_ ? &mission_ : nullptr);
  if (context_->failed_checks != 0) {
    silent_ = true;
    auto& memory = *reinterpret_cast<GliderContext*>(memory_);
    memory.failed_checks = context_->failed_checks;
    context_ = &memory;
    persistence_->giveUp(memory, mission_);
  }
  return silent_;
}

bool Program::takeResume() {
  const bool just = just_resumed_;
  just_resumed_ = false;
  look_again_ = look_again_ || just;
  return just;
}

bool Program::tickOfClockAlone() {
  if (!started_ || finished_) {
    return false;
  }
  gliderStep(context_, clock_.withoutFrame(link_.clock.now(link_.clock.self)), nullptr, 0);
  link_log_->silence(*context_);
  ticked_ = true;
  return true;
}

/// Takes in a frame; true if the program must process it.
bool Program::takeTick() {
  const hooks::VehicleTick& tick = client_->tick();
  const double sbc_time = client_->virtualTime() ? static_cast<double>(tick.clock_s)
                                                 : link_.clock.now(link_.clock.self);
  ticked_ = true;
  must_answer_ = true;
  if (persistence_->isUndecided()) {
    tryToGoOn(tick, sbc_time);
  }
  const ControlNews news = control_.observe(tick);
  for (uint32_t i = 0; i < tick.reading_count; ++i) {
    updates_[i] = {tick.readings[i].value, tick.readings[i].id, 0};
  }
  const uint32_t updates = compass_.convert(&mission_, started_ ? context_ : nullptr, &variation_,
                                            updates_, tick.reading_count);
  if (started_) {
    const double time = clock_.atFrame(tick.vehicle_time_s, tick.cycle, sbc_time);
    gliderStep(context_, time, updates_, updates);
  } else if (!persistence_->isUndecided() && !control_.released() && control_.mayTake()) {
    start(tick.vehicle_time_s, sbc_time, updates);
  }
  if (started_) {
    record();
    link_log_->news(*context_, news);
    link_log_->unanswered(*context_, tick);
  }
  return started_ && !finished_ && context_->failed_checks == 0;
}

void Program::start(double vehicle_time, double sbc_time, uint32_t updates) {
  clock_.start(vehicle_time, sbc_time);
  context_ = gliderStart(memory_, &mission_, nullptr, updates_, updates);
  keepCommands(wanted_, *context_);
  log_->begin(*context_);
  persistence_->begun();
  started_ = true;
}

void Program::tryToGoOn(const hooks::VehicleTick& tick, double sbc_time) {
  auto* found = reinterpret_cast<GliderContext*>(memory_);
  if (persistence_->decide(tick, *found, sbc_time)) {
    context_ = found;
    restore();
    link_log_->resume(*context_);
    started_ = resumed_ = just_resumed_ = true;
    finished_ = context_->finished != 0;
  }
}

/// Copies the state outside the context to where checkpoints keep it.
void Program::save() {
  auto* variables = reinterpret_cast<uint8_t*>(context_->variables);
  memset(variables, 0, mission_.variable_count * sizeof(double));
  memcpy(variables, &limits_, sizeof limits_);
  kept_.save(variables + sizeof limits_);
  memcpy(context_->temporals, &water_, sizeof water_);
  context_->finished = finished_ ? 1 : 0;
}

void Program::restore() {
  const auto* variables = reinterpret_cast<const uint8_t*>(context_->variables);
  memcpy(&limits_, variables, sizeof limits_);
  kept_.restore(variables + sizeof limits_);
  static_assert(__is_trivially_copyable(Water) && __is_trivially_copyable(Limits));
  memcpy(static_cast<void*>(&water_), context_->temporals, sizeof water_);
}

void Program::record() {
  const double depth = gliderRead(context_, gliderSensorOf(context_, kGliderRoleDepth));
  const uint32_t thermometer = gliderSensorOf(context_, kGliderRoleWaterTemperature);
  const double temperature = gliderRead(context_, thermometer);
  if (gliderAge(context_, thermometer) == 0.0 && depth == depth && temperature == temperature) {
    water_.column.record(context_->mission_time, depth, temperature);
  }
}

void Program::note(const char* text, const double* values, uint32_t count) {
  if (!started_) {
    return;
  }
  gliderNote(context_, kGliderNoteLog, text, values, count);
  tellNow();
}

/// Notes are sent at once: their text may no longer exist when the tick is answered.
void Program::tellNow() {
  tellNotes(*context_, *log_, *client_);
  context_->note_count = 0;
  context_->note_value_count = 0;
  context_->lost_notes = 0;
}

void Program::beginLeg() {
  water_.leg_began = context_->mission_time;
}

/// Writes the results of the current tick to the card, then sends them to the vehicle.
void Program::answer() {
  if (!ticked_) {
    return;
  }
  ticked_ = false;
  hooks::MissionStatus status;
  if (started_) {
    compass_.convert(&mission_, context_, &variation_, nullptr, 0);
    tellNow();
    hooks::Instruction instruction;
    // The SBC never speaks first: what a tick without a frame commands goes with the next answer.
    if (must_answer_ && control_.choose(instructionFor(*context_), finished_, instruction)) {
      control_.sent(instruction, client_->instruct(instruction));
    }
    link_log_->refusedCommands(*context_);
    status.mission_time_s = context_->mission_time;
    status.phase = finished_ ? hooks::MissionPhase::Finished : hooks::MissionPhase::Flying;
    if (require(kept_.isSound(), Check::KeptPieces)) {
      save();
    }
  }
  persistence_->commit(started_ ? context_ : nullptr);
  if (must_answer_ && context_->failed_checks == 0) {
    must_answer_ = false;
    client_->done(status, link_.stream);
  }
}

}  // namespace glider::runtime
