// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookprog/hookprog.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {

using Kind = HookprogEvent::Kind;

namespace {

constexpr GliderRole kReportsOfHookbeh[] = {kGliderRoleHookState, kGliderRoleHookAnswered,
                                            kGliderRoleHookAnswer, kGliderRoleHookInControl};

}  // namespace

template <typename Message, void (Hookprog::*kHandler)(const Message&)>
bool Hookprog::take(const Frame& frame) {
  Message message;
  if (!read(frame, message)) {
    return false;
  }
  (this->*kHandler)(message);
  return true;
}

Hookprog::Hookprog(const GliderDictionary& dictionary, const HookprogOptions& options)
    : dictionary_(&dictionary),
      options_(options),
      flight_science_link_(dictionary),
      reporter_(dictionary) {
  for (double& value : values_) {
    value = __builtin_nan("");
  }
}

void Hookprog::run(double science_time_s, const ScienceSensors& own, const GliderByteStream& sbc,
                   const GliderByteStream& flight) {
  now_s_ = science_time_s;
  if (!started_) {
    begin();
  }
  serveSbc(sbc);
  takeFlight(flight);
  watchInstruction();
  if (time_is_new_ && cycle_is_new_) {
    time_is_new_ = false;
    cycle_is_new_ = false;
    watchHookbeh();
    if (cycles_.isNext(newestWhole(kGliderRoleCycleNumber))) {
      sendCycle(own);
    } else {
      ++stale_;
    }
    for (bool& fresh : fresh_) {
      fresh = false;
    }
  }
  const bool open = out_.flush(sbc);
  if (link_ != 0 && (!open || (waiting_ && waits_.lasts(now_s_) >= kLostSecs))) {
    loseSbc();
  }
  countBadFrames();
}

/// The numbers begin at a different value each time that the science computer starts. A first frame
/// or heartbeat equal to the last one before the restart would be taken for a repetition of it.
void Hookprog::begin() {
  const double seconds = atMost(atLeast(now_s_, 0), UINT32_MAX);  // up to the year 2106
  const uint32_t whole = static_cast<uint32_t>(seconds) % kMostSession;
  out_sequence_ = static_cast<uint8_t>(whole);
  heartbeat_ = whole;
  started_ = true;
}

HookprogEvent Hookprog::nextEvent() {
  return events_.next();
}

void Hookprog::takeFlight(const GliderByteStream& flight) {
  constexpr uint32_t kMostUpdates = 1024;  // more than the line transmits in a second, 960 bytes
  SensorUpdate update;
  for (uint32_t i = 0; i < kMostUpdates && flight_science_link_.poll(flight, &update, 1) == 1;
       ++i) {
    takeUpdate(update);
  }
}

void Hookprog::takeUpdate(const SensorUpdate& update) {
  if (update.id == sensor(kGliderRoleMissionTime)) {
    time_is_new_ = update.value - update.value == 0;
  }
  if (update.id == sensor(kGliderRoleCycleNumber) &&
      update.value != newest(kGliderRoleCycleNumber)) {
    cycle_is_new_ = update.value == update.value;
  }
  values_[update.id] = update.value;
  fresh_[update.id] = true;
}

void Hookprog::serveSbc(const GliderByteStream& sbc) {
  // Bounded: an SBC that never stops sending must not keep the science computer from its
  // instruments.
  for (int frames = 0; frames < 64; ++frames) {
    const FrameReader::Result result = reader_.next(sbc);
    if (result == FrameReader::Result::Closed && link_ != 0) {
      loseSbc();
    }
    if (result != FrameReader::Result::Frame) {
      return;
    }
    handle(reader_.frame());
  }
}

void Hookprog::handle(const Frame& frame) {
  const bool good = frame.type == MessageType::Hello ? take<Hello, &Hookprog::handleHello>(frame)
                    : link_ == 0 ? true  // the rest of an answer that belongs to no link
                                 : handleOfLink(frame);
  malformed_ += good ? 0 : 1;
}

bool Hookprog::handleOfLink(const Frame& frame) {
  switch (frame.type) {
    case MessageType::Subscribe:
      return take<Subscribe, &Hookprog::handleSubscribe>(frame);
    case MessageType::Transition:
      return take<TransitionNotice, &Hookprog::handleTransition>(frame);
    case MessageType::Note:
      return take<MissionNote, &Hookprog::handleNote>(frame);
    case MessageType::Done:
      return take<Done, &Hookprog::handleDone>(frame);
    case MessageType::Write:
      return take<SensorList, &Hookprog::handleWrite>(frame);
    case MessageType::Hello:  // of no existing link
    case MessageType::Beacon:
    case MessageType::Welcome:
    case MessageType::Tick:
    case MessageType::Sensors:
    case MessageType::Log:
      break;
  }
  return false;
}

Features Hookprog::features() const {
  const uint16_t time = options_.virtual_time ? kFeatureVirtualTime : 0;
  return {.offers = time, .needs = time};
}

/// No link; reported once for each reason.
void Hookprog::refuse(const Hello& hello, uint16_t missing) {
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

void Hookprog::handleHello(const Hello& hello) {
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
  HookprogEvent told;
  told.kind = Kind::SbcHello;
  told.mission_time_s = missionTime();
  told.a = link_;
  for (uint32_t i = 0; i < kMostNameBytes; ++i) {
    told.text[i] = hello.mission_name[i];
  }
  events_.push(told);
  Frame frame;
  encode(Welcome{options_.virtual_time, link_, newest_session_}, frame);
  send(frame);
}

void Hookprog::handleWrite(const SensorList& list) {
  SensorUpdate ordered[kMostListed];
  uint32_t count = 0;
  const SensorUpdate* sequence = nullptr;
  uint32_t session = newest_session_;
  for (uint32_t i = 0; i < list.count; ++i) {
    const SensorValue& value = list.values[i];
    if (!isInstructionSensor(*dictionary_, value.id)) {
      event(Kind::RefusedWrite, value.id);
      return;
    }
    if (value.id == sensor(kGliderRoleHookSequence)) {
      sequence = &value;
    } else {
      ordered[count++] = value;
    }
    if (value.id == sensor(kGliderRoleHookSession) && value.value >= 1 &&
        value.value <= kMostSession) {
      session = static_cast<uint32_t>(value.value);
    }
  }
  newest_session_ = isNewerSession(session, newest_session_) ? session : newest_session_;
  if (sequence != nullptr) {
    // hookbeh refuses a repeated instruction and answers it; hookprog does not check for
    // repetitions.
    ordered[count++] = *sequence;
    answers_.written(sequence->value, now_s_);
  }
  if (hookState() != HookState::Absent) {
    (void)flight_science_link_.send(ordered,
                                    count);  // no room: the SBC gets no answer and writes it again
  }
}

void Hookprog::handleTransition(const TransitionNotice& notice) {
  if (isStale(notice.mission_time_s)) {
    return;
  }
  HookprogEvent told;
  told.kind = Kind::SbcTransition;
  told.mission_time_s = notice.mission_time_s;
  told.a = notice.transition;
  told.b = notice.from;
  told.c = notice.to;
  told.d = notice.fired_case;
  told.e = notice.list;
  events_.push(told);
}

void Hookprog::handleNote(const MissionNote& note) {
  if (isStale(note.mission_time_s)) {
    return;
  }
  HookprogEvent told;
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
bool Hookprog::isStale(double mission_time_s) {
  const bool stale = mission_time_s < told_s_;
  stale_ += stale ? 1 : 0;
  return stale;
}

void Hookprog::handleDone(const Done& done) {
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
  const uint32_t in_control = newestWhole(kGliderRoleHookInControl);
  // A program that is not in control yet has already reported its time, so that a repetition of it
  // is not progress.
  const bool counts = done.session != 0 && (in_control == 0 || done.session == in_control);
  if (counts ? noteProgress(done) : in_control == 0) {
    beat();
  }
}

/// True if the time of the mission in control has advanced.
bool Hookprog::noteProgress(const Done& done) {
  if (progress_.hasGoneOn(done.session, done.status.mission_time_s, now_s_)) {
    return true;
  }
  if (newestWhole(kGliderRoleHookInControl) != 0 && progress_.isStuck(kLostSecs, now_s_)) {
    event(Kind::SbcStuck, done.session);
  }
  return false;
}

/// Reports a flight controller that does not answer instructions.
void Hookprog::watchInstruction() {
  answers_.answered(newestWhole(kGliderRoleHookAnswered));
  if (answers_.isOverdue(kLostSecs, now_s_)) {
    event(Kind::SbcUnanswered, answers_.instruction());
  }
  const bool old =
      newestWhole(kGliderRoleHookAnswer) == static_cast<uint32_t>(HookAnswer::OldSequence);
  const uint32_t refused = old ? newestWhole(kGliderRoleHookAnswered) : 0;
  if (old && refused != old_told_) {
    event(Kind::OldInstruction, refused);
  }
  old_told_ = refused;
}

void Hookprog::beat() {
  heartbeat_ = nextSession(heartbeat_);
  if (hookState() != HookState::Absent) {
    const SensorUpdate beat{sensor(kGliderRoleHookHeartbeat), static_cast<double>(heartbeat_)};
    (void)flight_science_link_.send(&beat,
                                    1);  // no room: the line is stuck, as hookbeh's timer detects
  }
}

/// The vehicle's next mission may have no hookbeh; the last values that hookbeh reported then
/// remain in place. Time and cycle number both restart with a new mission; if only one does, it is
/// a false reading.
void Hookprog::watchHookbeh() {
  const double time = missionTime();
  const uint32_t cycle = newestWhole(kGliderRoleCycleNumber);
  if (time < cycle_time_s_ && cycle < cycle_number_) {
    most_without_hookbeh_ = kMostCyclesOfAnotherMission;
  }
  cycle_time_s_ = time;
  cycle_number_ = cycle;
  if (fresh_[sensor(kGliderRoleHookState)]) {
    cycles_without_hookbeh_ = 0;
    most_without_hookbeh_ = kMostCyclesWithoutHookbeh;
  } else if (++cycles_without_hookbeh_ >= most_without_hookbeh_) {
    for (const GliderRole role : kReportsOfHookbeh) {
      values_[sensor(role)] = __builtin_nan("");
    }
  }
}

void Hookprog::sendCycle(const ScienceSensors& own) {
  forwardPressure(own);
  if (link_ == 0) {
    sendBeacon();
  } else {
    sendTick(own);
    if (!waiting_) {
      waiting_ = true;
      waits_.begin(now_s_);
    }
  }
}

/// hookbeh compares the vehicle's depth with the CTD's.
void Hookprog::forwardPressure(const ScienceSensors& own) {
  if (sensor(kGliderRoleWaterPressure) == kNoSensor) {
    return;
  }
  pressure_ = own.get(own.self, sensor(kGliderRoleWaterPressure), &pressure_is_new_);
  if (pressure_is_new_ && hookState() != HookState::Absent) {
    const SensorUpdate update{sensor(kGliderRoleWaterPressure), pressure_};
    (void)flight_science_link_.send(&update, 1);  // no room: the next cycle's is newer
  }
}

void Hookprog::sendBeacon() {
  Frame frame;
  encode(Beacon{kProtocolVersion, features(), dictionary_->hash, hookState()}, frame);
  send(frame);
}

void Hookprog::sendTick(const ScienceSensors& own) {
  reporter_.begin();
  const Subscribe& subscribed = reporter_.subscription();
  for (uint32_t i = 0; i < subscribed.count; ++i) {
    double value = 0;
    if (readingFor(subscribed.sensors[i].id, own, &value)) {
      reporter_.report(i, value);
    }
  }
  Frame frame;
  encode(*dictionary_, tickHead(), subscribed, reporter_.readings(), frame);
  send(frame);
  reporter_.sent(frame.sequence);
}

bool Hookprog::readingFor(uint16_t id, const ScienceSensors& own, double* value) {
  if (!isScienceSensor(*dictionary_, id)) {
    *value = values_[id];
    return fresh_[id];
  }
  bool fresh = pressure_is_new_;
  *value = id == sensor(kGliderRoleWaterPressure) ? pressure_ : own.get(own.self, id, &fresh);
  return fresh;
}

TickHead Hookprog::tickHead() const {
  TickHead head;
  head.virtual_time = options_.virtual_time;
  head.link = link_;
  head.vehicle_time_s = missionTime();
  head.cycle = newestWhole(kGliderRoleCycleNumber);
  head.subscription = reporter_.check();
  head.hook_state = hookState();
  const uint32_t answer = newestWhole(kGliderRoleHookAnswer);
  head.answer = answer <= UINT8_MAX && isHookAnswer(static_cast<uint8_t>(answer))
                    ? static_cast<HookAnswer>(answer)
                    : HookAnswer::None;
  head.answered_sequence = static_cast<uint16_t>(newestWhole(kGliderRoleHookAnswered));
  head.session = newestWhole(kGliderRoleHookInControl);
  const double clock = newest(kGliderRoleClock);
  head.clock_s = clock >= 1 && clock < UINT32_MAX ? static_cast<uint32_t>(clock) : 0;
  return head;
}

HookState Hookprog::hookState() const {
  const uint32_t state = newestWhole(kGliderRoleHookState);
  return state <= static_cast<uint32_t>(HookState::Complete) ? static_cast<HookState>(state)
                                                             : HookState::Absent;
}

double Hookprog::missionTime() const {
  const double time = newest(kGliderRoleMissionTime);
  return time == time ? time : 0;
}

uint32_t Hookprog::newestWhole(GliderRole role) const {
  const double value = newest(role);
  return value >= 0 && value <= kMostSession ? static_cast<uint32_t>(value) : 0;
}

void Hookprog::send(Frame& frame) {
  frame.sequence = ++out_sequence_;
  (void)out_.add(frame);  // no room: the line is not being read; the next cycle brings newer values
}

void Hookprog::loseSbc() {
  if (view_.phase != MissionPhase::Finished) {  // after that it may leave without an alarm
    event(Kind::SbcLost, link_);
  }
  link_ = 0;
  waiting_ = false;
  view_ = SbcView{};
}

void Hookprog::countBadFrames() {
  const uint32_t bad = reader_.badFrames() + flight_science_link_.badFrames() + malformed_;
  if (bad != bad_frames_told_) {
    event(Kind::BadFrame, bad - bad_frames_told_);
    bad_frames_told_ = bad;
  }
  if (stale_ != 0) {
    event(Kind::StaleFrame, stale_);
    stale_ = 0;
  }
}

void Hookprog::event(Kind kind, uint32_t a, uint32_t b, uint32_t c) {
  HookprogEvent told;
  told.kind = kind;
  told.mission_time_s = missionTime();
  told.a = a;
  told.b = b;
  told.c = c;
  events_.push(told);
}

}  // namespace glider::hooks
