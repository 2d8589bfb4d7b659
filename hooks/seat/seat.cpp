// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/seat.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {

using Kind = SeatEvent::Kind;

template <typename Message, void (Seat::*kHandler)(const Message&)>
bool Seat::take(const Frame& frame) {
  Message message;
  if (!read(frame, message)) {
    return false;
  }
  (this->*kHandler)(message);
  return true;
}

Seat::Seat(const GliderDictionary& dictionary, const SeatOptions& options)
    : dictionary_(&dictionary), options_(options), reporter_(dictionary) {}

/// The numbers begin at a different value each time that the vehicle's computer starts. A first
/// frame or heartbeat equal to the last one before the restart would be taken for a repetition of
/// it.
void Seat::begin() {
  const double seconds = atMost(atLeast(now_s_, 0), UINT32_MAX);  // up to the year 2106
  const uint32_t whole = static_cast<uint32_t>(seconds) % kMostSession;
  out_sequence_ = static_cast<uint8_t>(whole);
  heartbeat_ = whole;
  started_ = true;
}

void Seat::serve(double now_s, const SeatState& state, const SeatVehicle& vehicle,
                 const GliderByteStream& sbc) {
  now_s_ = now_s;
  state_ = state;
  vehicle_ = &vehicle;
  if (!started_) {
    begin();
  }
  // Bounded: an SBC that never stops sending must not keep the vehicle's computer from its other
  // work.
  for (int frames = 0; frames < 64; ++frames) {
    const FrameReader::Result result = reader_.next(sbc);
    if (result == FrameReader::Result::Closed && link_ != 0) {
      loseSbc();
    }
    if (result != FrameReader::Result::Frame) {
      break;
    }
    handle(reader_.frame());
  }
  vehicle_ = nullptr;
}

void Seat::handle(const Frame& frame) {
  const bool good = frame.type == MessageType::Hello ? take<Hello, &Seat::handleHello>(frame)
                    : link_ == 0 ? true  // the rest of an answer that belongs to no link
                                 : handleOfLink(frame);
  malformed_ += good ? 0 : 1;
}

bool Seat::handleOfLink(const Frame& frame) {
  switch (frame.type) {
    case MessageType::Subscribe:
      return take<Subscribe, &Seat::handleSubscribe>(frame);
    case MessageType::Transition:
      return take<TransitionNotice, &Seat::handleTransition>(frame);
    case MessageType::Note:
      return take<MissionNote, &Seat::handleNote>(frame);
    case MessageType::Done:
      return take<Done, &Seat::handleDone>(frame);
    case MessageType::Write:
      return take<SensorList, &Seat::handleWrite>(frame);
    case MessageType::Hello:  // of no existing link
    case MessageType::Beacon:
    case MessageType::Welcome:
    case MessageType::Tick:
    case MessageType::Log:
      break;
  }
  return false;
}

Features Seat::features() const {
  const uint16_t time = options_.virtual_time ? kFeatureVirtualTime : 0;
  return {.offers = static_cast<uint16_t>(time | options_.obeys), .needs = time};
}

/// No link; reported once for each reason.
void Seat::refuse(const Hello& hello, uint16_t missing) {
  link_ = 0;
  view_ = SbcView{};
  if (hello.version != refused_version_ || hello.dictionary != refused_dictionary_ ||
      missing != refused_features_) {
    event(Kind::SbcRefused, hello.version, hello.dictionary, missing);
  }
  refused_version_ = hello.version;
  refused_dictionary_ = hello.dictionary;
  refused_features_ = missing;
}

void Seat::handleHello(const Hello& hello) {
  const uint16_t missing = missingFeatures(features(), hello.features);
  if (hello.version != kProtocolVersion || hello.dictionary != dictionary_->hash || missing != 0) {
    refuse(hello, missing);
    return;
  }
  refused_version_ = 0;
  refused_dictionary_ = 0;
  refused_features_ = 0;
  link_ = hello.link;
  told_s_ = 0;
  waiting_ = false;
  reporter_.serve(Subscribe{});
  SeatEvent told;
  told.kind = Kind::SbcHello;
  told.mission_time_s = state_.vehicle_time_s;
  told.a = link_;
  for (uint32_t i = 0; i < kMostNameBytes; ++i) {
    told.text[i] = hello.mission_name[i];
  }
  events_.push(told);
  Frame frame;
  encode(Welcome{options_.virtual_time, link_, newest_session_}, frame);
  send(frame);
}

void Seat::handleWrite(const SensorList& list) {
  uint32_t session = newest_session_;
  double sequence = 0;
  bool has_sequence = false;
  for (uint32_t i = 0; i < list.count; ++i) {
    const SensorValue& value = list.values[i];
    if (!isInstructionSensor(*dictionary_, value.id)) {
      event(Kind::RefusedWrite, value.id);
      return;
    }
    if (value.id == sensor(kGliderRoleHookSequence)) {
      sequence = value.value;
      has_sequence = true;
    }
    if (value.id == sensor(kGliderRoleHookSession) && value.value >= 1 &&
        value.value <= kMostSession) {
      session = static_cast<uint32_t>(value.value);
    }
  }
  newest_session_ = isNewerSession(session, newest_session_) ? session : newest_session_;
  if (has_sequence) {
    // The vehicle refuses a repeated instruction and answers it; the seat does not check for
    // repetitions.
    answers_.written(sequence, now_s_);
  }
  vehicle_->write(vehicle_->self, list);
}

void Seat::handleTransition(const TransitionNotice& notice) {
  if (isStale(notice.mission_time_s)) {
    return;
  }
  SeatEvent told;
  told.kind = Kind::SbcTransition;
  told.mission_time_s = notice.mission_time_s;
  told.a = notice.transition;
  told.b = notice.from;
  told.c = notice.to;
  told.d = notice.fired_case;
  told.e = notice.list;
  events_.push(told);
}

void Seat::handleNote(const MissionNote& note) {
  if (isStale(note.mission_time_s)) {
    return;
  }
  SeatEvent told;
  told.kind = Kind::SbcNote;
  told.mission_time_s = note.mission_time_s;
  told.a = note.kind;
  for (uint32_t i = 0; i < kMostNoteBytes; ++i) {
    told.text[i] = note.text[i];
  }
  events_.push(told);
}

/// A mission's time never goes back while it has the link: an earlier time means a repeated
/// message.
bool Seat::isStale(double mission_time_s) {
  const bool stale = mission_time_s < told_s_;
  stale_ += stale ? 1 : 0;
  return stale;
}

void Seat::handleDone(const Done& done) {
  if (isStale(done.status.mission_time_s)) {
    return;
  }
  told_s_ = done.status.mission_time_s;
  waiting_ = false;
  reporter_.answered(done.answered);
  view_ = {true, done.status.mission_time_s, done.status.state, done.status.stack_depth,
           done.status.phase};
  // A restarted program also answers, but it does not steer what its predecessor started: only the
  // answers of the session in control keep that session alive. They do not if the mission's time
  // does not advance: then a program answers, but no mission runs.
  const uint32_t in_control = state_.session;
  // A program that is not in control yet has already reported its time, so that a repetition of it
  // is not progress.
  const bool counts = done.session != 0 && (in_control == 0 || done.session == in_control);
  if (counts ? noteProgress(done) : in_control == 0) {
    beat();
  }
}

/// True if the time of the mission in control has advanced.
bool Seat::noteProgress(const Done& done) {
  if (progress_.hasGoneOn(done.session, done.status.mission_time_s, now_s_)) {
    return true;
  }
  if (state_.session != 0 && progress_.isStuck(kLostSecs, now_s_)) {
    event(Kind::SbcStuck, done.session);
  }
  return false;
}

void Seat::watch(const SeatState& state) {
  state_ = state;
  answers_.answered(state.answered_sequence);
  if (answers_.isOverdue(kUnansweredSecs, now_s_)) {
    event(Kind::SbcUnanswered, answers_.instruction());
  }
  const bool old = state.answer == HookAnswer::OldSequence;
  const uint32_t refused = old ? state.answered_sequence : 0;
  if (old && refused != old_told_) {
    event(Kind::OldInstruction, refused);
  }
  old_told_ = refused;
}

void Seat::beat() {
  heartbeat_ = nextSession(heartbeat_);
  vehicle_->beat(vehicle_->self, heartbeat_);
}

void Seat::tick(const SeatState& state, const SeatVehicle& vehicle) {
  state_ = state;
  if (link_ == 0) {
    sendBeacon();
    return;
  }
  sendTick(vehicle);
  if (!waiting_) {
    waiting_ = true;
    waits_.begin(now_s_);
  }
}

void Seat::sendBeacon() {
  Frame frame;
  encode(Beacon{kProtocolVersion, features(), dictionary_->hash, state_.hook_state}, frame);
  send(frame);
}

void Seat::sendTick(const SeatVehicle& vehicle) {
  reporter_.begin();
  const Subscribe& subscribed = reporter_.subscription();
  for (uint32_t i = 0; i < subscribed.count; ++i) {
    double value = 0;
    if (vehicle.reading(vehicle.self, subscribed.sensors[i].id, &value)) {
      reporter_.report(i, value);
    }
  }
  Frame frame;
  encode(*dictionary_, tickHead(), subscribed, reporter_.readings(), frame);
  send(frame);
  reporter_.sent(frame.sequence);
}

TickHead Seat::tickHead() const {
  TickHead head;
  head.virtual_time = options_.virtual_time;
  head.link = link_;
  head.vehicle_time_s = state_.vehicle_time_s;
  head.cycle = state_.cycle;
  head.subscription = reporter_.check();
  head.hook_state = state_.hook_state;
  head.answer = state_.answer;
  head.answered_sequence = static_cast<uint16_t>(state_.answered_sequence);
  head.session = state_.session;
  head.clock_s = state_.clock_s;
  return head;
}

void Seat::send(Frame& frame) {
  frame.sequence = ++out_sequence_;
  (void)out_.add(frame);  // no room: the line is not being read; the next cycle brings newer values
}

void Seat::finish(const GliderByteStream& sbc, uint32_t bad_frames) {
  const bool open = out_.flush(sbc);
  if (link_ != 0 && (!open || (waiting_ && waits_.lasts(now_s_) >= kLostSecs))) {
    loseSbc();
  }
  countBadFrames(bad_frames);
}

void Seat::loseSbc() {
  if (view_.phase != MissionPhase::Finished) {  // after that it may leave without an alarm
    event(Kind::SbcLost, link_);
  }
  link_ = 0;
  waiting_ = false;
  view_ = SbcView{};
}

void Seat::countBadFrames(uint32_t of_vehicle) {
  const uint32_t bad = reader_.badFrames() + of_vehicle + malformed_;
  if (bad != bad_frames_told_) {
    event(Kind::BadFrame, bad - bad_frames_told_);
    bad_frames_told_ = bad;
  }
  if (stale_ != 0) {
    event(Kind::StaleFrame, stale_);
    stale_ = 0;
  }
}

void Seat::event(Kind kind, uint32_t a, uint32_t b, uint32_t c) {
  SeatEvent told;
  told.kind = kind;
  told.mission_time_s = state_.vehicle_time_s;
  told.a = a;
  told.b = b;
  told.c = c;
  events_.push(told);
}

}  // namespace glider::hooks
