// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/c/program.h"

#include "platforms/slocum_sensors.h"
#include "runtime/abi/behaviour.h"
#include "runtime/abi/context_layout.h"
#include "runtime/core/instruction.h"
#include "runtime/numbers/numbers.h"

#include <new>

namespace glider::runtime {
namespace {

constexpr GliderSensorInfo kSensors[] = {
#define SENSOR(id, name, to_si, lowest, highest, stale_after, degrees_minutes) \
  {#name, nullptr, to_si, lowest, highest, stale_after, id, degrees_minutes},
    GLIDER_SENSOR_TABLE(SENSOR)
#undef SENSOR
};

/// The vehicle's commands before and after the context is made anew.
void keepCommands(const GliderContext& from, GliderContext& to) {
  to.vertical = from.vertical;
  to.lateral = from.lateral;
  to.depth = from.depth;
  to.pitch = from.pitch;
  to.heading = from.heading;
  to.latitude = from.latitude;
  to.longitude = from.longitude;
  to.refused_commands = from.refused_commands;
}

}  // namespace

Program& Program::instance() {
  static Program program;
  return program;
}

Program::Program() {
  state_.name = "program";
  mission_.abi_version = GLIDER_ABI_VERSION;
  mission_.state_count = 1;
  mission_.states = states_;
  mission_.sensors = sensors_;  // what the program does stands in its own code, between the ticks
  context_->mission = &mission_;
  context_->readings = memory_.readings;
  column_.clear();
}

bool Program::use(uint32_t sensor) {
  for (uint32_t i = 0; i < mission_.sensor_count; ++i) {
    if (sensors_[i].id == sensor) {
      return true;
    }
  }
  if (client_ != nullptr || sensor >= GLIDER_SENSOR_COUNT || mission_.sensor_count == kMost) {
    return false;
  }
  subscription_[mission_.sensor_count] = hooks::usualSubscription(static_cast<uint16_t>(sensor));
  sensors_[mission_.sensor_count] = kSensors[sensor];
  ++mission_.sensor_count;
  return true;
}

void Program::open() {
  hooks::ClientOptions options;
  options.mission_name = link_.mission_name;
  options.sensors = subscription_;
  options.sensor_count = mission_.sensor_count;
  mission_.name = link_.mission_name;
  client_ = ::new (client_memory_) hooks::Client(options);
  log_ = ::new (log_memory_) MissionLog(link_.log, mission_);
}

bool Program::nextTick() {
  if (link_.wait == nullptr) {
    return false;  // never opened
  }
  if (client_ == nullptr) {
    open();
  }
  answer();
  while (!control_.released()) {
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
      case hooks::ClientEvent::SilentLink:
        if (started_ && !finished_) {
          gliderStep(context_, clock_.withoutFrame(link_.clock.now(link_.clock.self)), nullptr, 0);
          return true;
        }
        break;
      default:
        break;
    }
  }
  return false;
}

/// Takes in a frame; true if the program has to look at it.
bool Program::takeTick() {
  const hooks::VehicleTick& tick = client_->tick();
  must_answer_ = true;
  const ControlNews news = control_.observe(tick);
  if (news.kind == ControlNews::Kind::Refused) {
    log_->event(context_->mission_time, LogEvent::InstructionRefused,
                static_cast<LogDetail>(news.answer), static_cast<double>(news.sequence));
  }
  for (uint32_t i = 0; i < tick.reading_count; ++i) {
    updates_[i] = {tick.readings[i].value, tick.readings[i].id, 0};
  }
  const double sbc_time = link_.clock.now(link_.clock.self);
  if (started_) {
    const double time = clock_.atFrame(tick.vehicle_time_s, sbc_time);
    gliderStep(context_, time, updates_, tick.reading_count);
  } else if (control_.mayTake()) {
    start(tick.vehicle_time_s, sbc_time);
  }
  if (started_) {
    record();
  }
  return started_ && !finished_;
}

void Program::start(double vehicle_time, double sbc_time) {
  const GliderContext before = *context_;
  clock_.start(vehicle_time, sbc_time);
  context_ = gliderStart(&memory_, &mission_, nullptr, updates_, client_->tick().reading_count);
  keepCommands(before, *context_);
  log_->begin(*context_);
  started_ = true;
}

void Program::record() {
  const double depth = gliderRead(context_, GLIDER_M_DEPTH);
  const double temperature = gliderRead(context_, GLIDER_SCI_WATER_TEMP);
  if (gliderAge(context_, GLIDER_SCI_WATER_TEMP) == 0.0 && depth == depth &&
      temperature == temperature) {
    column_.record(context_->mission_time, depth, temperature);
  }
}

void Program::beginLeg() {
  leg_began_ = context_->mission_time;
}

void Program::answer() {
  if (!must_answer_) {
    return;
  }
  must_answer_ = false;
  hooks::MissionStatus status;
  if (started_) {
    hooks::Instruction instruction;
    if (control_.choose(instructionFor(*context_), finished_, instruction)) {
      control_.sent(instruction, client_->instruct(instruction));
    }
    status.mission_time_s = context_->mission_time;
    status.phase = finished_ ? hooks::MissionPhase::Finished : hooks::MissionPhase::Flying;
  }
  client_->done(status, link_.stream);
  log_->flush();
}

}  // namespace glider::runtime
