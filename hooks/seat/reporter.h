// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_SEAT_REPORTER_H
#define GLIDER_HOOKS_SEAT_REPORTER_H

#include "hooks/protocol/tick.h"

GLIDER_HOOKS_BEGIN

enum {
  /// A value that was sent this many Ticks ago is sent again with the next report, so that the
  /// effect of a damaged frame that passed its CRC does not last.
  kHookRefreshTicks = 16,
  kHookRememberedTicks = 8  ///< whose answer may still arrive
};

/// What the SBC knows of a subscribed sensor.
typedef struct HookReported {
  uint64_t bits;       ///< of the newest value sent, as on the line
  bool held;           ///< and the SBC has it
  bool kept;           ///< and it is in a Tick that is kept, which the SBC will have
  uint8_t rest;        ///< Ticks until it may be reported again
  uint8_t age;         ///< Ticks since the value was sent, counted to kHookRefreshTicks
  uint8_t brought_in;  ///< Ticks that carried exactly this value: bit 0 the newest
  uint8_t told_in;     ///< Ticks that reported the sensor at all
} HookReported;

/// Decides what each Tick reports about the subscribed sensors: only what the SBC does not hold
/// already. A value counts as held once a Tick that brought it was answered; until then it is sent
/// with each report, so a lost Tick delays a change only until the next report. A Tick that is kept
/// for a sleeping SBC says what it would say if those before it had been answered in time: rates
/// and dead bands count from them. But their values are sent again, since they may still be lost.
typedef struct HookReporter {
  const GliderDictionary* dictionary;
  HookSubscribe subscription;  ///< that is served
  uint16_t check;              ///< hookSubscriptionCheck of it
  HookReported rows[kHookMostSubscriptions];
  HookTickReadings readings;                ///< the content of the Tick
  uint8_t sequences[kHookRememberedTicks];  ///< of the newest Ticks, the newest first
  uint32_t remembered;
} HookReporter;

/// `dictionary` outlives it. It serves an empty subscription.
void hookReporterInit(HookReporter* reporter, const GliderDictionary* dictionary);
/// From now on `subscribe` is served; the SBC holds nothing.
void hookReporterServe(HookReporter* reporter, const HookSubscribe* subscribe);

/// Begins the next Tick.
void hookReporterBegin(HookReporter* reporter);
/// Subscribed sensor number `index` was reported in this cycle.
void hookReporterReport(HookReporter* reporter, uint32_t index, double value);
/// The Tick, with all that was reported, goes as frame `sequence`.
void hookReporterSent(HookReporter* reporter, uint8_t sequence);
/// The same, but the frame is kept, and will be sent before any that is reported later.
void hookReporterKept(HookReporter* reporter, uint8_t sequence);
/// The SBC has answered frame `sequence`: if that is one of the newest Ticks, the SBC knows its
/// content.
void hookReporterAnswered(HookReporter* reporter, uint8_t sequence);

GLIDER_HOOKS_END

#endif
