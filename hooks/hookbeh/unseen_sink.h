// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_UNSEEN_SINK_H
#define GLIDER_HOOKS_HOOKBEH_UNSEEN_SINK_H

#include "hooks/hookbeh/cadence.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/hull.h"
#include "hooks/hookbeh/trend.h"

GLIDER_HOOKS_BEGIN

/// Estimates how deep the vehicle may be, from what it was commanded since its depth last showed
/// that it moves as commanded. Detects a depth that has stopped, flickers about one value, or
/// arrives only now and then: such readings do not count.
typedef struct HookUnseenSink {
  HookHull hull;
  HookCadence cadence;
  HookTrend trend;
  double deepest_m;   ///< the vehicle is at most this deep; NaN before the first depth
  double shown_m;     ///< the depth when it last showed that it moves, or the very first depth
  bool has_moved;     ///< the depth has moved as commanded since hookbeh began
  double in_dive_m;   ///< how far it may have sunk in the current dive, without regard to another
                      ///< sensor: both may be wrong
  double steeply_m;   ///< the same at the steepest possible pitch, because its pitch may be wrong;
                      ///< here another sensor counts
  double highest_m;   ///< the least of the depths since then
  double lowest_m;    ///< the greatest
  double out_s;       ///< how long the vehicle has been driven up
  bool sinks;         ///< it may be driven down
  double masked_s;    ///< how long another behaviour has commanded it
  double since_up_s;  ///< since it was driven up long enough to rise
  double last_m;      ///< the newest reading, and its change from the one before
  double moved_m;
  double gap_s;         ///< and the time from that one to it
  double roughness_m;   ///< how far readings are off the line between their neighbours
  bool lifts;           ///< it is driven up by pitch and pump
  bool dives;           ///< it is driven down by pitch
  uint8_t turning;      ///< so many further readings may be off the line for that
  double turned_m;      ///< the extreme since it was first driven so
  double dived_m;       ///< the depth that last showed this dive
  double alone_m;       ///< as deepest_m, by answers alone
  double answered_m;    ///< the depth that answered, or 0 once the vehicle must be at the surface
  double unanswered_m;  ///< how far it may have sunk since its depth last answered: since it moved
                        ///< as far as the vehicle was driven by pitch and pump. No other sensor
                        ///< counts here, since both may be stuck
} HookUnseenSink;

void hookUnseenSinkInit(HookUnseenSink* sink, const HookHull* hull);
/// Takes in one cycle, `step_s` after the previous one, at the beginning of which the vehicle had
/// been commanded `last` (pump NaN: by another behaviour, or not as hookbeh commanded).
/// `depth_m`: NaN while it is not believed.
void hookUnseenSinkObserve(HookUnseenSink* sink, double depth_m, double step_s,
                           const HookVerticalCommand* last);
/// Another working sensor reports that the vehicle is at `depth_m`.
void hookUnseenSinkConfirm(HookUnseenSink* sink, double depth_m);
/// How much farther than in calm water and with a reading every 4 s the vehicle may sink before
/// its depth can show it, m: swell hides its motion for a while, and so do rare readings.
double hookUnseenSinkLateBy(const HookUnseenSink* sink);

GLIDER_HOOKS_END

#endif
