// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/imc/backseat.h"

#include "hooks/imc/values.h"
#include "hooks/protocol/numbers.h"
#include "hooks/protocol/sensors.h"
#include "runtime/front_seat/bounds.h"
#include "runtime/front_seat/story.h"
#include "runtime/imc/virtual_time.h"

namespace glider::runtime::imc {

using hooks::HookAnswer;
using hooks::HookControl;
using hooks::HookState;
using hooks::imc::EstimatedState;
using hooks::imc::Packet;

namespace {

/// By the vehicle's clock. As the checkpoint has it: when the mission began.
double beginOf(const LinkFacts* checkpoint) {
  return checkpoint != nullptr && checkpoint->clock != 0
             ? static_cast<double>(checkpoint->clock) - checkpoint->vehicle_time
             : __builtin_nan("");
}

}  // namespace

Backseat::Backseat(const GliderMission& mission, const GliderImcMission& imc,
                   const VehicleLine& line, const LinkFacts* checkpoint)
    : dictionary_(*mission.dictionary),
      imc_(imc),
      line_(line),
      plan_(imc),
      course_(imc),
      vehicle_(static_cast<uint16_t>(imc.vehicle)),
      began_s_(beginOf(checkpoint)),
      resumes_(checkpoint != nullptr),
      inner_(*mission.dictionary, {this, hear, answer, closed, reading, instruct, state, clock}) {}

double Backseat::clock(void* self) {
  return static_cast<Backseat*>(self)->readings_.value(Reading::Clock);
}

/// The vehicle has no mission of its own whose time could be read.
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
  for (uint32_t taken = 0; taken < kMostBytesAtOnce && seat.inner_.cycles() == before;) {
    if (Packet packet; seat.packets_.next(&packet)) {
      seat.take(packet);
      continue;
    }
    seat.damaged_ = seat.packets_.skippedBytes();
    if (seat.in_next_ == seat.in_end_ && !seat.fill()) {
      return;
    }
    const uint32_t pushed =
        seat.packets_.push(seat.in_ + seat.in_next_, seat.in_end_ - seat.in_next_);
    seat.in_next_ += pushed;
    taken += pushed;
  }
}

/// Reads what is there into the empty buffer; false if there is nothing.
bool Backseat::fill() {
  const int32_t count = line_.stream.read(line_.stream.self, in_, sizeof in_);
  if (count < 0) {
    line_closed_ = line_.renew == nullptr;
    dropConnection();
  }
  in_next_ = 0;
  in_end_ = count > 0 ? static_cast<uint32_t>(count) : 0;
  return in_end_ != 0;
}

/// The vehicle repeats to a back seat what that has sent: only what it says itself counts.
void Backseat::take(const Packet& packet) {
  if (!virtual_time_ && inner_.cycles() == 0 && isVirtualTime(packet)) {
    virtual_time_ = true;
    inner_.useVirtualTime();
  }
  const uint16_t to = packet.header.destination;
  const bool ours = to == vehicle_ || to == hooks::imc::kThisDune || to == hooks::imc::kAllSystems;
  if (packet.id == hooks::imc::Abort::kId && ours) {
    plan_.takeAway();  // whoever sends it
  }
  const bool first =
      vehicle_ == 0 && packet.id == EstimatedState::kId && packet.header.source != kOwnAddress;
  vehicle_ = first ? packet.header.source : vehicle_;
  another_vehicle_ =
      another_vehicle_ || (packet.id == EstimatedState::kId && packet.header.source != vehicle_ &&
                           packet.header.source != kOwnAddress);
  if (packet.header.source != vehicle_ || !hookIsFinite(packet.header.time_s)) {
    return;
  }
  if (packet.header.time_s - readings_.value(Reading::Clock) >= Plan::kStaleSecs) {
    readings_.forget(Reading::Medium);  // nothing was received meanwhile
  }
  readings_.take(packet);
  plan_.take(packet);
  if (packet.id == EstimatedState::kId) {
    lookAtCycle();
  }
}

/// A cycle is complete with the first state of a second: the vehicle sends several of them.
void Backseat::lookAtCycle() {
  const double clock = readings_.value(Reading::Clock);
  constexpr double kMost = 4294967295.0;
  const double second =
      clock > 0 && clock < kMost ? static_cast<double>(static_cast<uint32_t>(clock)) : 0;
  if (second == newest_cycle_s_) {
    return;
  }
  newest_cycle_s_ = second;
  began_s_ = began_s_ == began_s_ && clock >= began_s_ ? began_s_ : clock;
  followPlan();
  noteFailure();
  inner_.cycle();
}

/// Without a session. To a program that goes on from a checkpoint, or has steered, the vehicle has
/// lost its SBC: the program decides by the time since then whether it goes on, and only when it
/// asks for control the plan is started. While it waits for the plan, nothing is asked of it.
HookState Backseat::unheld() const {
  return plan_.isTaken()       ? HookState::Absent
         : plan_.follows()     ? goesOn() ? HookState::Silent : HookState::Ready
         : goesOn() && !asked_ ? HookState::Silent
                               : HookState::Waiting;
}

/// Everything that has arrived was taken: what the vehicle said last is how it is now. Not even a
/// part of a packet is held.
bool Backseat::isUpToDate() {
  return packets_.held() == 0 && in_next_ == in_end_ && !fill();
}

bool Backseat::startsPlan() {
  const double medium = readings_.value(Reading::Medium);
  constexpr double kSurface = hooks::imc::Medium::WaterSurface,
                   kUnder = hooks::imc::Medium::UnderWater;
  const bool in_water = medium == kSurface || medium == kUnder;
  // What goes on may begin at any depth: the vehicle floats up since its plan has timed out.
  const double depth_m = readings_.value(Reading::Depth);
  return (asked_ || !goesOn()) && in_water && !another_vehicle_ && isUpToDate() &&
         plan_.asksForStart(readings_.value(Reading::Clock),
                            goesOn() && hookIsFinite(depth_m) ? 0 : depth_m);
}

/// Control is lost with the plan, whoever ended it.
void Backseat::followPlan() {
  if (session_ != 0 && !plan_.follows() && releasing_ == 0) {
    lost_session_ = session_;
    session_ = 0;
    asked_ = false;
    course_.surface();
  }
  if (state_ != HookState::Complete) {
    state_ = session_ != 0 ? HookState::Active : unheld();
  }
}

void Backseat::noteFailure() {
  switch (plan_.takeFailure()) {
    case Plan::Failure::None:
      break;
    case Plan::Failure::Start:
      refusals_.note(Refusals::Kind::PlanStart);
      break;
    case Plan::Failure::End:
      refusals_.note(Refusals::Kind::PlanEnd);
      break;
    case Plan::Failure::Flight:
      refusals_.note(Refusals::Kind::PlanFailed);
      break;
  }
}

void Backseat::state(void* self, hooks::SeatState* state) {
  const auto& seat = *static_cast<Backseat*>(self);
  state->vehicle_time_s = seat.missionTime();
  state->hook_state = seat.state_;
  state->answer = seat.answer_;
  state->answered_sequence = seat.answered_;
  state->session = seat.session_;
}

bool Backseat::reading(void* self, uint16_t id, double* value) {
  auto& seat = *static_cast<Backseat*>(self);
  if (id == hooks::sensorOf(seat.dictionary_, kGliderRoleMissionTime)) {
    *value = seat.missionTime();
    return true;
  }
  for (uint32_t i = 0; i < seat.imc_.count; ++i) {
    if (seat.imc_.sensors[i] == id) {
      return seat.readings_.takeReport(static_cast<Reading>(seat.imc_.sources[i]), value);
    }
  }
  return false;
}

void Backseat::instruct(void* self, const hooks::Instruction& instruction) {
  auto& seat = *static_cast<Backseat*>(self);
  if (seat.answered_ != 0 && !hookIsNewerSequence(instruction.sequence, seat.answered_)) {
    if (instruction.sequence != seat.answered_) {
      seat.answer_ = HookAnswer::OldSequence;
    }
    return;
  }
  const bool release = instruction.control == HookControl::Release && seat.session_ != 0 &&
                       instruction.session == seat.session_;
  if (release) {
    seat.release_ = instruction.sequence;
    seat.releasing_ = seat.releasing_ == 0 ? 1 : seat.releasing_;
    seat.plan_.end();
    return;
  }
  seat.answered_ = instruction.sequence;
  seat.answer_ = seat.decide(instruction);
}

HookAnswer Backseat::decide(const hooks::Instruction& instruction) {
  const bool takes = instruction.control == HookControl::Take;
  asked_ = asked_ || takes;
  if (!plan_.follows() || releasing_ != 0 || state_ == HookState::Complete) {
    return HookAnswer::NotReady;
  }
  if (takes ? lost_session_ != 0 && !hookIsNewerSession(instruction.session, lost_session_)
            : instruction.session != session_) {
    return HookAnswer::WrongSession;
  }
  const HookAnswer within =
      checkBounds(instruction, {imc_.greatest_depth_m, imc_.slowest_m_s, imc_.fastest_m_s});
  if (within != HookAnswer::Accepted) {
    return within;
  }
  course_.steer(instruction, here(), readings_.value(Reading::Heading));
  session_ = takes ? instruction.session : session_;
  state_ = HookState::Active;
  return HookAnswer::Accepted;
}

template <typename Message>
void Backseat::send(const Message& message) {
  const hooks::imc::Header header{.time_s = readings_.value(Reading::Clock),
                                  .source = kOwnAddress,
                                  .source_entity = hooks::imc::kAnyEntity,
                                  .destination = vehicle_,
                                  .destination_entity = hooks::imc::kAnyEntity};
  out_end_ += encode(header, message, out_ + out_end_, kMostBytes - out_end_);
}

void Backseat::sendReference() {
  hooks::imc::Reference reference;
  if (course_.reference(here(), reference)) {
    send(reference);
    plan_.noteReference(reference, readings_.value(Reading::Clock));
  }
}

/// Ends the plan, unless the vehicle says that it flies another, or has not said yet on this
/// connection what it flies: a request to stop does not name one.
void Backseat::release() {
  const bool over = plan_.isOver() || plan_.isTaken();
  if (!over && plan_.isKnown()) {
    send(plan_.stop());
  }
  if (over || ++releasing_ > kReleaseCycles) {
    releasing_ = 0;
    answered_ = release_;
    answer_ = HookAnswer::Accepted;
    lost_session_ = session_;
    session_ = 0;
    state_ = HookState::Complete;
  }
}

/// What has happened, for the vehicle's log; a simulated vehicle also gets the state.
void Backseat::tell() {
  char text[kMostStory];
  const auto enter = [&](uint32_t size) {
    if (size != 0) {
      send(hooks::imc::LogBookEntry{.type = hooks::imc::LogEntryType::Information,
                                    .htime = readings_.value(Reading::Clock),
                                    .context = hooks::imc::textOf("glidercc"),
                                    .text = {text, size}});
    }
  };
  for (uint32_t i = 0; i < kMostTold; ++i) {
    enter(storyOf(inner_.nextEvent(), text));
  }
  if (virtual_time_) {
    enter(stateStory(inner_.sbc(), text));
  }
}

/// The program has answered a cycle: sends the vehicle what is in force now, and a Heartbeat, which
/// ends it. While the line is stuck nothing counts as sent.
void Backseat::answer(void* self) {
  auto& seat = *static_cast<Backseat*>(self);
  if (seat.isInDoubt()) {
    seat.line_.renew(seat.line_.self);
    seat.plan_.noteRenewal();
    seat.dropConnection();
    return;
  }
  if (seat.out_next_ != seat.out_end_ || seat.vehicle_ == 0) {
    ++seat.stuck_;
    seat.flush();
    return;
  }
  seat.stuck_ = 0;
  seat.out_next_ = seat.out_end_ = 0;
  if (seat.releasing_ != 0) {
    seat.release();
  } else if (seat.startsPlan()) {
    seat.send(seat.plan_.start());
  } else if (seat.plan_.runs()) {
    seat.sendReference();
  }
  seat.tell();
  seat.send(hooks::imc::Heartbeat());
  seat.flush();
}

void Backseat::flush() {
  while (out_next_ < out_end_) {
    const int32_t taken =
        line_.stream.write(line_.stream.self, out_ + out_next_, out_end_ - out_next_);
    if (taken < 0 && line_.renew != nullptr) {
      dropConnection();
    }
    if (taken <= 0) {
      return;
    }
    out_next_ += static_cast<uint32_t>(taken);
  }
}

/// Nothing shows that the vehicle reads what is sent, and the line is one that can be opened again.
bool Backseat::isInDoubt() const {
  return line_.renew != nullptr &&
         (stuck_ >= kMostStuck || plan_.isInDoubt(readings_.value(Reading::Clock)));
}

/// What is on its way on a connection ends with it: half a packet would be joined with the begin of
/// another, and a request that waits until the vehicle is back would come too late. Meanwhile an
/// operator may have started a plan, or lifted the vehicle out of the water.
void Backseat::dropConnection() {
  packets_.reset();
  in_next_ = in_end_ = 0;
  out_next_ = out_end_ = 0;
  stuck_ = 0;
  plan_.noteEndOfConnection();
  readings_.forget(Reading::Medium);
}

}  // namespace glider::runtime::imc
