// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/crc.h"
#include "hooks/protocol/nap_times.h"
#include "runtime/core/nap_tick.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

/// s: how long before a time at which something follows from time alone the SBC is woken, so that
/// it has read its line by then.
constexpr double kAhead_s = kHookMostWakeSecs + kHookReplaySecs + 4;
/// s. A shorter sleep saves little: the board needs time to wake.
constexpr uint32_t kShortest_s = 20;
/// s: more than any mission's line.
constexpr double kEndless_s = 1e9;
/// s: cycles that may be kept beyond the time to wake.
constexpr double kWhileWaking_s = 12;
/// s: what a difference of mission times may be rounded by.
constexpr double kRounded_s = 1e-3;
/// rad: a hundredth of the least step of a commanded heading.
constexpr double kSameVariation = 1e-7;

void addWake(GliderNap& nap, uint32_t sensor, hooks::NapKind kind, double value) {
  if (nap.count == GLIDER_MOST_WAKES) {
    nap.awake = 1;
    return;
  }
  nap.wakes[nap.count++] = {value, sensor, static_cast<uint32_t>(kind)};
}

/// A heading is commanded from magnetic north: it changes with the variation that the vehicle
/// reports.
void watchVariation(GliderNap& nap, const GliderContext& context) {
  const GliderCompass* compass = context.mission->compass;
  if (compass == nullptr || compass->variation == GLIDER_NO_SENSOR ||
      context.lateral != kGliderHeading) {
    return;
  }
  addWake(nap, compass->variation, hooks::NapKind::AtLeast, context.variation + kSameVariation);
  addWake(nap, compass->variation, hooks::NapKind::AtMost, context.variation - kSameVariation);
}

/// What can make the next ticks do anything else than this one; false: it is not known.
bool foresee(GliderContext& context, GliderNap& found) {
  const GliderStateInfo& state = *context.mission->states[context.state];
  if (state.foresee == nullptr) {
    return false;
  }
  state.foresee(&context, &found);
  watchVariation(found, context);
  return found.awake == 0;
}

/// Sends it, unless it is too short.
void sleep(const NapTick& now, const GliderNap& found, NapMemory& memory) {
  hooks::Nap nap;
  nap.wake_s = static_cast<uint8_t>(now.context.mission->naps->wake);
  const uint32_t around = kHookAroundNapSecs;
  const uint32_t allowed = memory.limit_s > around ? memory.limit_s - around : 0;
  // Rounded down, except for the whole time of the mission's line.
  const double longest = now.context.mission->naps->longest;
  const double foreseen = found.seconds - kAhead_s - kRounded_s;
  const double seconds = foreseen < longest ? foreseen : longest;
  const auto wanted = static_cast<uint32_t>(seconds > 0 ? seconds : 0);
  nap.length_s = static_cast<uint16_t>(wanted < allowed ? wanted : allowed);
  if (nap.length_s < kShortest_s) {
    return;
  }
  nap.count = static_cast<uint8_t>(found.count);
  for (uint32_t i = 0; i < found.count; ++i) {
    const GliderWake& wake = found.wakes[i];
    nap.conditions[i].id = static_cast<uint16_t>(wake.sensor);
    nap.conditions[i].kind = static_cast<hooks::NapKind>(wake.kind);
    nap.conditions[i].value = wake.value;
  }
  memory.asleep = now.client.nap(nap);
  if (memory.asleep) {
    now.log.sleeps(now.context, nap.length_s);
  }
}

void takeLimit(const NapTick& now, NapMemory& memory) {
  for (uint32_t i = 0; i < now.tick.reading_count; ++i) {
    if (now.tick.readings[i].id == napLimitSensor(*now.context.mission)) {
      const double limit = now.tick.readings[i].value;
      memory.limit_s = limit >= 1 && limit <= UINT16_MAX ? static_cast<uint32_t>(limit) : 0;
    }
  }
}

/// Whether the tick left all variables that decide anything as they were, and the one before made
/// no transition: then the next does what this one did, in the same order of its lists.
bool isAsBefore(const NapTick& now, NapMemory& memory) {
  const auto* bytes = reinterpret_cast<const uint8_t*>(now.context.variables);
  const uint32_t count = now.context.mission->naps->variables;
  const uint32_t check = hooks::crc32c(bytes, count * sizeof(double), count);
  const bool same = check == memory.variables && !memory.moved;
  memory.variables = check;
  memory.moved = now.context.moved_list != GLIDER_NO_LIST;
  return same;
}

/// Of the ticks that the vehicle had kept, only those from the one that woke the SBC on may lead to
/// a command: before, it has slept too long.
void noticeLateness(const NapTick& now, NapMemory& memory) {
  if (now.tick.kept && now.commands && !memory.late) {
    memory.late = true;
    memory.late_from_s = now.context.mission_time;
  }
  if (!now.tick.kept && memory.late) {
    const double late_s = now.context.mission_time - memory.late_from_s;
    if (late_s > now.context.mission->naps->wake + kWhileWaking_s) {
      now.log.wokenLate(now.context, late_s);
    }
    memory.late = false;
  }
}

/// Whether anything but what the mission does speaks against a sleep.
bool maySleep(const NapTick& now) {
  return now.settled && !now.commands && !now.tick.kept && now.client.mayNap() &&
         now.context.finished == 0 && now.context.moved_list == GLIDER_NO_LIST &&
         now.context.note_count == 0;
}

}  // namespace
}  // namespace glider::runtime

extern "C" void gliderNapAfterTick(void* memory, const void* tick) {
  using namespace glider::runtime;
  auto& kept = *static_cast<NapMemory*>(memory);
  const auto& now = *static_cast<const NapTick*>(tick);
  kept.asleep = false;
  takeLimit(now, kept);
  noticeLateness(now, kept);
  GliderWake wakes[GLIDER_MOST_WAKES];
  GliderNap found = {kEndless_s, wakes, 0, 0};
  const bool as_before = isAsBefore(now, kept);
  if (as_before && maySleep(now) && foresee(now.context, found)) {
    sleep(now, found, kept);
  }
}
