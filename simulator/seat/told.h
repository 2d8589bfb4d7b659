// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/seat/events.h"

#include <string_view>

namespace glider::simulator {

/// What a back seat tells of its mission in a text: `mission,NAME`, `transition,TIME,A,B,C,D,E`,
/// `note,TIME,KIND,TEXT`, or anything, which is a note at `mission_time_s`.
hooks::SeatEvent toldIn(std::string_view text, double mission_time_s);

/// Takes the text before the first `separator` off `text`; all of it if there is none.
std::string_view takePart(std::string_view& text, char separator);
bool readWhole(std::string_view text, uint32_t& value);
bool readReal(std::string_view text, double& value);

}  // namespace glider::simulator
