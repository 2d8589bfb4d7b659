// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The one place where headings change from the vehicle's magnetic north to the mission's true north
// and back. magnetic = true + variation, with the sign that real vehicles use: +16.3 degrees off
// New England, where the needle points west.

#include "hooks/protocol/notices.h"
#include "hooks/protocol/tick.h"
#include "runtime/abi/runtime.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

constexpr double kHalfTurn = 3.141592653589793;

/// The variation assumed until the vehicle has reported one.
double assumed(const GliderCompass& compass) {
  return isKnown(compass.declination) ? negated(compass.declination) : 0.0;
}

/// `heading` + `by`, both within a full turn, in [0, 2 pi).
double turned(double heading, double by) {
  double sum = heading + by;
  if (sum < 0.0) {
    sum += kTwoPi;
  } else if (sum >= kTwoPi) {
    sum -= kTwoPi;
  }
  return sum < kTwoPi ? sum : 0.0;  // a value just below 0 is rounded up to a full turn
}

/// True if `id` is a sensor of the mission for a heading that the vehicle gives from magnetic
/// north.
bool isMagnetic(const GliderMission& mission, uint32_t id) {
  for (uint32_t i = 0; i < mission.sensor_count; ++i) {
    if (mission.sensors[i].id == id) {
      return mission.sensors[i].encoding == kGliderMagnetic;
    }
  }
  return false;
}

/// Takes in the updates of a frame, before its tick.
void take(const GliderMission& mission, double& variation, GliderUpdate* updates, uint32_t count) {
  const GliderCompass& compass = *mission.compass;
  for (uint32_t i = 0; i < count; ++i) {
    if (updates[i].id != compass.variation) {
      continue;
    }
    // A comparison with NaN is false: an invalid value leaves the last one unchanged, also for what
    // the mission reads, so that `90 deg magnetic` is converted back as it was converted.
    if (magnitude(updates[i].value) <= kHalfTurn) {
      variation = updates[i].value;
    } else {
      updates[i].value = variation;
    }
  }
  const double by = negated(isKnown(variation) ? variation : assumed(compass));
  for (uint32_t i = 0; i < count; ++i) {
    const double heading = updates[i].value;
    // A value outside the range of a compass is left unchanged, and is found implausible later.
    if (heading >= 0.0 && heading <= kTwoPi && isMagnetic(mission, updates[i].id)) {
      updates[i].value = turned(heading, by);
    }
  }
}

/// Adds a variation that was reported before the mission began to the frame that begins it. Returns
/// the number of updates.
uint32_t withVariation(const GliderMission& mission, double variation, GliderUpdate* updates,
                       uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    if (updates[i].id == mission.compass->variation) {
      return count;
    }
  }
  if (!isKnown(variation) || count >= hooks::kMostSubscriptions) {
    return count;
  }
  updates[count] = {variation, mission.compass->variation, 0};
  return count + 1;
}

/// Converts the heading that a tick commands, after that tick.
void follow(GliderContext& context, double& variation) {
  const GliderCompass& compass = *context.mission->compass;
  if (!isKnown(variation)) {
    variation = assumed(compass);
    if (!isKnown(compass.declination)) {
      gliderNote(&context, kGliderNoteLog, hooks::kNoteDeclinationUnknown, nullptr, 0);
    }
  }
  context.variation = variation;
  if (context.lateral == kGliderHeading) {
    context.magnetic = turned(context.heading, variation);
  }
}

}  // namespace
}  // namespace glider::runtime

extern "C" uint32_t gliderConvertHeadings(const GliderMission* mission, GliderContext* context,
                                          double* variation, GliderUpdate* updates,
                                          uint32_t count) {
  if (!glider::runtime::isKnown(*variation) && context != nullptr && updates != nullptr) {
    *variation = context->variation;  // from a checkpoint: the last known variation
  }
  if (updates == nullptr) {
    glider::runtime::follow(*context, *variation);
    return count;
  }
  glider::runtime::take(*mission, *variation, updates, count);
  return context != nullptr ? count
                            : glider::runtime::withVariation(*mission, *variation, updates, count);
}
