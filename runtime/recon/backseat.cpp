// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/recon/backseat.h"

#include "hooks/protocol/sensors.h"
#include "hooks/recon/codec.h"
#include "runtime/front_seat/bounds.h"
#include "runtime/front_seat/story.h"
#include "runtime/numbers/numbers.h"
#include "runtime/recon/virtual_time.h"

namespace glider::runtime::recon {

using hooks::recon::Line;
using hooks::recon::State;

namespace {

/// A datagram may overtake another, but not one that is so old, s: then the vehicle's clock was set
/// back.
constexpr double kOvertakenSecs = 3;

/// By the vehicle's clock. As the checkpoint has it: when the mission began.
double beginOf(const LinkFacts* checkpoint) {
  return checkpoint != nullptr && checkpoint->clock != 0
             ? static_cast<double>(checkpoint->clock) - checkpoint->vehicle_time
             : unknown();
}

}  // namespace

Backseat::Backseat(const GliderMission& mission, const GliderReconMission& recon,
                   const GliderByteStream& line, const LinkFacts* checkpoint)
    : dictionary_(*mission.dictionary),
      start_depth_cm_(mission.start_depth_cm),
      recon_(recon),
      line_(line),
      course_(recon),
      session_(checkpoint != nullptr),
      began_s_(beginOf(checkpoint)),
      inner_(*mission.dictionary, {this, hear, answer, closed, reading, instruct, state, clock}) {}

double Backseat::clock(void* self) {
  return static_cast<Backseat*>(self)->readings_.value(Reading::Clock);
}

/// The vehicle's own mission has another time.
double Backseat::missionTime() const {
  const double time = readings_.value(Reading::Clock) - began_s_;
  return time > 0 ? time : 0;
}

/// Takes what has arrived until a cycle is complete or nothing is left. Bounded, so that a line
/// full of noise cannot keep the program from its other work.
void Backseat::hear(void* self) {
  auto& seat = *static_cast<Backseat*>(self);
  seat.flush();
  constexpr uint32_t kMostBytesAtOnce = 16384;
  const uint32_t before = seat.inner_.cycles();
  for (uint32_t taken = 0; taken < kMostBytesAtOnce && seat.inner_.cycles() == before; ++taken) {
    if (seat.in_next_ == seat.in_end_ && !seat.fill()) {
      break;
    }
    Line line;
    if (seat.lines_.push(seat.in_[seat.in_next_++], &line)) {
      seat.take(line);
    }
  }
  seat.damaged_ = seat.lines_.skippedBytes();
}

/// Reads what is there into the empty buffer; false if there is nothing.
bool Backseat::fill() {
  const int32_t count = line_.read(line_.self, in_, sizeof in_);
  line_closed_ = line_closed_ || count < 0;
  in_next_ = 0;
  in_end_ = count > 0 ? static_cast<uint32_t>(count) : 0;
  return in_end_ != 0;
}

/// What is not known here, such as the vehicle's echo of a command, is passed over.
void Backseat::take(const Line& line) {
  hooks::recon::Ctd ctd;
  hooks::recon::TimeSet time;
  hooks::recon::SimulationText text;
  if (State said; decode(line, said)) {
    takeState(said);
  } else if (decode(line, ctd)) {
    readings_.take(ctd);
  } else if (decode(line, time)) {
    clock_.set(time.unix_s);
  } else if (decode(line, text) && !virtual_time_ && inner_.cycles() == 0 && isVirtualTime(text)) {
    virtual_time_ = true;
    inner_.useVirtualTime();
  }
}

/// Without a date there is no cycle: the vehicle is asked for it.
void Backseat::takeState(const State& said) {
  const double clock_s = clock_.timeOf(said.time_s);
  if (!isFinite(clock_s)) {
    if (out_next_ == out_end_) {
      out_next_ = out_end_ = 0;
      send(hooks::recon::TimeQuery());
      flush();
    }
    return;
  }
  const double back_s = readings_.value(Reading::Clock) - clock_s;
  if (back_s > 0 && back_s < kOvertakenSecs) {
    return;
  }
  readings_.take(said, clock_s);
  const bool followed = takeover_.follows();
  takeover_.take(said.mode, clock_s);
  requests_ = takeover_.follows() == followed ? requests_ : 0;
  lookAtCycle();
}

/// A cycle is complete with the first state of a second.
void Backseat::lookAtCycle() {
  const double clock = readings_.value(Reading::Clock);
  constexpr double kMost = 4294967295.0;
  const double second =
      clock > 0 && clock < kMost ? static_cast<double>(static_cast<uint32_t>(clock)) : 0;
  if (second == newest_cycle_s_) {
    return;
  }
  newest_cycle_s_ = second;
  began_s_ = isFinite(began_s_) && clock >= began_s_ ? began_s_ : clock;
  if (session_.follow(hold())) {
    course_.surface();
  }
  inner_.cycle();
}

void Backseat::state(void* self, hooks::SeatState* state) {
  const auto& seat = *static_cast<Backseat*>(self);
  state->vehicle_time_s = seat.missionTime();
  seat.session_.describe(state);
}

bool Backseat::reading(void* self, uint16_t id, double* value) {
  auto& seat = *static_cast<Backseat*>(self);
  if (id == hooks::sensorOf(seat.dictionary_, kGliderRoleMissionTime)) {
    *value = seat.missionTime();
    return true;
  }
  for (uint32_t i = 0; i < seat.recon_.count; ++i) {
    if (seat.recon_.sensors[i] == id) {
      return seat.readings_.takeReport(static_cast<Reading>(seat.recon_.sources[i]), value);
    }
  }
  return false;
}

void Backseat::instruct(void* self, const hooks::Instruction& instruction) {
  auto& seat = *static_cast<Backseat*>(self);
  const CommandLimits limits{.greatest_depth_m = seat.recon_.greatest_depth_m,
                             .slowest_m_s = seat.recon_.slowest_m_s,
                             .fastest_m_s = seat.recon_.fastest_m_s};
  const auto step = seat.session_.take(instruction, seat.hold(), checkBounds(instruction, limits));
  if (step == SeatSession::Step::Steer) {
    seat.course_.steer(instruction, seat.readings_.value(Reading::Heading));
  }
}

/// By the newest state: one that does not say how deep the vehicle is may be of any depth.
bool Backseat::isNearSurface() const {
  constexpr double kCmPerM = 100;
  return start_depth_cm_ == 0 || readings_.depthNow() * kCmPerM <= start_depth_cm_;
}

/// What goes on may begin at any depth: the vehicle flies its own mission meanwhile.
bool Backseat::asksForControl() const {
  return takeover_.mayBeAsked() && session_.mayAsk() && (session_.goesOn() || isNearSurface());
}

template <typename Message>
void Backseat::send(const Message& message) {
  out_end_ += encode(message, out_ + out_end_, kMostBytes - out_end_);
}

/// All three or none: the vehicle would mix them with those of before.
void Backseat::sendGoals() {
  Goals goals;
  if (course_.goals(readings_.here(), readings_.value(Reading::Heading), goals)) {
    send(hooks::recon::HeadingGoal{goals.heading_deg});
    send(hooks::recon::SpeedGoal{goals.speed_m_s, hooks::recon::SpeedUnit::MetresPerSecond});
    send(hooks::recon::DepthGoal{goals.depth_m});
  }
}

/// RECON has no log for the SBC: only a simulated vehicle gets what happens in the mission. The
/// state is last and ends the answer.
void Backseat::tell() {
  char text[kMostStory];
  const auto enter = [&](uint32_t size) {
    for (uint32_t i = 0; i < size; ++i) {
      const char c = text[i];
      text[i] = c < ' ' || c > '~' || c == '#' || c == '*' ? '?' : c;
    }
    if (size != 0) {
      send(hooks::recon::SimulationText{{text, size}});
    }
  };
  for (uint32_t i = 0; i < kMostTold; ++i) {
    enter(storyOf(inner_.nextEvent(), text));
  }
  enter(stateStory(inner_.sbc(), text));
}

/// A vehicle that is left in the override would keep the last goals, however deep.
bool Backseat::mayEnd() {
  if (session_.isOver() || !takeover_.follows()) {
    return true;
  }
  session_.leave();
  return false;
}

/// That the override begins, or ends. The first kInVain are logged together, as soon as they all
/// had no effect.
void Backseat::request(bool on) {
  send(hooks::recon::Override{on});
  if (++requests_ > kInVain) {
    refusals_.note(on ? Refusals::Kind::Override : Refusals::Kind::OverrideEnd,
                   requests_ == kInVain + 1 ? kInVain : 1);
  }
}

/// Goals too: as long as the vehicle does not end the override it obeys them.
void Backseat::release() {
  course_.surface();
  if (takeover_.follows()) {
    sendGoals();
    request(false);
  }
  session_.noteRelease(!takeover_.follows());
}

/// The program has answered a cycle: sends the vehicle what is in force now. While the line is
/// stuck nothing counts as sent.
void Backseat::answer(void* self) {
  auto& seat = *static_cast<Backseat*>(self);
  if (seat.out_next_ != seat.out_end_) {
    seat.flush();
    return;
  }
  seat.out_next_ = seat.out_end_ = 0;
  if (seat.session_.releases()) {
    seat.release();
  } else if (seat.takeover_.follows() && !seat.session_.isOver()) {
    seat.sendGoals();
  } else {
    seat.send(hooks::recon::KeepAlive());
    if (seat.asksForControl()) {
      seat.request(true);
    }
  }
  if (seat.virtual_time_) {
    seat.tell();
  }
  seat.flush();
}

void Backseat::flush() {
  while (out_next_ < out_end_) {
    const auto* const bytes = reinterpret_cast<const uint8_t*>(out_);
    const int32_t taken = line_.write(line_.self, bytes + out_next_, out_end_ - out_next_);
    if (taken <= 0) {
      return;
    }
    out_next_ += static_cast<uint32_t>(taken);
  }
}

}  // namespace glider::runtime::recon
