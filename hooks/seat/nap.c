// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/nap.h"

enum {
  kCycleSecs = 4,  // of the vehicle
  /// Ticks for which room is left beyond those that come while the SBC wakes: until it has read
  /// what was kept, or is lost.
  kSpareTicks = 4,
  /// s; a few cycles that the science computer has missed. The SBC's clock goes by the vehicle's
  /// time while it sleeps, and must not go by a false one.
  kJumpSecs = 20,
  /// s; the vehicle's time may not advance, or its cycles may end: the nap then ends so long after
  /// its length by the clock of this computer.
  kLateSecs = 12
};

void hookNapsReset(HookNaps* naps) {
  naps->ordered = naps->asleep = naps->waking = naps->beats = false;
  hookTickRingClear(&naps->ring);
}

void hookNapsBegin(HookNaps* naps, uint32_t session, double now_s) {
  naps->session = session;
  naps->asleep = naps->beats = true;
  naps->odd = !naps->odd;
  naps->newest_s = naps->start.vehicle_time_s;
  for (uint32_t i = 0; i < kHookMostNapConditions; ++i) {
    naps->heard_s[i] = naps->start.vehicle_time_s;
  }
  hookSinceBegin(&naps->lasts, now_s);
}

bool hookNapsAllow(const HookNap* nap, double most_s) {
  return (double)nap->length_s + (double)nap->wake_s <= most_s;
}

bool hookNapsKeep(const HookNaps* naps) {
  return naps->asleep || naps->waking || naps->ring.count > 0;
}

/// Whether a report of the sensor in row `index` says anything about a condition. What the SBC
/// holds already was there when it ordered the nap: it ends it only where any report does.
static bool countsFor(const HookNapCondition* condition, const HookReporter* reporter,
                      uint32_t index) {
  const HookReadingReport told = reporter->readings.told[index];
  const bool any = condition->kind == kHookNapKindKnown || condition->kind == kHookNapKindQuiet;
  return condition->id == reporter->subscription.sensors[index].id &&
         (told == kHookReadingReportValue || (told == kHookReadingReportUnchanged && any));
}

static bool holds(HookNaps* naps, uint32_t number, const HookTickHead* head,
                  const HookReporter* reporter) {
  const HookNapCondition* condition = &naps->nap.conditions[number];
  for (uint32_t i = 0; i < reporter->subscription.count; ++i) {
    if (countsFor(condition, reporter, i)) {
      const uint32_t width = hookSensorWidth(reporter->dictionary, condition->id);
      naps->heard_s[number] = head->vehicle_time_s;
      return hookNapConditionHolds(condition, hookFromWire(width, reporter->rows[i].bits));
    }
  }
  return condition->kind == kHookNapKindQuiet &&
         head->vehicle_time_s - naps->heard_s[number] >= condition->value;
}

/// Each is looked at in each Tick: those that wait for silence note each report.
static bool aConditionHolds(HookNaps* naps, const HookTickHead* head,
                            const HookReporter* reporter) {
  bool any = false;
  for (uint32_t i = 0; i < naps->nap.count; ++i) {
    any = holds(naps, i, head, reporter) || any;
  }
  return any;
}

/// Its length is over, or the vehicle's time jumps.
static bool isOver(HookNaps* naps, const HookTickHead* head) {
  const double since_s = head->vehicle_time_s - naps->start.vehicle_time_s;
  const double step_s = head->vehicle_time_s - naps->newest_s;
  naps->newest_s = head->vehicle_time_s;
  return !(since_s < (double)naps->nap.length_s) || !(step_s >= 0 && step_s <= (double)kJumpSecs);
}

static bool isOtherwise(const HookTickHead* start, const HookTickHead* head) {
  return head->hook_state != start->hook_state || head->answer != start->answer ||
         head->answered_sequence != start->answered_sequence || head->session != start->session;
}

static bool isFull(const HookNaps* naps, const HookReporter* reporter) {
  const uint32_t while_waking = ((uint32_t)naps->nap.wake_s + kCycleSecs - 1) / kCycleSecs;
  const uint32_t greatest = hookGreatestTick(reporter->dictionary, &reporter->subscription);
  return !hookTickRingHasRoom(&naps->ring, kSpareTicks + while_waking, greatest);
}

HookNapEnd hookNapsEndBy(HookNaps* naps, const HookTickHead* head, const HookReporter* reporter,
                         double most_s) {
  const bool over = isOver(naps, head);  // of each Tick
  return aConditionHolds(naps, head, reporter) ? kHookNapEndCondition
         : over                                ? kHookNapEndLength
         : isOtherwise(&naps->start, head)     ? kHookNapEndVehicle
         : !hookNapsAllow(&naps->nap, most_s)  ? kHookNapEndForbidden
         : isFull(naps, reporter)              ? kHookNapEndFull
                                               : kHookNapEndNone;
}

bool hookNapsAreOver(HookNaps* naps, double now_s) {
  return naps->asleep &&
         hookSinceLasts(&naps->lasts, now_s) >= (double)naps->nap.length_s + (double)kLateSecs;
}

void hookNapsWake(HookNaps* naps, double now_s) {
  naps->asleep = false;
  naps->waking = true;
  hookSinceBegin(&naps->lasts, now_s);
}

bool hookNapsMaySend(HookNaps* naps, double now_s) {
  if (naps->waking && hookSinceLasts(&naps->lasts, now_s) >= (double)naps->nap.wake_s) {
    naps->waking = false;
  }
  return !naps->asleep && !naps->waking && naps->ring.count > 0;
}
