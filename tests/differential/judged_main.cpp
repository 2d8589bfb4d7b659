// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Runs compiled missions on a board: reads a file of sensor streams, writes a file of what each tick did. It steps the
// missions with the product's own runtime core; profiles and routes record how they are called. records.h says
// what the files hold.

#include "runtime/abi/context_layout.h"
#include "runtime/abi/runtime.h"
#include "runtime/board/arithmetic.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern "C" {
extern const GliderMission* const judgedMissions[];
extern const uint32_t judgedMissionCount;
}

namespace {

constexpr uint32_t kMostUpdates = 64;
constexpr uint32_t kMostWords = 1024;

FILE* streams;
FILE* records;
uint64_t context_memory[64 * 1024];
uint64_t words[kMostWords];
uint32_t word_count;

void giveUp(const char* why) {
  fprintf(stderr, "judged: %s\n", why);
  exit(1);
}

uint64_t next(void) {
  uint64_t word;
  if (fread(&word, sizeof word, 1, streams) != 1) {
    giveUp("the streams end early");
  }
  return word;
}

void put(uint64_t word) {
  if (word_count == kMostWords) {
    giveUp("a tick does too much");
  }
  words[word_count++] = word;
}

/// All NaNs are one: unknown.
void putNumber(double value) {
  const uint64_t exponent = 0x7FF0000000000000U;
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  put((bits & ~(uint64_t{1} << 63)) > exponent ? 0x7FF8000000000000U : bits);
}

void putCall(const GliderContext* context, const GliderBehaviourMemory* memory,
                    uint32_t phase) {
  put(static_cast<uint64_t>(memory - context->memory));
  put(phase);
}

void writeTick(const GliderContext* context, uint32_t fired) {
  put(context->state);
  put(context->finished);
  put(fired);
  put(context->stack_depth);
  for (uint32_t i = 0; i < context->stack_depth; ++i) {
    put(context->frames[i].state);
    putNumber(context->frames[i].entered);
  }
  const GliderStateInfo* state = &context->mission->states[context->state];
  for (uint32_t i = 0; i < state->log_count; ++i) {
    putNumber(context->mission->log_value(context, i));
  }
  const uint64_t count = word_count;
  if (fwrite(&count, sizeof count, 1, records) != 1 ||
      fwrite(words, sizeof words[0], word_count, records) != word_count) {
    giveUp("the records cannot be written");
  }
  word_count = 0;
}

double readTick(GliderUpdate* updates, uint32_t* count) {
  double time;
  const uint64_t bits = next();
  memcpy(&time, &bits, sizeof time);
  *count = static_cast<uint32_t>(next());
  if (*count > kMostUpdates) {
    giveUp("a frame holds too many sensors");
  }
  for (uint32_t i = 0; i < *count; ++i) {
    updates[i].id = static_cast<uint32_t>(next());
    const uint64_t value = next();
    memcpy(&updates[i].value, &value, sizeof value);
  }
  return time;
}

void fly(const GliderMission* mission) {
  GliderUpdate updates[kMostUpdates];
  uint32_t count;
  const GliderContextLayout layout =
      gliderContextLayout(mission->sensor_count, mission->stack_limit, mission->memory_count);
  if (layout.bytes != mission->context_bytes || layout.bytes > sizeof context_memory) {
    giveUp("generated code and the runtime differ on the size of the context");
  }
  const uint64_t ticks = next();
  readTick(updates, &count);
  GliderContext* context = gliderStart(context_memory, mission, updates, count);
  writeTick(context, context->fired_case);
  for (uint64_t i = 1; i < ticks; ++i) {
    const double time = readTick(updates, &count);
    const uint32_t was_finished = context->finished;
    gliderStep(context, time, updates, count);
    writeTick(context, was_finished != 0 ? GLIDER_NO_CASE : context->fired_case);
  }
}

}  // namespace

extern "C" void gliderProfileRecord(GliderContext* context, GliderBehaviourMemory* memory, uint32_t phase,
                         double number, double length, double time, double temperature) {
  putCall(context, memory, phase);
  putNumber(number);
  putNumber(length);
  putNumber(time);
  putNumber(temperature);
}

extern "C" void gliderRouteRecord(GliderContext* context, GliderBehaviourMemory* memory, uint32_t phase,
                       double number, double latitude, double longitude) {
  putCall(context, memory, phase);
  putNumber(number);
  putNumber(latitude);
  putNumber(longitude);
}

int main(int argc, char** argv) {
  glider::runtime::useDoublePrecision();
  if (argc != 3 || (streams = fopen(argv[1], "rb")) == nullptr ||
      (records = fopen(argv[2], "wb")) == nullptr) {
    giveUp("usage: judged STREAMS RECORDS");
  }
  for (uint32_t i = 0; i < judgedMissionCount; ++i) {
    fly(judgedMissions[i]);
  }
  if (fclose(records) != 0) {
    giveUp("the records cannot be written");
  }
  return 0;
}
