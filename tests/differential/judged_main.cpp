// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Runs compiled missions on a board: reads a file of sensor streams, writes a file of what each
// tick did. It steps the missions with the product's own runtime core; behaviours in C and
// commands record how they are called. records.h says what the files hold.

#include "runtime/abi/behaviour.h"
#include "runtime/abi/context_layout.h"
#include "runtime/abi/runtime.h"
#include "runtime/board/arithmetic.h"
#include "tests/random_missions/external_functions.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern "C" {
extern const GliderMission* const judgedMissions[];
extern const uint32_t judgedMissionCount;
}

namespace {

constexpr uint32_t kMostUpdates = 64;
constexpr uint32_t kMostWords = 4096;
constexpr uint32_t kMostParameters = 64;
constexpr uint64_t kCommands = 100;  // records.h

FILE* streams;
FILE* records;
uint64_t context_memory[64 * 1024];
uint64_t words[kMostWords];
uint32_t word_count;

ExternalState externals;

template <uint32_t N>
double externalOf(uint32_t which, const double (&arguments)[N]) {
  externalAsked(&externals, which, 0);
  for (const double argument : arguments) {
    externalAsked(&externals, which, argument);
  }
  return externalAnswer(&externals);
}

void giveUp(const char* why) {
  fprintf(stderr, "judged_main: %s\n", why);
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

/// An action: a call of a C function, or of a command, of which `number` is the list or the
/// command's own number from kCommands on.
void putAction(uint64_t number, uint64_t detail) {
  put(number);
  put(detail);
}

void putCommand(uint64_t command, uint32_t count, const double* arguments) {
  putAction(kCommands + command, count);
  for (uint32_t i = 0; i < count; ++i) {
    putNumber(arguments[i]);
  }
}

/// FNV-1a.
uint64_t digest(const char* text) {
  uint64_t hash = 0xcbf29ce484222325U;
  for (; *text != '\0'; ++text) {
    hash = (hash ^ static_cast<uint8_t>(*text)) * 0x100000001b3U;
  }
  return hash;
}

void putNotes(const GliderContext* context) {
  put(context->note_count);
  for (uint32_t i = 0; i < context->note_count; ++i) {
    const GliderNote* note = &context->notes[i];
    put(note->kind);
    put(digest(note->text));
    put(note->count);
    for (uint32_t k = 0; k < note->count; ++k) {
      putNumber(context->note_values[note->first + k]);
    }
  }
  put(context->lost_notes);
}

/// What the generated code says of the next ticks.
struct Told {
  double seconds;
  uint32_t awake;
  uint32_t count;
  uint64_t words[3 * 256];
} told;

void tell(uint64_t kind, uint32_t sensor, double number) {
  if (3 * told.count == sizeof told.words / sizeof told.words[0]) {
    giveUp("too much can be foreseen");
  }
  uint64_t* row = &told.words[3 * told.count++];
  row[0] = kind;
  row[1] = sensor;
  memcpy(&row[2], &number, sizeof number);
}

void putForeseen(GliderContext* context) {
  GliderForesee* foresee = context->mission->states[context->state]->foresee;
  if (context->mission->naps == nullptr || context->finished != 0) {
    return;
  }
  told.seconds = 1e300;
  told.awake = foresee == nullptr ? 1 : 0;
  told.count = 0;
  if (foresee != nullptr) {
    foresee(context, nullptr);
  }
  put(told.awake);
  if (told.awake == 0) {
    putNumber(told.seconds);
    for (uint32_t i = 0; i < 3 * told.count; ++i) {
      put(told.words[i]);
    }
  }
}

void writeTick(GliderContext* context) {
  put(context->state);
  put(context->finished);
  put(context->limit);
  put(context->just_returned);
  put(context->fired_always);
  put(context->fired_state);
  put(context->fired_profile);
  put(context->fired_route);
  put(context->moved_list);
  put(context->moved_case);
  put(context->stack_depth);
  for (uint32_t i = 0; i < context->stack_depth; ++i) {
    put(context->frames[i].state);
    putNumber(context->frames[i].entered);
    put(context->frames[i].limit);
  }
  for (uint32_t i = 0; i < context->mission->variable_count; ++i) {
    putNumber(context->variables[i]);
  }
  putNumber(context->sampling);
  putNotes(context);
  GliderCondition* condition = context->mission->condition;
  put(condition != NULL ? condition(context) : GLIDER_NO_CASE);
  const GliderStateInfo* state = context->mission->states[context->state];
  for (uint32_t i = 0; i < state->log_count; ++i) {
    putNumber(gliderLogValue(context, i));
  }
  putForeseen(context);
  const uint64_t count = word_count;
  if (fwrite(&count, sizeof count, 1, records) != 1 ||
      fwrite(words, sizeof words[0], word_count, records) != word_count) {
    giveUp("the records cannot be written");
  }
  word_count = 0;
}

double nextNumber(void) {
  const uint64_t bits = next();
  double number;
  memcpy(&number, &bits, sizeof number);
  return number;
}

double readTick(GliderUpdate* updates, uint32_t* count) {
  const double time = nextNumber();
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
  const GliderContextLayout layout = gliderContextLayout(mission);
  if (layout.bytes != mission->context_bytes || layout.bytes > sizeof context_memory) {
    giveUp("generated code and the runtime differ on the size of the context");
  }
  double parameters[kMostParameters];
  const uint64_t parameter_count = next();
  if (parameter_count != mission->parameter_count || parameter_count > kMostParameters) {
    giveUp("another number of parameters");
  }
  for (uint64_t i = 0; i < parameter_count; ++i) {
    parameters[i] = nextNumber();
  }
  externals = {};
  const uint64_t ticks = next();
  readTick(updates, &count);
  GliderContext* context = gliderStart(context_memory, mission, parameters, updates, count);
  writeTick(context);
  for (uint64_t i = 1; i < ticks; ++i) {
    const double time = readTick(updates, &count);
    gliderStep(context, time, updates, count);
    writeTick(context);
  }
}

}  // namespace

extern "C" void gliderProfileRecord(GliderContext* context, GliderBehaviourMemory* memory,
                                    uint32_t phase, double number, double length, double time,
                                    double temperature) {
  putAction(kGliderListProfile, phase);
  put(static_cast<uint64_t>(memory - context->memory));
  putNumber(number);
  putNumber(length);
  putNumber(time);
  putNumber(temperature);
}

extern "C" void gliderRouteRecord(GliderContext* context, GliderBehaviourMemory* memory,
                                  uint32_t phase, double number, double latitude,
                                  double longitude) {
  putAction(kGliderListRoute, phase);
  put(static_cast<uint64_t>(memory - context->memory));
  putNumber(number);
  putNumber(latitude);
  putNumber(longitude);
}

extern "C" double gliderTestLevel(void) {
  externalAsked(&externals, 1, 0);
  return externalAnswer(&externals);
}
extern "C" double gliderTestMixed(double a, double b, double c) {
  return externalOf(2, {a, b, c});
}
extern "C" double gliderTestMet(double a, double b, double c, double d, double e, double f,
                                double g, double h) {
  return externalOf(3, {a, b, c, d, e, f, g, h});
}
extern "C" double gliderTestPing(double mission_time) {
  externalAsked(&externals, 4, mission_time);
  return externalAnswer(&externals);
}

// In place of runtime/naps: what its functions are called with, in order.
extern "C" void gliderNapAfterTick(void*, const void*) {}
extern "C" void gliderNapAwake(GliderNap*) {
  told.awake = 1;
}
extern "C" void gliderNapUntil(GliderNap*, double seconds) {
  told.seconds = seconds >= 0 && seconds < told.seconds ? seconds : told.seconds;
}
extern "C" void gliderNapCrossed(GliderNap*, const GliderContext*, uint32_t sensor, double number) {
  if (number == number) {
    tell(0, sensor, number);
  }
}
extern "C" void gliderNapKnown(GliderNap*, const GliderContext*, uint32_t sensor) {
  tell(1, sensor, 0);
}
extern "C" void gliderNapLost(GliderNap*, const GliderContext*, uint32_t sensor) {
  tell(2, sensor, 0);
}

// The commands, in the order of ir/core/commands.def.
extern "C" void gliderDescend(GliderContext*, double depth, double pitch) {
  const double arguments[] = {depth, pitch};
  putCommand(0, 2, arguments);
}
extern "C" void gliderAscend(GliderContext*, double depth, double pitch) {
  const double arguments[] = {depth, pitch};
  putCommand(1, 2, arguments);
}
extern "C" void gliderHover(GliderContext*, double depth) {
  putCommand(2, 1, &depth);
}
extern "C" void gliderSurface(GliderContext*) {
  putCommand(3, 0, nullptr);
}
extern "C" void gliderSteer(GliderContext*, double heading) {
  putCommand(4, 1, &heading);
}
extern "C" void gliderSteerTo(GliderContext*, double latitude, double longitude) {
  const double arguments[] = {latitude, longitude};
  putCommand(5, 2, arguments);
}
extern "C" void gliderDriftFree(GliderContext*) {
  putCommand(6, 0, nullptr);
}
extern "C" void gliderFin(GliderContext*, double angle) {
  putCommand(7, 1, &angle);
}

extern "C" void gliderPump(GliderContext*, double volume) {
  putCommand(8, 1, &volume);
}
extern "C" void gliderBattery(GliderContext*, double position) {
  putCommand(9, 1, &position);
}
extern "C" void gliderDescendAt(GliderContext*, double depth, double speed) {
  const double arguments[] = {depth, speed};
  putCommand(10, 2, arguments);
}
extern "C" void gliderAscendAt(GliderContext*, double depth, double speed) {
  const double arguments[] = {depth, speed};
  putCommand(11, 2, arguments);
}

int main(int argc, char** argv) {
  glider::runtime::useDoublePrecision();
  if (argc != 3 || (streams = fopen(argv[1], "rb")) == nullptr ||
      (records = fopen(argv[2], "wb")) == nullptr) {
    giveUp("usage: judged_main STREAMS RECORDS");
  }
  for (uint32_t i = 0; i < judgedMissionCount; ++i) {
    fly(judgedMissions[i]);
  }
  if (fclose(records) != 0) {
    giveUp("the records cannot be written");
  }
  return 0;
}
