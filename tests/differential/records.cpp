// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/differential/records.h"

#include <bit>

#include "ir/eval/interpreter.h"
#include "ir/verify/verify.h"
#include "support/check.h"

namespace glider::differential {
namespace {

uint64_t wordOf(double value) {
  return value == value ? std::bit_cast<uint64_t>(value) : 0x7FF8000000000000ULL;
}

void appendRun(const ir::ActivityRun& run, uint64_t block, Words& words) {
  words.push_back(block);
  words.push_back(static_cast<uint64_t>(run.phase));
  for (const double argument : run.arguments) {
    words.push_back(wordOf(argument));
  }
}

Words record(const ir::Mission& mission, const ir::Interpreter& interpreter,
             const ir::TickResult& tick) {
  Words words;
  if (tick.profile) {
    appendRun(*tick.profile, uint64_t{2} * tick.state.index, words);
    appendRun(*tick.route, uint64_t{2} * tick.state.index + 1, words);
  }
  words.push_back(tick.state.index);
  words.push_back(tick.finished ? 1 : 0);
  words.push_back(tick.fired_case.value_or(UINT32_MAX));
  words.push_back(tick.stack.size());
  for (const ir::Frame& frame : tick.stack) {
    words.push_back(frame.state.index);
    words.push_back(wordOf(frame.entered));
  }
  for (const ir::LogItem& item : mission[tick.state].log) {
    words.push_back(wordOf(interpreter.number(item.value)));
  }
  return words;
}

}  // namespace

Trial randomTrial(uint64_t seed, size_t ticks) {
  Trial trial;
  trial.name = "mission and stream of seed " + std::to_string(seed);
  trial.mission = random_missions::randomMission(seed);
  support::DiagnosticEngine diagnostics;
  trial.stack_depth = ir::verify(trial.mission, diagnostics).stack_depth;
  CHECK(!diagnostics.hasErrors(), "a random mission with errors");
  trial.stream = random_missions::randomStream(trial.mission, seed, ticks);
  return trial;
}

void appendStream(const Trial& trial, Words& words) {
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
  ir::Interpreter interpreter(trial.mission, trial.stack_depth);
  std::vector<Words> records;
  for (const random_missions::StreamTick& tick : trial.stream) {
    const ir::TickResult result = records.empty()
                                      ? interpreter.start(tick.frame)
                                      : interpreter.tick(tick.mission_time, tick.frame);
    records.push_back(record(trial.mission, interpreter, result));
  }
  return records;
}

}  // namespace glider::differential
