// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/messages.h"
#include "hooks/imc/packet.h"

#include <stdint.h>

namespace glider::hooks::imc {

// For each message of messages.def:
//
// encode writes a whole packet, with little-endian numbers, into `bytes`, of which there are
// `capacity`. It returns the size of the packet; 0 if it does not fit there, its payload would be
// above kMostPayload, or an AnyMessage holds what was not read.
//
// decode takes the message out of a packet in either byte order. It returns false, and the message
// has no meaning, for a packet of another message; if the payload is not exactly as long as its
// fields; or if it holds a message or a list that cannot be read there (fields.h). Numbers are
// taken as they are, NaN and infinities too.
#define MESSAGE(name, number)                                                              \
  [[nodiscard]] uint32_t encode(const Header& header, const name& message, uint8_t* bytes, \
                                uint32_t capacity);                                        \
  [[nodiscard]] bool decode(const Packet& packet, name& message);
#define FIELD(type, name)
#define MESSAGE_END
#include "hooks/imc/messages.def"

}  // namespace glider::hooks::imc
