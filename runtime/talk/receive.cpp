// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How what was received of others gets into a tick: with the vehicle's next frame, as one of its
// sensors. A tick then depends on its frame alone, as without a modem.

#include "hooks/protocol/tick.h"
#include "runtime/abi/runtime.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime::talk {
namespace {

bool isReceived(const GliderSensorInfo& sensor) {
  return sensor.id >= GLIDER_FIRST_HEARD_SENSOR && sensor.id < GLIDER_FIRST_OWN_SENSOR;
}

/// Adds what is waiting to the updates of a frame; what has no room waits for the next. Returns the
/// number of updates.
uint32_t withReceived(const GliderMission& mission, GliderContext& context, GliderUpdate* updates,
                      uint32_t count) {
  for (uint32_t i = 0; i < mission.sensor_count && count < hooks::kMostSubscriptions; ++i) {
    GliderReading& reading = context.readings[i];
    if (reading.waiting != 0 && isReceived(mission.sensors[i])) {
      updates[count++] = {reading.raw, mission.sensors[i].id, 0};
      reading.waiting = 0;
    }
  }
  return count;
}

}  // namespace
}  // namespace glider::runtime::talk

extern "C" uint32_t gliderHear(const GliderMission* mission, GliderContext* context,
                               double* /*variation*/, GliderUpdate* updates, uint32_t count) {
  return updates == nullptr || context == nullptr
             ? count
             : glider::runtime::talk::withReceived(*mission, *context, updates, count);
}

extern "C" uint32_t gliderHearAndConvertHeadings(const GliderMission* mission,
                                                 GliderContext* context, double* variation,
                                                 GliderUpdate* updates, uint32_t count) {
  return gliderConvertHeadings(mission, context, variation, updates,
                               gliderHear(mission, context, variation, updates, count));
}

extern "C" double gliderNothingHeard(double /*mission_time*/) {
  return glider::runtime::unknown();
}
