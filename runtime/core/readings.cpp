// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/readings.h"

#include "runtime/abi/behaviour.h"
#include "runtime/numbers/numbers.h"

#include <math.h>

namespace glider::runtime {
namespace {

/// ddmm.mmmm to degrees, the sign kept; unknown from 60 minutes on.
double degreesOf(double raw) {
  const double size = magnitude(raw);
  const double minutes = fmod(size, 100.0);         // exact on every board
  const double degrees = (size - minutes) / 100.0;  // exact: a multiple of 100
  if (!(minutes < 60.0)) {
    return unknown();
  }
  return gliderSettle(doubleOf(bitsOf(degrees + minutes / 60.0) | (bitsOf(raw) & kSignBit)));
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

double readingOf(const GliderSensorInfo& sensor, double raw, double age) {
  const bool plausible = isFinite(raw) && raw >= sensor.lowest && raw <= sensor.highest;
  if (!plausible || age > sensor.stale_after) {
    return unknown();
  }
  return sensor.encoding == kGliderDegreesMinutes ? degreesOf(raw)
                                                  : gliderSettle(raw * sensor.to_si);
}

void takeUpdates(GliderContext& context, const GliderUpdate* updates, uint32_t count) {
  for (uint32_t u = 0; u < count; ++u) {
    // Not only the first: a mission may know one sensor by two names.
    for (uint32_t i = 0; i < context.mission->sensor_count; ++i) {
      if (context.mission->sensors[i].id == updates[u].id) {
        context.readings[i].raw = updates[u].value;
        context.readings[i].updated = context.mission_time;
        context.readings[i].seen = 1;
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
    const double age = gliderSettle(context.mission_time - reading.updated);
    reading.value =
        reading.seen != 0 ? readingOf(context.mission->sensors[i], reading.raw, age) : unknown();
  }
}

}  // namespace glider::runtime

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
