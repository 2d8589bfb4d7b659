// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/line_reader.h"
#include "hooks/recon/messages.h"

#include <stdint.h>

namespace glider::hooks::recon {

// For each message of messages.h:
//
// encode writes a whole line into `bytes`, of which there are `capacity`. It returns the size of
// the line; 0 if it does not fit there, if a number that a command needs is not finite, or if a
// text holds what would begin or end a line.
//
// decode takes the message out of a line. It returns false, and the message has no meaning, for a
// line of another message, or if a field is not what it should be there (README.md, rules R5 to
// R9).
#define RECON_MESSAGE(name)                                                           \
  [[nodiscard]] uint32_t encode(const name& message, char* bytes, uint32_t capacity); \
  [[nodiscard]] bool decode(const Line& line, name& message);
#include "hooks/recon/messages.def"
#undef RECON_MESSAGE

}  // namespace glider::hooks::recon
