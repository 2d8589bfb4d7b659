// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>
#include <string_view>

namespace glider::codegen::validate {

/// What is known of a function that generated code calls.
enum class Contract : uint8_t {
  None,     ///< nothing
  Command,  ///< changes the world (Memory); returns nothing
  Note,     ///< gliderNote: the same, with values from memory
  Window,   ///< changes the window whose memory it gets, from that and the other arguments
  Pure,     ///< its result depends on its arguments, and is settled
  Table,    ///< gliderFirstTrue: the first case that a table of guards finds
  Foreign   ///< the user's: returns any number, and changes the world
};

/// Of the function with that symbol: one of the runtime's, or of those that the mission declares.
Contract contractOf(const ir::Mission& mission, std::string_view symbol);

inline constexpr std::string_view kSettle = "gliderSettle";

}  // namespace glider::codegen::validate
