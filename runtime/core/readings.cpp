// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/readings.h"

#include "runtime/abi/behaviour.h"
#include "runtime/abi/order.h"
#include "runtime/core/assert.h"
#include "runtime/numbers/degrees.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

/// gliderOrder, except that -0 gives 0.
int64_t orderOf(double value) {
  const int64_t order = gliderOrder(value);
  return order == -1 ? 0 : order;
}

/// value > limit; neither is NaN. Out of line: it is long on a board, and called in three places.
__attribute__((noinline)) bool isPast(double value, double limit) {
  return orderOf(value) > orderOf(limit);
}

/// The raw value in SI units, ddmm.mmmm in degrees; NaN if it is not plausible.
double readingOf(const GliderSensorInfo& sensor, double raw) {
  constexpr uint64_t kOne = 0x3FF0000000000000U;
  if (!isFinite(raw) || isPast(sensor.lowest, raw) || isPast(raw, sensor.highest)) {
    return unknown();
  }
  if (sensor.encoding == kGliderDegreesMinutes) {
    return degreesOfPosition(raw);
  }
  return gliderSettle(bitsOf(sensor.to_si) == kOne ? raw : raw * sensor.to_si);
}

const GliderReading* find(const GliderContext& context, uint32_t id) {
  for (uint32_t i = 0; i < context.mission->sensor_count; ++i) {
    if (context.mission->sensors[i].id == id) {
      return &context.readings[i];
    }
  }
  return nullptr;
}

}  // namespace

void takeUpdates(GliderContext& context, const GliderUpdate* updates, uint32_t count) {
  const GliderMission& mission = *context.mission;
  uint32_t place = 0;  // frames usually hold sensors in the mission's order
  for (uint32_t u = 0; u < count; ++u) {
    for (uint32_t tried = 0; tried < mission.sensor_count; ++tried) {
      const bool found = mission.sensors[place].id == updates[u].id;
      if (found) {
        context.readings[place].raw = updates[u].value;
        context.readings[place].updated = context.mission_time;
        context.readings[place].seen = 1;
      }
      place = place + 1 == mission.sensor_count ? 0 : place + 1;
      if (found) {
        break;
      }
    }
  }
}

void pollSensors(GliderContext& context) {
  for (uint32_t i = 0; i < context.mission->sensor_count; ++i) {
    GliderPoll* poll = context.mission->sensors[i].poll;
    const double raw = poll != nullptr ? poll(context.mission_time) : unknown();
    if (raw == raw) {
      context.readings[i].raw = raw;
      context.readings[i].updated = context.mission_time;
      context.readings[i].seen = 1;
    }
  }
}

void refreshReadings(GliderContext& context) {
  for (uint32_t i = 0; i < context.mission->sensor_count; ++i) {
    GliderReading& reading = context.readings[i];
    if (reading.seen == 0) {
      continue;
    }
    const GliderSensorInfo& sensor = context.mission->sensors[i];
    if (bitsOf(reading.updated) == bitsOf(context.mission_time)) {
      reading.value = readingOf(sensor, reading.raw);
    } else if (isKnown(reading.value) &&
               isPast(gliderSettle(context.mission_time - reading.updated), sensor.stale_after)) {
      reading.value = unknown();
    }
  }
}

double valueOf(const GliderContext& context, uint32_t source, uint32_t sensor) {
  switch (static_cast<GliderSource>(source)) {
    case kGliderSensor:
      return GLIDER_ASSERT(context, sensor < context.mission->sensor_count, ValueSensor)
                 ? context.readings[sensor].value
                 : unknown();
    case kGliderMissionTime:
      return context.mission_time;
    case kGliderStateTime:
      return gliderSettle(context.mission_time - context.entered);
    case kGliderResumeTime:
      break;
  }
  return gliderSettle(context.mission_time - context.resumed);
}

}  // namespace glider::runtime

extern "C" uint32_t gliderSensorOf(const GliderContext* context, GliderRole role) {
  return context->mission->dictionary->roles[role];
}

extern "C" double gliderRead(const GliderContext* context, uint32_t id) {
  const GliderReading* reading = glider::runtime::find(*context, id);
  return reading != nullptr ? reading->value : glider::runtime::unknown();
}

extern "C" double gliderAge(const GliderContext* context, uint32_t id) {
  const GliderReading* reading = glider::runtime::find(*context, id);
  return reading != nullptr && reading->seen != 0
             ? gliderSettle(context->mission_time - reading->updated)
             : glider::runtime::unknown();
}

extern "C" double gliderMissionTime(const GliderContext* context) {
  return context->mission_time;
}

extern "C" double gliderLogValue(const GliderContext* context, uint32_t item) {
  const GliderLogInfo& info = context->mission->states[context->state]->log[item];
  return glider::runtime::valueOf(*context, info.source, info.sensor);
}
