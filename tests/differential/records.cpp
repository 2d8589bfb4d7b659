// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/differential/records.h"

#include "ir/eval/foresee.h"
#include "ir/eval/interpreter.h"
#include "ir/opt/optimise.h"
#include "ir/verify/verify.h"
#include "support/check.h"

#include <bit>

namespace glider::differential {
namespace {

uint64_t wordOf(double value) {
  return value == value ? std::bit_cast<uint64_t>(value) : 0x7FF8000000000000ULL;
}

constexpr uint64_t kCommands = 100;

void appendNumbers(const std::vector<double>& numbers, Words& words) {
  for (const double number : numbers) {
    words.push_back(wordOf(number));
  }
}

/// The block of memory of a use of a C function: they are counted state by state, profile first.
uint64_t blockOf(const ir::Mission& mission, uint32_t state, ir::ListKind list) {
  uint64_t block = 0;
  auto count = [&](const ir::Activity& activity) {
    block += mission[activity.behaviour].symbol.empty() ? 0U : 1U;
  };
  for (uint32_t i = 0; i < state; ++i) {
    count(mission.states[i].profile);
    count(mission.states[i].route);
  }
  if (list == ir::ListKind::Route) {
    count(mission.states[state].profile);
  }
  return block;
}

/// Actions of C functions are of the state that is current after the tick: one that a transition
/// leaves has not come to its profile.
void appendActions(const ir::Mission& mission, const ir::TickResult& tick, Words& words) {
  for (const ir::Action& action : tick.actions) {
    if (const auto* run = std::get_if<ir::ActivityRun>(&action)) {
      words.push_back(static_cast<uint64_t>(run->list));
      words.push_back(static_cast<uint64_t>(run->phase));
      words.push_back(blockOf(mission, tick.state.index, run->list));
      appendNumbers(run->arguments, words);
    } else {
      const auto& command = std::get<ir::CommandRun>(action);
      words.push_back(kCommands + static_cast<uint64_t>(command.command));
      words.push_back(command.arguments.size());
      appendNumbers(command.arguments, words);
    }
  }
}

uint64_t digest(const std::string& text) {
  uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash = (hash ^ static_cast<uint8_t>(c)) * 0x100000001b3U;
  }
  return hash;
}

void appendNotes(const ir::TickResult& tick, Words& words) {
  words.push_back(tick.notes.size());
  for (const ir::Note& note : tick.notes) {
    words.push_back(static_cast<uint64_t>(note.kind));
    words.push_back(digest(note.text));
    words.push_back(note.values.size());
    appendNumbers(note.values, words);
  }
  words.push_back(tick.lost_notes);
}

void appendMoves(const ir::TickResult& tick, Words& words) {
  words.push_back(tick.state.index);
  words.push_back(tick.finished ? 1 : 0);
  words.push_back(tick.limit);
  words.push_back(tick.just_returned ? 1 : 0);
  for (const auto& fired : tick.fired) {
    words.push_back(fired.value_or(UINT32_MAX));
  }
  words.push_back(tick.moved ? static_cast<uint64_t>(tick.moved->list) : UINT32_MAX);
  words.push_back(tick.moved ? tick.moved->number : UINT32_MAX);
  words.push_back(tick.stack.size());
  for (const ir::Frame& frame : tick.stack) {
    words.push_back(frame.state.index);
    words.push_back(wordOf(frame.entered));
    words.push_back(frame.limit);
  }
}

/// Of a mission that may sleep: what ir/eval foresees.
void appendForeseen(const Trial& trial, const ir::Interpreter& interpreter,
                    const ir::TickResult& tick, Words& words) {
  if (!trial.mission.nap_s || tick.finished) {
    return;
  }
  const ir::Wake wake = ir::wakeOf(trial.mission, tick.state);
  const ir::Foreseen foreseen = ir::foresee(interpreter, wake, tick);
  const bool awake = foreseen.awake || !ir::maySleep(trial.mission, wake);
  words.push_back(awake ? 1 : 0);
  if (awake) {
    return;
  }
  words.push_back(wordOf(std::min(foreseen.seconds, 1e300)));
  for (const ir::Foreseen::Cause& cause : foreseen.causes) {
    words.push_back(cause.kind == ir::WakeKind::Crossed ? 0
                    : cause.kind == ir::WakeKind::Known ? 1
                                                        : 2);
    words.push_back(cause.sensor.index);
    words.push_back(std::bit_cast<uint64_t>(cause.number));
  }
}

Words record(const Trial& trial, const ir::Interpreter& interpreter, const ir::TickResult& tick) {
  Words words;
  appendActions(trial.mission, tick, words);
  appendMoves(tick, words);
  appendNumbers(tick.variables, words);
  words.push_back(wordOf(tick.sampling));
  appendNotes(tick, words);
  words.push_back(ir::failedCondition(trial.mission, trial.parameters).value_or(UINT32_MAX));
  for (const ir::LogItem& item : trial.mission[tick.state].log) {
    const ir::Value value = interpreter.evaluate(item.value);
    words.push_back(wordOf(ir::asNumber(value)));
  }
  appendForeseen(trial, interpreter, tick, words);
  return words;
}

}  // namespace

Trial randomTrial(uint64_t seed, size_t ticks, bool optimised) {
  Trial trial;
  trial.name = "mission and stream of seed " + std::to_string(seed);
  trial.mission = random_missions::flownMission(seed);
  trial.stream = random_missions::randomStream(trial.mission, seed, ticks);
  trial.parameters = random_missions::randomParameters(trial.mission, seed);
  if (optimised) {
    trial.name += ", optimised";
    trial.mission = ir::optimise(std::move(trial.mission));
  }
  if (seed % 3 == 0) {
    trial.mission.nap_s = 240;
  }
  support::DiagnosticEngine diagnostics;
  trial.stack_depth = ir::verify(trial.mission, diagnostics).stack_depth;
  CHECK(!diagnostics.hasErrors(), "a random mission with errors");
  return trial;
}

void appendStream(const Trial& trial, Words& words) {
  words.push_back(trial.parameters.size());
  appendNumbers(trial.parameters, words);
  words.push_back(trial.stream.size());
  for (const random_missions::StreamTick& tick : trial.stream) {
    words.push_back(std::bit_cast<uint64_t>(tick.mission_time));
    words.push_back(tick.frame.size());
    for (const ir::SensorUpdate& update : tick.frame) {
      words.push_back(trial.mission[update.sensor].id);
      words.push_back(std::bit_cast<uint64_t>(update.raw));
    }
  }
}

std::vector<Words> expectedRecords(const Trial& trial) {
  ir::Interpreter interpreter(trial.mission, trial.stack_depth, random_missions::randomExternals());
  std::vector<Words> records;
  for (const random_missions::StreamTick& tick : trial.stream) {
    const ir::TickResult result = records.empty() ? interpreter.start(tick.frame, trial.parameters)
                                                  : interpreter.tick(tick.mission_time, tick.frame);
    records.push_back(record(trial, interpreter, result));
  }
  return records;
}

}  // namespace glider::differential
