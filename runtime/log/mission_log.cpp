// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/log/mission_log.h"

namespace glider::runtime {
namespace {

void put(hooks::ByteWriter& writer, const char* text) {
  for (uint32_t i = 0; i < MissionLog::kNameBytes && text[i] != '\0'; ++i) {
    writer.u8(static_cast<uint8_t>(text[i]));
  }
}

void put16(hooks::ByteWriter& writer, uint32_t value) {
  writer.u16(static_cast<uint16_t>(value));
}

}  // namespace

const GliderCaseInfo& madeCase(const GliderContext& context, uint32_t from) {
  const GliderMission& mission = *context.mission;
  return context.moved_list == kGliderListAlways ? mission.always[context.moved_case]
                                                 : mission.states[from]->cases[context.moved_case];
}

hooks::ByteWriter MissionLog::open(LogRecord kind) {
  if (head_ == Head::Missing) {  // before any first record: a link may be refused at once
    head_ = Head::Writing;
    writeHead();
    head_ = head_ == Head::Writing ? Head::HandedOn : head_;
  }
  return start(kind);
}

hooks::ByteWriter MissionLog::start(LogRecord kind) {
  ++frame_.sequence;
  urgent_ = urgent_ || kind != LogRecord::Values;
  hooks::ByteWriter writer = hooks::startPayload(frame_, hooks::MessageType::Log);
  writer.u8(static_cast<uint8_t>(kind));
  return writer;
}

void MissionLog::close(const hooks::ByteWriter& writer) {
  if (sink_.write == nullptr) {
    return;
  }
  hooks::finishPayload(frame_, writer);
  if (kBytes - size_ < hooks::encodedBound(frame_.size)) {
    (void)handOver();
  }
  size_ += hooks::encodeFrame(frame_, bytes_ + size_);
}

/// What a reader needs: the name that each number stands for.
void MissionLog::writeHead() {
  hooks::ByteWriter writer = start(LogRecord::Start);
  writer.u8(kLogVersion);
  put(writer, mission_.name);
  close(writer);
  for (uint32_t i = 0; i < mission_.parameter_count; ++i) {
    name(LogNamed::Parameter, i, 0, mission_.parameters[i].name);
  }
  for (uint32_t i = 0; i < mission_.sensor_count; ++i) {
    name(LogNamed::Sensor, i, 0, mission_.sensors[i].name);
  }
  for (uint32_t i = 0; i < mission_.state_count; ++i) {
    const GliderStateInfo& state = *mission_.states[i];
    name(LogNamed::State, i, 0, state.name);
    for (uint32_t item = 0; item < state.log_count; ++item) {
      name(LogNamed::Item, i, item, state.log[item].name);
    }
  }
}

void MissionLog::name(LogNamed what, uint32_t number, uint32_t item, const char* text) {
  hooks::ByteWriter writer = start(LogRecord::Name);
  writer.u8(static_cast<uint8_t>(what));
  put16(writer, number);
  put16(writer, item);
  put(writer, text);
  close(writer);
}

void MissionLog::begin(const GliderContext& context) {
  hooks::ByteWriter writer = open(LogRecord::Begin);
  for (uint32_t i = 0; i < mission_.parameter_count; ++i) {
    writer.f64(context.variables[i]);
  }
  close(writer);
}

bool MissionLog::due(const GliderContext& context, uint32_t item) {
  const double period = mission_.states[context.state]->log[item].period;
  return last_written_state_ != context.state || context.mission_time - written_[item] >= period;
}

void MissionLog::values(const GliderContext& context) {
  const GliderStateInfo& state = *mission_.states[context.state];
  hooks::ByteWriter writer = open(LogRecord::Values);
  writer.f64(context.mission_time);
  put16(writer, context.state);
  const uint32_t before = writer.size();
  for (uint32_t item = 0; item < state.log_count && item < kMostItems; ++item) {
    // Items that do not fit into a record are due in the next tick.
    if (due(context, item) && hooks::kMostPayload - writer.size() >= 9) {
      written_[item] = context.mission_time;
      writer.u8(static_cast<uint8_t>(item));
      writer.f64(gliderLogValue(&context, item));
    }
  }
  last_written_state_ = context.state;
  if (writer.size() == before) {
    --frame_.sequence;
    return;
  }
  close(writer);
}

void MissionLog::transition(const GliderContext& context, uint32_t from, const StateTimes& times) {
  hooks::ByteWriter writer = open(LogRecord::Transition);
  writer.f64(context.mission_time);
  writer.f64(context.mission_time - times.entered);
  writer.f64(context.mission_time - times.resumed);
  writer.u8(static_cast<uint8_t>(madeCase(context, from).transition));
  writer.u8(static_cast<uint8_t>(context.moved_list));
  put16(writer, context.moved_case);
  put16(writer, from);
  put16(writer, context.state);
  for (uint32_t i = 0; i < mission_.sensor_count; ++i) {
    writer.f64(context.readings[i].value);
  }
  close(writer);
  last_written_state_ = UINT32_MAX;  // an entered state logs all its items at once
}

void MissionLog::note(const GliderContext& context, uint32_t note) {
  const GliderNote& told = context.notes[note];
  constexpr uint32_t kMostValues = 60;  // as many as a record holds in addition to the longest text
  const uint32_t count = told.count < kMostValues ? told.count : kMostValues;
  hooks::ByteWriter writer = open(LogRecord::Note);
  writer.f64(context.mission_time);
  writer.u8(static_cast<uint8_t>(told.kind));
  writer.u8(static_cast<uint8_t>(count));
  for (uint32_t i = 0; i < count; ++i) {
    writer.f64(context.note_values[told.first + i]);
  }
  put(writer, told.text);
  close(writer);
}

void MissionLog::event(double time, LogEvent what, LogDetail detail, double value) {
  hooks::ByteWriter writer = open(LogRecord::Event);
  writer.f64(time);
  writer.u8(static_cast<uint8_t>(what));
  writer.u8(static_cast<uint8_t>(detail));
  writer.f64(value);
  close(writer);
}

void MissionLog::failed(double time, uint32_t check, uint32_t count) {
  size_ = size_ <= kBytes ? size_ : 0;
  event(time, LogEvent::CheckFailed, static_cast<LogDetail>(check), static_cast<double>(count));
  flush();
}

bool MissionLog::handOver() {
  // A zero ends any incomplete record at the end of the log.
  static constexpr uint8_t kEnd[] = {0};
  if (torn_) {
    torn_ = sink_.write(sink_.self, kEnd, 1) != 1;
  }
  if (torn_ || sink_.write(sink_.self, bytes_, size_) != static_cast<int32_t>(size_)) {
    torn_ = true;
    ++failures_;
  }
  size_ = 0;
  if (torn_ && head_ != Head::Taken) {
    head_ = Head::Missing;  // without all of it, what follows could not be read
  } else if (!torn_ && head_ == Head::HandedOn) {
    head_ = Head::Taken;
  }
  return !torn_;
}

void MissionLog::flush() {
  if (size_ == 0) {
    return;
  }
  const bool urgent = urgent_;
  urgent_ = false;
  if (handOver() && urgent && sink_.sync != nullptr) {
    unsynced_ = sink_.sync(sink_.self) != 0;
    failures_ += unsynced_ ? 1 : 0;
  }
  if (sink_.renew != nullptr && sink_.renew(sink_.self) != 0) {
    head_ = Head::Missing;
  }
}

}  // namespace glider::runtime
