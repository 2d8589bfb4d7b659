// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/log/mission_log.h"

#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

const char* transitionName(uint32_t transition, bool always) {
  switch (transition) {
    case kGliderGoto:
      return always ? "always goto" : "goto";
    case kGliderCall:
      return always ? "always call" : "call";
    case kGliderReturn:
      return "return";
    case kGliderExit:
      return always ? "always exit" : "exit";
    default:
      return "stay";
  }
}

bool needsQuotes(const char* name) {
  for (; *name != '\0'; ++name) {
    if (*name == ',' || *name == '"' || *name == '\n' || *name == '\r') {
      return true;
    }
  }
  return false;
}

}  // namespace

const GliderCaseInfo& madeCase(const GliderContext& context, uint32_t from) {
  const GliderMission& mission = *context.mission;
  return context.moved_list == kGliderListAlways ? mission.always[context.moved_case]
                                                 : mission.states[from]->cases[context.moved_case];
}

void MissionLog::begin(const GliderContext& context) {
  const GliderMission& mission = *context.mission;
  line({.time = 0.0, .record = "mission", .name = mission.name, .value = unknown()});
  for (uint32_t i = 0; i < mission.parameter_count; ++i) {
    line({.time = 0.0,
          .record = "parameter",
          .name = mission.parameters[i].name,
          .value = context.variables[i]});
  }
  line({.time = 0.0, .record = "state", .name = mission.states[0]->name, .value = unknown()});
}

bool MissionLog::due(const GliderContext& context, uint32_t item) {
  const double period = context.mission->states[context.state]->log[item].period;
  return last_written_state_ != context.state || context.mission_time - written_[item] >= period;
}

void MissionLog::values(const GliderContext& context) {
  const GliderStateInfo& state = *context.mission->states[context.state];
  const uint32_t count = state.log_count < kMostItems ? state.log_count : kMostItems;
  for (uint32_t item = 0; item < count; ++item) {
    if (due(context, item)) {
      written_[item] = context.mission_time;
      line({.time = context.mission_time,
            .record = "value",
            .name = state.log[item].name,
            .value = gliderLogValue(&context, item)});
    }
  }
  last_written_state_ = context.state;
}

void MissionLog::transition(const GliderContext& context, uint32_t from) {
  const GliderStateInfo* const* states = context.mission->states;
  const uint32_t transition = madeCase(context, from).transition;
  const bool always = context.moved_list == kGliderListAlways;
  line({.time = context.mission_time,
        .record = "transition",
        .name = transitionName(transition, always),
        .value = static_cast<double>(context.moved_case) + 1.0,
        .from = states[from]->name,
        .to = transition == kGliderExit ? "" : states[context.state]->name});
  last_written_state_ = UINT32_MAX;  // an entered state logs all its items at once
}

void MissionLog::note(const GliderContext& context, uint32_t note) {
  const GliderNote& told = context.notes[note];
  if (told.kind == kGliderNoteUnknownSet) {
    event(context.mission_time, "unknown set", told.text, unknown());
    return;
  }
  for (uint32_t i = 0; i == 0 || i < told.count; ++i) {
    line({.time = context.mission_time,
          .record = "log",
          .name = told.text,
          .value = i < told.count ? context.note_values[told.first + i] : unknown()});
  }
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

/// As comma-separated files have it: in quotes, each quote in it twice, where it must be.
void MissionLog::putName(const char* name) {
  if (!needsQuotes(name)) {
    text_.put(name, kNameBytes);
    return;
  }
  text_.put('"');
  for (uint32_t i = 0; i < kNameBytes && name[i] != '\0'; ++i) {
    if (name[i] == '"') {
      text_.put('"');
    }
    text_.put(name[i]);
  }
  text_.put('"');
}

void MissionLog::compose(const Fields& fields) {
  text_.put(fields.time).put(',').put(fields.record).put(',');
  putName(fields.name);
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
