// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/reporter.h"

#include "hooks/protocol/c_library.h"
#include "hooks/protocol/numbers.h"

void hookReporterInit(HookReporter* reporter, const GliderDictionary* dictionary) {
  memset(reporter, 0, sizeof *reporter);
  reporter->dictionary = dictionary;
  reporter->check = hookSubscriptionCheck(&reporter->subscription);
}

void hookReporterServe(HookReporter* reporter, const HookSubscribe* subscribe) {
  reporter->subscription = *subscribe;
  reporter->check = hookSubscriptionCheck(subscribe);
  memset(reporter->rows, 0, sizeof reporter->rows);
  reporter->remembered = 0;
}

void hookReporterBegin(HookReporter* reporter) {
  for (uint32_t i = 0; i < reporter->subscription.count; ++i) {
    HookReported* row = &reporter->rows[i];
    reporter->readings.told[i] = kHookReadingReportNothing;
    row->rest = row->rest > 0 ? (uint8_t)(row->rest - 1) : 0;
    row->brought_in = (uint8_t)(row->brought_in << 1U);
    row->told_in = (uint8_t)(row->told_in << 1U);
    row->age = row->age < kHookRefreshTicks ? (uint8_t)(row->age + 1) : row->age;
  }
}

static uint32_t widthOf(const HookReporter* reporter, uint32_t index) {
  return hookSensorWidth(reporter->dictionary, reporter->subscription.sensors[index].id);
}

/// Whether the SBC holds `bits`, or a value within the dead band, when it has read what is kept.
static bool isHeld(const HookReporter* reporter, uint32_t index, uint64_t bits) {
  const HookReported* row = &reporter->rows[index];
  const bool has_one = row->held || row->kept;
  if (!has_one || row->bits == bits) {
    return has_one;
  }
  const HookSubscription* wanted = &reporter->subscription.sensors[index];
  const uint32_t width = widthOf(reporter, index);
  const double change = hookFromWire(width, bits) - hookFromWire(width, row->bits);
  // NaN and the infinities are held only if identical: no dead band covers a change from or to
  // them.
  return wanted->dead_band > 0 && hookMagnitude(change) <= (double)wanted->dead_band;
}

/// The value that the SBC holds, or will hold if no kept Tick is lost: then it is sent once more.
static void tellHeld(HookReporter* reporter, uint32_t index) {
  HookReported* row = &reporter->rows[index];
  if (row->held) {
    reporter->readings.told[index] = kHookReadingReportUnchanged;
    return;
  }
  reporter->readings.told[index] = kHookReadingReportValue;
  reporter->readings.values[index] = hookFromWire(widthOf(reporter, index), row->bits);
  row->brought_in = (uint8_t)(row->brought_in | 1U);
}

void hookReporterReport(HookReporter* reporter, uint32_t index, double value) {
  HookReported* row = &reporter->rows[index];
  if (row->rest > 0) {
    return;
  }
  row->told_in = (uint8_t)(row->told_in | 1U);
  const uint64_t bits = hookToWire(widthOf(reporter, index), value);
  if (row->age < kHookRefreshTicks && isHeld(reporter, index, bits)) {
    tellHeld(reporter, index);
    return;
  }
  reporter->readings.told[index] = kHookReadingReportValue;
  reporter->readings.values[index] = value;
  if (row->bits != bits) {
    row->brought_in = 0;
  }
  row->brought_in = (uint8_t)(row->brought_in | 1U);
  row->bits = bits;
  row->held = false;
  row->kept = false;
  row->age = 0;
}

void hookReporterSent(HookReporter* reporter, uint8_t sequence) {
  for (uint32_t i = kHookRememberedTicks - 1; i > 0; --i) {
    reporter->sequences[i] = reporter->sequences[i - 1];
  }
  reporter->sequences[0] = sequence;
  if (reporter->remembered < kHookRememberedTicks) {
    ++reporter->remembered;
  }
}

void hookReporterKept(HookReporter* reporter, uint8_t sequence) {
  hookReporterSent(reporter, sequence);
  for (uint32_t i = 0; i < reporter->subscription.count; ++i) {
    HookReported* row = &reporter->rows[i];
    row->kept = row->kept || reporter->readings.told[i] == kHookReadingReportValue;
    if (reporter->readings.told[i] != kHookReadingReportNothing) {
      row->rest = reporter->subscription.sensors[i].every;
    }
  }
}

static void confirm(HookReporter* reporter, uint32_t ticks_ago) {
  for (uint32_t i = 0; i < reporter->subscription.count; ++i) {
    HookReported* row = &reporter->rows[i];
    const uint32_t brought = (uint32_t)row->brought_in >> ticks_ago;
    const uint32_t told = (uint32_t)row->told_in >> ticks_ago;
    row->held = row->held || (brought & 1U) != 0;
    const uint32_t every = reporter->subscription.sensors[i].every;
    if ((told & 1U) != 0 && every > row->rest + ticks_ago) {
      row->rest = (uint8_t)(every - ticks_ago);
    }
  }
}

void hookReporterAnswered(HookReporter* reporter, uint8_t sequence) {
  for (uint32_t ago = 0; ago < reporter->remembered; ++ago) {
    if (reporter->sequences[ago] == sequence) {
      confirm(reporter, ago);
      return;
    }
  }
}
