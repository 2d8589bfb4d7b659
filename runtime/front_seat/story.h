// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/seat/events.h"
#include "hooks/seat/seat.h"

#include <stdint.h>

namespace glider::runtime {

/// What the SBC tells of its mission in the vehicle's log is at most so long.
inline constexpr uint32_t kMostStory = 160;

/// An entry for the vehicle's log about what has happened in the mission; returns its size, 0 if
/// the event is not for it. `text` has room for kMostStory.
uint32_t storyOf(const hooks::SeatEvent& event, char* text);

/// An entry that says in which state the mission is, and its time.
uint32_t stateStory(const hooks::SbcView& view, char* text);

}  // namespace glider::runtime
