// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/slocum_sensors.h"
#include "runtime/library/library.h"
#include "runtime/library/tracker.h"

namespace glider::runtime {
namespace {

struct Memory {
  ThermoclineTracker tracker;
  Direction direction;
  uint32_t reserved;
};
static_assert(sizeof(Memory) <= GLIDER_BEHAVIOUR_MEMORY_BYTES);

/// A temperature and a depth belong together if one is of this tick and the other no older than
/// this, s.
constexpr double kOldestPartner = 6.0;

/// True if this tick brought a new pair of depth and temperature.
bool freshPair(const GliderContext* context) {
  const double depth_age = gliderAge(context, GLIDER_M_DEPTH);
  const double temperature_age = gliderAge(context, GLIDER_SCI_WATER_TEMP);
  return (depth_age == 0.0 && temperature_age <= kOldestPartner) ||
         (temperature_age == 0.0 && depth_age <= kOldestPartner);
}

void observe(const GliderContext* context, ThermoclineTracker& tracker,
             const ThermoclineWanted& wanted) {
  const double depth = gliderRead(context, GLIDER_M_DEPTH);
  const double temperature = gliderRead(context, GLIDER_SCI_WATER_TEMP);
  const bool both_known = depth == depth && temperature == temperature;
  if (both_known && freshPair(context)) {
    tracker.record(gliderMissionTime(context), depth, temperature, wanted);
  }
}

}  // namespace
}  // namespace glider::runtime

extern "C" void gliderProfileThermotrackyo(GliderContext* context, GliderBehaviourMemory* memory,
                                           uint32_t phase, double top, double bottom, double dive,
                                           double climb, double dtemp, double ddepth) {
  using namespace glider::runtime;
  auto& own = *reinterpret_cast<Memory*>(memory->bytes);
  const double time = gliderMissionTime(context);
  if (phase == kGliderEnter) {
    own.tracker.start(time);
    own.direction = Direction::None;
  }
  const ThermoclineWanted wanted{dtemp, ddepth};
  observe(context, own.tracker, wanted);

  const YoRange range = own.tracker.window({top, bottom, dive, climb}, wanted);
  const Direction next = turn(own.direction, phase, gliderRead(context, GLIDER_M_DEPTH), range);
  if (next != own.direction) {
    own.tracker.beginLeg(time);
    own.direction = next;
  }
  flyLeg(context, next, range);
}
