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
/// What the vehicle offers and needs.
void hookSeatFeatures(const HookSeat* seat, HookFeatures* features);

GLIDER_HOOKS_END

#endif
