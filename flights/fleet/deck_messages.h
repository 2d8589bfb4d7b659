// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/share_messages.h"
#include "support/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The messages of a fleet at another end than its vehicles: a modem on a ship or a buoy.
namespace glider::flights {

/// How a message was received.
enum class HeardBy : uint8_t { Frame, MiniPacket, Janus };

/// "frame", "mini packet", "JANUS".
const char* nameOf(HeardBy by);

struct HeardMessage {
  HeardBy by = HeardBy::Frame;
  uint32_t source = 0;       ///< the address of the sender's modem
  ir::ShareMessage message;  ///< of the mission
  std::vector<double>
      values;  ///< of its shares, SI units or degrees; NaN: the sender does not know
};

/// The message of `mission` in a line of what a modem says: `$CARXD,…`, `$CAMUA,…`, or the 16
/// hexadecimal digits of a JANUS packet, with anything around a sentence, and before the digits.
/// Also of what a host says (`$CCTXD,…`, `$CCMUC,…`), and for any destination. A JANUS packet must
/// be of that class of user. Empty: there is none.
std::optional<HeardMessage> messageIn(const ir::Mission& mission, std::string_view line,
                                      uint8_t janus_class);

/// A message for the modem of a ship.
struct DeckMessage {
  ir::ShareMessage message;
  std::vector<double> values;  ///< as they will be received
  std::string frame;           ///< `$CCTXD,…`, the answer to the modem's request
  std::string mini;            ///< `$CCMUC,…`; empty: vehicles expect the frame
  std::string janus;           ///< 16 hexadecimal digits; empty: it has more than 34 bits
};

/// The messages of the shares in `settings`, "top=42 m", from `source`, for all vehicles; other
/// shares of these messages are unknown. Fails for a share that the mission has not, and for a
/// value that it does not have.
support::Result<std::vector<DeckMessage>> messagesFor(const ir::Mission& mission,
                                                      const std::vector<std::string>& settings,
                                                      uint32_t source, uint8_t janus_class);

/// "top 42 m, temp unknown": values of the shares of a message.
std::string shownMessage(const ir::Mission& mission, const ir::ShareMessage& message,
                         const std::vector<double>& values);

}  // namespace glider::flights
