// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/behaviour.h"
#include "runtime/board/files.h"
#include "runtime/board/line.h"
#include "runtime/c/glider.h"
#include "runtime/c/program.h"

using glider::runtime::Check;
using glider::runtime::Program;

namespace {

constexpr uint32_t kMostLists = 16;
constexpr double kHalfTurn = 3.141592653589793;  // rad
constexpr uint32_t kMostEvents = 16;

bool fires(const gliderEvent& tested) {
  if (tested.op == CUSTOM) {
    return tested.test(tested.data) != 0;
  }
  const double value = gliderSensor(tested.sensor);
  switch (tested.op) {  // every comparison with an unknown reading, NaN, is false
    case LEQ:
      return value <= *tested.limit;
    case LESS:
      return value < *tested.limit;
    case GEQ:
      return value >= *tested.limit;
    case GREATER:
    case CUSTOM:
      break;
  }
  return value > *tested.limit;
}

/// False if the test or the limit is a null pointer.
bool canBeAsked(const gliderEvent& added) {
  return added.op == CUSTOM ? added.test != nullptr : added.limit != nullptr;
}

bool subscribe(const gliderEvent& added) {
  if (added.op == CUSTOM && added.test == thermoMet) {
    return Program::instance().use(GLIDER_M_DEPTH) &&
           Program::instance().use(GLIDER_SCI_WATER_TEMP);
  }
  return added.sensor == MISSION_TIME || Program::instance().use(added.sensor);
}

/// Why no more ticks come, unless the program released control.
void tellEnd(const Program& program) {
  if (program.failedCheck() != 0) {
    (void)glider::runtime::tellFailedCheck();
  } else if (!program.released()) {
    glider::runtime::tell("error: the line to the vehicle is closed");
  }
}

}  // namespace

/// Keeps copies of the events: an event that EVENT makes ends with the block it was written in. The
/// address of the original still identifies the event.
struct gliderEventList {
  event events[kMostEvents];
  gliderEvent tested[kMostEvents];
  uint32_t count;
};

extern "C" eventList newEventList(void) {
  static gliderEventList lists[kMostLists];
  static uint32_t used = 0;
  return used < kMostLists ? &lists[used++] : nullptr;
}

extern "C" int addEvent(eventList list, event added) {
  if (list == nullptr || added == nullptr || list->count == kMostEvents || !canBeAsked(*added) ||
      !subscribe(*added)) {
    return -1;
  }
  list->tested[list->count] = *added;
  list->events[list->count++] = added;
  return 0;
}

extern "C" int useSensor(uint32_t sensor) {
  return Program::instance().use(sensor) ? 0 : -1;
}

extern "C" eventList gliderRun(eventList list) {
  static gliderEventList fired;
  Program& program = Program::instance();
  fired.count = 0;
  while (fired.count == 0) {
    (void)program.require(list == nullptr || list->count <= kMostEvents, Check::EventCount);
    if (!program.nextTick()) {
      tellEnd(program);
      return nullptr;
    }
    if (program.takeResume()) {
      break;
    }
    for (uint32_t i = 0; list != nullptr && i < list->count; ++i) {
      if (fires(list->tested[i])) {
        fired.events[fired.count++] = list->events[i];
      }
    }
  }
  return &fired;
}

extern "C" event nextEvent(eventList fired, event previous) {
  if (fired == nullptr) {
    return nullptr;
  }
  uint32_t next = 0;
  for (uint32_t i = 0; previous != nullptr && i < fired->count; ++i) {
    if (fired->events[i] == previous) {
      next = i + 1;
    }
  }
  return next < fired->count ? fired->events[next] : nullptr;
}

extern "C" double gliderSensor(uint32_t sensor) {
  const GliderContext& context = Program::instance().context();
  return sensor == MISSION_TIME ? gliderMissionTime(&context) : gliderRead(&context, sensor);
}

extern "C" int keepState(void* state, size_t bytes) {
  Program& program = Program::instance();
  const bool early = !program.isAttached();
  const auto count = static_cast<uint32_t>(bytes < UINT32_MAX ? bytes : UINT32_MAX);
  return early && program.kept().add(state, count) ? 0 : -1;
}

extern "C" int setDeclination(double east) {
  if (!(east >= -kHalfTurn && east <= kHalfTurn)) {
    return -1;
  }
  Program::instance().declination(east);
  return 0;
}

extern "C" void resumeWithin(double seconds) {
  Program::instance().resumeWithin(seconds);
}

extern "C" void newAfterRestart(void) {
  Program::instance().newAfterRestart();
}

extern "C" int gliderResumed(void) {
  return Program::instance().resumed() ? 1 : 0;
}

extern "C" void gliderLog(const char* text, const double* values, int count) {
  if (text != nullptr) {
    const bool some = values != nullptr && count > 0;
    Program::instance().note(text, values, some ? static_cast<uint32_t>(count) : 0U);
  }
}

extern "C" void releaseControl(void) {
  Program::instance().releaseControl();
}

extern "C" int gliderExitStatus(void) {
  const Program& program = Program::instance();
  return program.failedCheck() != 0 ? glider::runtime::kCheckFailed : program.released() ? 0 : 2;
}
