// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/client/client.h"

#include "hooks/protocol/bounds.h"

#include <stddef.h>

namespace glider::hooks {

Client::Client(const GliderDictionary& dictionary, const ClientOptions& options)
    : dictionary_(&dictionary),
      options_(options),
      next_session_(options.session == 0 ? 1 : (options.session - 1) % kMostSession + 1) {
  const bool fits = options.sensor_count < kMostSubscriptions;
  const uint32_t count = fits ? options.sensor_count : kMostSubscriptions;
  subscription_.count = static_cast<uint8_t>(count);
  for (uint32_t i = 0; i < subscription_.count; ++i) {
    subscription_.sensors[i] = options.sensors[i];
  }
  subscription_check_ = subscriptionCheck(subscription_);
}

ClientEvent Client::poll(const GliderByteStream& stream, const GliderClock& clock) {
  (void)out_.flush(stream);  // a closed stream shows when it is read
  const FrameReader::Result result = reader_.next(stream);
  const double now = clock.now(clock.self);
  if (result == FrameReader::Result::Frame) {
    const ClientEvent event = handle(reader_.frame(), stream);
    if (!heard_ || event == ClientEvent::Tick) {
      // Only ticks advance mission time. Beacons must not restart this time-out, or mission time
      // would stop while they arrive.
      last_tick_s_ = now;
    }
    silence_s_ = event == ClientEvent::Tick ? kSilenceSecs : silence_s_;
    heard_ = true;
    return event;
  }
  if (result == FrameReader::Result::Closed) {
    return ClientEvent::Closed;
  }
  // Before the first frame there is no mission time to continue from, and it is not yet known
  // whether time is virtual.
  if (heard_ && !virtual_time_ && now - last_tick_s_ >= silence_s_) {
    last_tick_s_ = now;
    silence_s_ = kSilenceSecs;
    return ClientEvent::SilentLink;
  }
  return ClientEvent::Nothing;
}

ClientEvent Client::handle(const Frame& frame, const GliderByteStream& stream) {
  must_answer_ = expectsAnswer(frame);
  answered_frame_ = frame.sequence;
  switch (frame.type) {
    case MessageType::Beacon:
      return handleBeacon(frame, stream);
    case MessageType::Welcome:
      return handleWelcome(frame, stream);
    case MessageType::Tick:
      return handleTick(frame, stream);
    case MessageType::Hello:
    case MessageType::Subscribe:
    case MessageType::Write:
    case MessageType::Transition:
    case MessageType::Done:
    case MessageType::Note:
    case MessageType::Nap:
    case MessageType::Log:
      break;  // not addressed to the SBC; perhaps an echo of its own frames
  }
  return ClientEvent::Handled;
}

ClientEvent Client::handleBeacon(const Frame& frame, const GliderByteStream& stream) {
  Beacon beacon;
  ClientEvent event = ClientEvent::Handled;
  if (decode(frame, beacon)) {
    linked_ = false;
    const uint16_t missing = missingFeatures(options_.features, beacon.features);
    if (beacon.version != kProtocolVersion || beacon.dictionary != dictionary_->hash ||
        missing != 0) {
      event = refuse({true, beacon.version, beacon.dictionary, missing});
    } else {
      refusal_ = Refusal{};
      virtual_time_ =
          (beacon.features.offers & options_.features.offers & kFeatureVirtualTime) != 0;
    }
    askForLink();  // also after a refusal, so that the vehicle's log shows why there is no link
  }
  answer(stream);
  return event;
}

ClientEvent Client::refuse(const Refusal& refusal) {
  const bool told = refusal_ == refusal;
  refusal_ = refusal;
  return told ? ClientEvent::Handled : ClientEvent::Refused;
}

ClientEvent Client::handleWelcome(const Frame& frame, const GliderByteStream& stream) {
  Welcome welcome;
  if (decode(frame, welcome) && link_ != 0 && welcome.link == link_) {
    takeLink();
    virtual_time_ = welcome.virtual_time;
    learnSession(welcome.newest_session);
    if (waiting_) {
      queueInstruction();  // what was written before this link may not have been delivered
    }
  }
  answer(stream);
  return ClientEvent::Handled;
}

/// The vehicle has accepted our link, so its version, dictionary and features match ours. An
/// earlier refusal may have come from a damaged frame that passed as a Beacon of another version:
/// Beacons are protected by a CRC-16 only.
void Client::takeLink() {
  refusal_ = Refusal{};
  linked_ = true;
  link_used_ = true;
}

ClientEvent Client::handleTick(const Frame& frame, const GliderByteStream& stream) {
  TickHead head;
  if (!decode(frame, head)) {
    answer(stream);
    return ClientEvent::Handled;
  }
  virtual_time_ = head.virtual_time;
  if (link_ == 0 || head.link != link_ || !isNewCycle(head.cycle)) {
    // The vehicle serves the link of an earlier program, or has restarted its cycle count, or this
    // is a repeated earlier frame. A new link distinguishes these cases.
    askForLink();
    answer(stream);
    return ClientEvent::Handled;
  }
  takeLink();
  takeTick(head);
  cycle_known_ = true;
  resubscribe_ = !takeReadings(frame, head);
  learnSession(head.session);
  followInstruction();
  tick_.instruction_sequence = sequence_;
  return ClientEvent::Tick;
}

bool Client::isNewCycle(uint32_t cycle) const {
  const uint32_t ahead = (cycle - tick_.cycle) & kMostSession;
  return !cycle_known_ || (ahead != 0 && ahead <= kMostSession / 2);
}

void Client::takeTick(const TickHead& head) {
  tick_.vehicle_time_s = head.vehicle_time_s;
  tick_.cycle = head.cycle;
  tick_.hook_state = head.hook_state;
  tick_.answer = head.answer;
  tick_.answered_sequence = head.answered_sequence;
  tick_.session = head.session;
  tick_.clock_s = head.clock_s;
  tick_.kept = head.kept;
  tick_.reading_count = 0;
}

/// False when the vehicle serves a different subscription, or assumes that this side knows a value
/// that it does not know: the subscription must then be sent again.
bool Client::takeReadings(const Frame& frame, const TickHead& head) {
  TickReadings told;
  if (head.subscription != subscription_check_ ||
      !decode(*dictionary_, frame, subscription_, told)) {
    return false;
  }
  bool all_known = true;
  for (uint32_t i = 0; i < subscription_.count; ++i) {
    all_known = takeReading(i, told) && all_known;
  }
  return all_known;
}

bool Client::takeReading(uint32_t index, const TickReadings& told) {
  if (told.told[index] == ReadingReport::Nothing) {
    return true;
  }
  if (told.told[index] == ReadingReport::Value) {
    held_[index] = told.values[index];
    holds_[index] = true;
  }
  if (holds_[index]) {
    tick_.readings[tick_.reading_count++] = {subscription_.sensors[index].id, held_[index]};
  }
  return holds_[index];
}

void Client::followInstruction() {
  tick_.obeys_us =
      session_ != 0 && tick_.session == session_ && tick_.hook_state == HookState::Active;
  taken_ = taken_ || tick_.obeys_us;
  if (tick_.answer != HookAnswer::OldSequence) {
    settled_ = tick_.answered_sequence;
  }
  const bool unwritten = due_;
  if (waiting_) {
    lookForAnswer();
  }
  // A tick that was kept was made before the vehicle could answer anything.
  const bool heard = !waiting_ || unwritten || settled_ != last_settled_ || tick_.kept;
  unanswered_ticks_ = heard ? 0 : unanswered_ticks_ + 1;
  last_settled_ = settled_;
  tick_.unanswered_ticks = unanswered_ticks_;
}

void Client::lookForAnswer() {
  const bool shown = tick_.answered_sequence == sequence_;
  const bool old = tick_.answer == HookAnswer::OldSequence;
  // A hookbeh that has just started treats the number that it finds as an old one.
  const bool never = shown && (tick_.answer == HookAnswer::None || old);
  if (shown && old) {
    // It has decided on a number that this program does not know. Of four numbers that are a
    // quarter of the number range apart, at least one is newer.
    sequence_ = static_cast<uint16_t>((sequence_ + UINT16_MAX / 4) % UINT16_MAX);
  }
  if (never) {
    renumber();  // under this number it will never look at the instruction
  }
  waiting_ = never || !shown || tick_.answer == HookAnswer::BadCheck;
  due_ = waiting_;
}

void Client::learnSession(uint32_t session) {
  if (!hookIsNewerSession(next_session_, session)) {
    next_session_ = hookNextSession(session);
  }
}

uint16_t Client::instruct(Instruction instruction) {
  if (instruction.control == HookControl::Take) {
    session_ = next_session_;
    next_session_ = hookNextSession(next_session_);
    taken_ = false;
  } else if (instruction.control == HookControl::Steer && !taken_) {
    instruction.control = HookControl::Take;
  }
  claims_ = true;
  instruction.session = session_;
  hookInSteps(&instruction, &pending_);
  renumber();
  waiting_ = true;
  due_ = true;
  return sequence_;
}

void Client::renumber() {
  // `theirs` is at least as new as any number of an earlier program that hookbeh has decided on or
  // that is in the sensor array.
  const uint16_t theirs = settled_ != 0 ? settled_ : tick_.answered_sequence;
  if (hookIsNewerSequence(theirs, sequence_)) {
    sequence_ = theirs;
  }
  sequence_ = hookNextSequence(sequence_);
  pending_.sequence = sequence_;
}

void Client::resume(uint32_t session, uint16_t sequence) {
  session_ = session;
  sequence_ = sequence;
  claims_ = false;
  taken_ = false;
  learnSession(session);
}

void Client::notify(const TransitionNotice& notice) {
  if (notice_count_ < kMostNotices) {
    notices_[notice_count_++] = notice;
  }
}

void Client::tell(const MissionNote& note) {
  if (note_count_ < kMostNotes) {
    notes_[note_count_++] = note;
  }
}

bool Client::nap(const Nap& nap) {
  const bool is_alone = !resubscribe_ && !due_ && notice_count_ == 0 && note_count_ == 0;
  const bool sent = must_answer_ && mayNap() && is_alone;
  if (sent) {
    Frame frame;
    encode(nap, frame);
    queue(frame);
    silence_s_ = kSilenceSecs + kLateSecs + nap.length_s + nap.wake_s;
  }
  return sent;
}

ClientPart Client::brokenPart() const {
  // In the order of ClientPart, from Subscription on.
  static constexpr Bound kBounds[] = {
      {offsetof(Client, subscription_.count), kMostSubscriptions, 1},
      {offsetof(Client, tick_.reading_count), kMostSubscriptions, 4},
      {offsetof(Client, notice_count_), kMostNotices, 4},
      {offsetof(Client, note_count_), kMostNotes, 4},
      {offsetof(Client, pending_.control), static_cast<uint16_t>(HookControl::Release), 1},
      {offsetof(Client, pending_.vertical), static_cast<uint16_t>(HookVertical::Actuators), 1},
      {offsetof(Client, pending_.lateral), static_cast<uint16_t>(HookLateral::Fin), 1},
  };
  if (out_.held() > SendQueue::kCapacity) {
    return ClientPart::SendQueue;
  }
  if (reader_.held() > FrameReader::kBytes) {
    return ClientPart::Reader;
  }
  constexpr auto kFirst = static_cast<uint32_t>(ClientPart::Subscribed);
  constexpr uint32_t kCount = sizeof kBounds / sizeof kBounds[0];
  static_assert(kFirst + kCount == static_cast<uint32_t>(ClientPart::Lateral) + 1);
  const uint32_t past = firstPast(this, kBounds);
  return past == kCount ? ClientPart::None : static_cast<ClientPart>(kFirst + past);
}

void Client::done(const MissionStatus& status, const GliderByteStream& stream) {
  status_ = status;
  if (!must_answer_) {
    return;
  }
  if (resubscribe_) {
    queueSubscribe();
    resubscribe_ = false;
  }
  for (uint32_t i = 0; i < notice_count_; ++i) {
    Frame frame;
    encode(notices_[i], frame);
    queue(frame);
  }
  notice_count_ = 0;
  if (due_) {
    queueInstruction();
  }
  queueNotes();
  answer(stream);
}

/// Notes come last before Done, and leave room for it and for the next answers.
void Client::queueNotes() {
  constexpr uint32_t kReserve = 1024;
  for (uint32_t i = 0; i < note_count_ && out_.room() > kReserve; ++i) {
    Frame frame;
    encode(notes_[i], frame);
    queue(frame);
  }
  note_count_ = 0;
}

void Client::queue(Frame& frame) {
  frame.sequence = ++out_sequence_;
  (void)out_.add(
      frame);  // no room: the line has been stuck for many answers, and what matters is repeated
}

/// Requests the same link number again while the vehicle may still accept it. Otherwise, on a line
/// with a delay of more than one cycle, each answer would cancel the previous one.
void Client::askForLink() {
  if (link_ == 0) {
    link_ = next_session_;
  } else if (link_used_) {
    link_ = hookNextSession(link_);
  }
  link_used_ = false;
  cycle_known_ = false;
  queueHello();
  queueSubscribe();
}

void Client::queueHello() {
  Hello hello;
  hello.features = options_.features;
  hello.link = link_;
  hello.dictionary = dictionary_->hash;
  const char* name = options_.mission_name == nullptr ? "" : options_.mission_name;
  for (uint32_t i = 0; i < kMostNameBytes && name[i] != 0; ++i) {
    hello.mission_name[i] = name[i];
  }
  Frame frame;
  encode(hello, frame);
  queue(frame);
}

void Client::queueSubscribe() {
  for (bool& holds : holds_) {
    holds = false;
  }
  Frame frame;
  encode(subscription_, frame);
  queue(frame);
}

void Client::queueInstruction() {
  double words[sizeof kInstructionWords / sizeof kInstructionWords[0]];
#define WORD(role, sensor, word, field, bytes, steps, line) \
  words[line] = static_cast<double>(pending_.field);
#define CHECK_WORD(role, sensor, word, line) \
  words[line] = static_cast<double>(checkValue(pending_));
#define LATER_WORD(role, sensor, word, field, line) \
  words[line] = static_cast<double>(pending_.field);
#include "hooks/protocol/instruction.def"
  // The last is of missions that sample.
  const bool samples = (options_.features.needs & kFeatureSampling) != 0;
  const uint32_t count = kWordsOfEvery + (samples ? 1U : 0U);
  Frame frame;
  encodeEmptyList(frame);
  // On the line the words go in the order of their roles.
  for (uint32_t i = 0; i < count; ++i) {
    const auto role = static_cast<GliderRole>(kGliderRoleHookSession + i);
    (void)appendValue(*dictionary_, frame, {sensorOf(*dictionary_, role), words[i]});
  }
  queue(frame);
  due_ = false;
}

void Client::answer(const GliderByteStream& stream) {
  if (must_answer_) {
    Frame frame;
    const uint32_t claimed = claims_ && unanswered_ticks_ < kMostUnansweredTicks ? session_ : 0;
    encode(Done{answered_frame_, claimed, status_}, frame);
    queue(frame);
    must_answer_ = false;
  }
  (void)out_.flush(stream);
}

}  // namespace glider::hooks
