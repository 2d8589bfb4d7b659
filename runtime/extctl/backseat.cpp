// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/extctl/backseat.h"

#include "hooks/protocol/numbers.h"
#include "runtime/extctl/subscribed.h"

#include <string.h>

namespace glider::runtime::extctl {

using hooks::extctl::PortSensor;

namespace {

/// In heights of the yo that holds a depth: it goes up to its upper end, and past that.
constexpr double kForget = 1.5;
constexpr double kCmPerM = 100;
/// What has left within this time counts as written when it was made, s.
constexpr double kPrompt = 10;
/// Up to this depth, m, a vehicle that has the command to surface is there.
constexpr double kAtSurface = 1;

/// As the checkpoint has it; the clock unknown if it was.
VehicleMission heardBefore(const LinkFacts& facts) {
  return {.time_s = facts.vehicle_time,
          .clock_s = facts.clock != 0 ? static_cast<double>(facts.clock) : __builtin_nan("")};
}

/// Nothing is known of the heading that is in force, so none is written.
StockCommand firstCommand(const GliderPortMission& port) {
  StockCommand stock;
  stock.heading_rad = __builtin_nan("");
  stock.dive_pitch_rad = -kUsualPitch;
  stock.climb_pitch_rad = kUsualPitch;
  stock.dive_depth_m = port.hold_m;
  return stock;
}

/// As before the first command in the mission file: at the surface, and just below it.
StockCommand safeCommand(const GliderPortMission& port) {
  StockCommand stock = firstCommand(port);
  stock.dive_depth_m = hooks::extctl::kFirstDiveDepth;
  return stock;
}

StandIn standInFor(const GliderPortMission& port, const LinkFacts* checkpoint) {
  const VehicleMission last = checkpoint != nullptr ? heardBefore(*checkpoint) : VehicleMission{};
  return {port, checkpoint != nullptr ? &last : nullptr};
}

}  // namespace

Backseat::Backseat(const GliderMission& mission, const GliderPortMission& port,
                   const GliderByteStream& line, const BackseatOptions& options)
    : dictionary_(*mission.dictionary),
      compass_(mission.compass),
      mission_(port),
      start_depth_cm_(mission.start_depth_cm),
      line_(line),
      port_(portOf(mission, port)),
      reported_(port_.count()),
      stand_in_(standInFor(port, options.checkpoint)),
      depth_seen_(kForget * port.hold_m),
      stock_(firstCommand(port)),
      writer_(port, options.checkpoint == nullptr),
      inner_(*mission.dictionary, {this, hear, answer, closed, reading, instruct, state, clock}) {}

double Backseat::clock(void* self) {
  return static_cast<Backseat*>(self)->reported(kGliderRoleClock);
}

double Backseat::reported(GliderRole role) const {
  return reported(uint32_t{hooks::sensorOf(dictionary_, role)});
}

double Backseat::reported(uint32_t sensor) const {
  const uint32_t index = port_.indexOf(static_cast<uint16_t>(sensor));
  return index < port_.count() ? reported_.value(index) : __builtin_nan("");
}

/// Reads what is there into the empty buffer; false if there is nothing.
bool Backseat::fill() {
  const int32_t count = line_.read(line_.self, in_, sizeof in_);
  line_closed_ = line_closed_ || count < 0;
  in_next_ = 0;
  in_end_ = count > 0 ? static_cast<uint32_t>(count) : 0;
  return in_end_ != 0;
}

/// Takes what has arrived on the port until a cycle is complete or nothing is left. Bounded, so
/// that a port full of noise cannot keep the program from its other work.
void Backseat::hear(void* self) {
  auto& seat = *static_cast<Backseat*>(self);
  seat.flush();
  constexpr uint32_t kMostBytesAtOnce = 4096;
  const uint32_t before = seat.inner_.cycles();
  for (uint32_t i = 0; i < kMostBytesAtOnce && seat.inner_.cycles() == before; ++i) {
    if (seat.in_next_ == seat.in_end_ && !seat.fill()) {
      return;
    }
    if (seat.sentences_.push(seat.in_[seat.in_next_++])) {
      // Before the cycle that this may end.
      seat.damaged_ = seat.sentences_.bad() + seat.reported_.bad();
      seat.takeSentence();
    }
  }
}

void Backseat::takeSentence() {
  const char* body = sentences_.body();
  const uint32_t size = sentences_.size();
  const auto is = [&](const char* name) {
    return size >= 2 && body[0] == name[0] && body[1] == name[1] && (size == 2 || body[2] == ',');
  };
  if (is("SD")) {
    if (size > 3 && reported_.take(body + 3, size - 3)) {
      takeCycle();
    }
  } else if (is("HI") || is("BY")) {
    writer_.forget();
    stand_in_.forget();
    brings_up_ = false;
    using hooks::extctl::kVirtualTimeHello;
    const uint32_t length = sizeof(kVirtualTimeHello) - 1;
    if (!virtual_time_ && size == length && memcmp(body, kVirtualTimeHello, length) == 0) {
      virtual_time_ = true;  // a simulator says it first of all
      inner_.useVirtualTime();
    }
  }
}

/// All readings of a control cycle are there.
void Backseat::takeCycle() {
  stand_in_.observe({.time_s = reported(kGliderRoleMissionTime),
                     .clock_s = reported(kGliderRoleClock),
                     .program = reported_.value(PortSensor::Program),
                     .in_glider_dos = reported_.value(PortSensor::InGliderDos),
                     .at_surface = start_depth_cm_ == 0 ||
                                   reported(kGliderRoleDepth) * kCmPerM <= start_depth_cm_},
                    out_next_ == out_end_);
  depth_seen_.look(reported(kGliderRoleDepth));
  depth_state_.look(reported(kGliderRoleDepth), reported(kGliderRoleClock));
  if (stand_in_.takeRestart()) {
    beginMission();
  }
  inner_.cycle();
}

/// The vehicle flies its mission file from the start: what was written before is void.
void Backseat::beginMission() {
  writer_ = PortWriter(mission_, stand_in_.knowsStart());
  stock_ = firstCommand(mission_);
  wants_surface_ = false;
}

/// The variation as the mission's compass takes it: a value beyond half a turn is none, and until
/// there is one the mission's own declination counts.
Whereabouts Backseat::whereabouts() const {
  constexpr double kHalfTurn = 3.141592653589793;
  const double told = reported(kGliderRoleMagneticVariation);
  const double assumed = compass_ != nullptr ? -compass_->declination : __builtin_nan("");
  return {reported(mission_.latitude), reported(mission_.longitude),
          hookMagnitude(told) <= kHalfTurn ? told : assumed, depth_seen_.deep()};
}

/// The program has answered a cycle: sends the vehicle what is in force now. While the line is
/// stuck nothing counts as written; what matters is written again.
void Backseat::answer(void* self) {
  static_cast<Backseat*>(self)->answerCycle();
}

void Backseat::answerCycle() {
  if (out_next_ != out_end_) {
    flush();
    return;
  }
  const double now_s = reported(kGliderRoleClock);
  if (now_s - stuck_since_s_ > kPrompt) {
    writer_.forget();  // it did not settle while it was stuck here
  }
  if (const hooks::Instruction* command = stand_in_.inForce()) {
    follow(*command, mission_, whereabouts(), stock_);
  }
  if (stand_in_.released()) {
    stock_.surface = true;
    stock_.modes = kGliderPortModeSurface;
    writer_.insist();
  }
  brings_up_ = stand_in_.makesSafe();
  if (brings_up_) {
    stock_ = safeCommand(mission_);
  }
  const bool steers = stand_in_.state() == hooks::HookState::Active || stand_in_.released() ||
                      stand_in_.makesSafe();
  wants_surface_ = steers && stock_.surface;
  depth_moves_ = depth_moves_ && !(steers && !stock_.surface);
  if (steers) {
    writer_.tell(stock_, now_s);
  }
  const hooks::SbcView view = inner_.sbc();
  const bool flies = view.phase == hooks::MissionPhase::Flying;
  const uint32_t text = writeText(out_, sizeof out_ - PortWriter::kMostBytes);
  out_next_ = 0;
  out_end_ = text + writer_.write({flies ? view.state + 1 : 0, view.mission_time_s}, steers,
                                  out_ + text, sizeof out_ - text);
  flush();
  stuck_since_s_ = out_next_ == out_end_ ? __builtin_nan("") : now_s;
}

/// What has happened in the mission, for the vehicle's log, as far as there is room; returns the
/// size.
uint32_t Backseat::writeText(char* text, uint32_t capacity) {
  uint32_t size = 0;
  for (hooks::SeatEvent event = inner_.nextEvent(); event.kind != hooks::SeatEvent::Kind::None;
       event = inner_.nextEvent()) {
    hooks::extctl::SentenceWriter sentence(text + size, capacity - size);
    if (event.kind == hooks::SeatEvent::Kind::SbcTransition) {
      sentence.put("TXT,transition,");
      sentence.put(event.mission_time_s);
      const uint32_t numbers[] = {event.a, event.b, event.c, event.d, event.e};
      for (const uint32_t number : numbers) {
        sentence.put(',');
        sentence.put(number);
      }
    } else if (event.kind == hooks::SeatEvent::Kind::SbcHello) {
      sentence.put("TXT,mission,");
      sentence.put(event.text);
    } else if (event.kind == hooks::SeatEvent::Kind::SbcNote) {
      sentence.put("TXT,note,");
      sentence.put(event.mission_time_s);
      sentence.put(',');
      sentence.put(event.a);
      sentence.put(',');
      sentence.put(event.text);
    } else {
      continue;
    }
    size += sentence.end();
  }
  return size;
}

void Backseat::flush() {
  while (out_next_ < out_end_) {
    const int32_t taken = line_.write(
        line_.self, reinterpret_cast<const uint8_t*>(out_) + out_next_, out_end_ - out_next_);
    if (taken <= 0) {
      return;
    }
    out_next_ += static_cast<uint32_t>(taken);
  }
  if (brings_up_) {
    brings_up_ = false;
    stand_in_.toldToComeUp();
  }
}

bool Backseat::reading(void* self, uint16_t id, double* value) {
  auto& seat = *static_cast<Backseat*>(self);
  const uint32_t index = seat.port_.indexOf(id);
  if (index >= seat.port_.count()) {
    return false;
  }
  const bool reported = seat.reported_.takeReport(index, value);
  if (id == hooks::sensorOf(seat.dictionary_, kGliderRoleDepth)) {
    seat.depth_moves_ = reported || seat.depth_moves_;
    return reported || seat.depthGoesOn(value);
  }
  if (id != seat.mission_.depth_state) {
    return reported;
  }
  if (reported) {
    seat.depth_state_.report(*value);
  } else {
    *value = seat.depth_state_.state();
  }
  return *value == *value;
}

/// A vehicle at the surface may measure the same depth for hours, and reports changes only. While
/// the program commands the surface such a depth goes on, but not one that was there in the dive
/// before: a sensor that has stopped says nothing of how deep the vehicle is.
bool Backseat::depthGoesOn(double* depth) const {
  *depth = reported(kGliderRoleDepth);
  return wants_surface_ && depth_moves_ && *depth <= kAtSurface;
}

void Backseat::instruct(void* self, const hooks::Instruction& instruction) {
  static_cast<Backseat*>(self)->stand_in_.instruct(instruction);
}

void Backseat::state(void* self, hooks::SeatState* state) {
  const auto& seat = *static_cast<Backseat*>(self);
  const double time = seat.reported(kGliderRoleMissionTime);
  state->vehicle_time_s = hookIsFinite(time) ? time : 0;
  state->hook_state = seat.stand_in_.state();
  state->answer = seat.stand_in_.answer();
  state->answered_sequence = seat.stand_in_.answered();
  state->session = seat.stand_in_.session();
}

}  // namespace glider::runtime::extctl
