// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/log/mission_log.h"

#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

const char* transitionName(uint32_t transition) {
  switch (transition) {
    case kGliderGoto:
      return "goto";
    case kGliderCall:
      return "call";
    case kGliderReturn:
      return "return";
    case kGliderExit:
      return "exit";
    default:
      return "stay";
  }
}

}  // namespace

void MissionLog::begin(const GliderMission& mission) {
  line({.time = 0.0, .record = "mission", .name = mission.name, .value = unknown()});
  line({.time = 0.0, .record = "state", .name = mission.states[0].name, .value = unknown()});
}

bool MissionLog::due(const GliderContext& context, uint32_t item) {
  const double period = context.mission->states[context.state].log[item].period;
  return last_written_state_ != context.state || context.mission_time - written_[item] >= period;
}

void MissionLog::values(const GliderContext& context) {
  const GliderStateInfo& state = context.mission->states[context.state];
  const uint32_t count = state.log_count < kMostItems ? state.log_count : kMostItems;
  for (uint32_t item = 0; item < count; ++item) {
    if (due(context, item)) {
      written_[item] = context.mission_time;
      line({.time = context.mission_time,
            .record = "value",
            .name = state.log[item].name,
            .value = context.mission->log_value(&context, item)});
    }
  }
  last_written_state_ = context.state;
}

void MissionLog::transition(const GliderContext& context, uint32_t from, uint32_t fired) {
  const GliderStateInfo* states = context.mission->states;
  const GliderCaseInfo& made = states[from].cases[fired];
  line({.time = context.mission_time,
        .record = "transition",
        .name = transitionName(made.transition),
        .value = static_cast<double>(fired + 1),
        .from = states[from].name,
        .to = made.transition == kGliderExit ? "" : states[context.state].name});
  last_written_state_ = UINT32_MAX;  // an entered state logs all its items at once
}

void MissionLog::event(double time, const char* name, const char* detail, double value) {
  line({.time = time, .record = "event", .name = name, .value = value, .from = detail});
}

void MissionLog::line(const Fields& fields) {
  if (sink_.write == nullptr) {
    return;
  }
  if (!headed_) {  // before whatever comes first: a link may be refused before the mission begins
    text_.put("time_s,record,name,value,from,to\n");
    headed_ = true;
  }
  const uint32_t before = text_.size();
  compose(fields);
  if (text_.full()) {  // hand on the lines before, then this one fits
    text_.cut(before);
    flush();
    compose(fields);
  }
}

void MissionLog::compose(const Fields& fields) {
  text_.put(fields.time).put(',').put(fields.record).put(',').put(fields.name, kNameBytes);
  text_.put(',').put(fields.value).put(',').put(fields.from, kNameBytes);
  text_.put(',').put(fields.to, kNameBytes).put('\n');
}

void MissionLog::flush() {
  if (sink_.write == nullptr || text_.size() == 0) {
    text_.cut(0);
    return;
  }
  static constexpr uint8_t kNewLine[] = {'\n'};
  if (torn_) {
    torn_ = sink_.write(sink_.self, kNewLine, 1) != 1;
  }
  const auto* bytes = reinterpret_cast<const uint8_t*>(text_.bytes());
  const bool taken =
      !torn_ && sink_.write(sink_.self, bytes, text_.size()) == static_cast<int32_t>(text_.size());
  if (!taken) {
    torn_ = true;
    ++failures_;
  }
  text_.cut(0);
}

}  // namespace glider::runtime
