// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_SEAT_HANDLE_H
#define GLIDER_HOOKS_SEAT_HANDLE_H

#include "hooks/seat/seat.h"

/// Parts of the seat that its own files share.
GLIDER_HOOKS_BEGIN

/// Takes a whole frame of the SBC while the seat is served.
void hookSeatHandle(HookSeat* seat, const HookFrame* frame);

/// Reports an event of the vehicle's own time.
void hookSeatTell(HookSeat* seat, HookSeatEventKind kind, uint32_t a, uint32_t b, uint32_t c);
/// Nothing is known of the SBC's mission.
void hookSeatForgetView(HookSeat* seat);
/// Numbers `frame` and queues it.
void hookSeatSend(HookSeat* seat, HookFrame* frame);
/// The SBC steers on, or sleeps as the vehicle allows: the next heartbeat.
void hookSeatBeat(HookSeat* seat, const HookSeatVehicle* vehicle, bool asleep);
/// What the vehicle offers and needs.
void hookSeatFeatures(const HookSeat* seat, HookFeatures* features);

/// The SBC owes an answer from now on, unless it did before.
void hookSeatWaitForAnswer(HookSeat* seat);

/// A Nap, which counts only in an answer to a Tick, and if the Done comes next. False if it is not
/// a good one.
bool hookSeatTakeNap(HookSeat* seat, const HookFrame* frame);
/// The SBC has answered, as the session in control: it may sleep until the next Tick that matters.
/// Only an answer to the newest Tick counts: what is on its way wakes it at once.
void hookSeatBeginNap(HookSeat* seat, const HookDone* done);
/// Wakes the SBC if it sleeps.
void hookSeatWake(HookSeat* seat, HookNapEnd why);
/// Numbers and keeps the Tick in `frame`, with `head`; it may end the nap.
void hookSeatKeepTick(HookSeat* seat, const HookTickHead* head, HookFrame* frame);
/// A heartbeat in the place of an SBC that sleeps, until it answers again.
void hookSeatBeatInItsPlace(HookSeat* seat, const HookSeatVehicle* vehicle);
/// Sends what waits, then what was kept as far as the line takes it. False when it is closed.
bool hookSeatSendAll(HookSeat* seat, const GliderByteStream* sbc);

GLIDER_HOOKS_END

#endif
