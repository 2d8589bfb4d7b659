// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/text.h"

#include <stdint.h>

/// The sentences of a Micro-Modem (README.md). Text points into the sentence that was read, or
/// stays where it is until it is written. No heap.
namespace glider::hooks::micro_modem {

using hooks::Text;
using hooks::textOf;

/// Who says a sentence: `$CC…` or `$CA…`.
enum class Side : uint8_t { Host, Modem };

/// Modems have addresses from 0 to 15. As a destination, 0 is all of them; glidercc gives no
/// vehicle that address.
inline constexpr uint32_t kMostAddress = 15;
inline constexpr uint32_t kEverybody = 0;

/// The data of a frame at rate 0, at most. Longer ones exist at other rates, and are refused.
inline constexpr uint32_t kMostFrameBytes = 32;

/// The name of a setting: letters and digits.
inline constexpr uint32_t kMostSettingName = 8;

/// The data of a frame.
struct Data {
  uint8_t bytes[kMostFrameBytes] = {};
  uint32_t size = 0;  ///< 0 as an answer to a DataRequest: no further requests
};

/// `CCCFG`: changes a setting. `CACFG`: it has that value.
template <Side side>
struct SettingOf {
  Text name;
  uint32_t value = 0;  ///< at most 65535
};
using SetSetting = SettingOf<Side::Host>;
using SettingIs = SettingOf<Side::Modem>;

/// `CCCYC`: starts a cycle, in which frames are sent. `CACYC`: one starts, ours or
/// another modem's.
template <Side side>
struct CycleOf {
  uint32_t source = 0;
  uint32_t destination = kEverybody;
  uint32_t rate = 0;  ///< 0 to 5
  bool acknowledge = false;
  uint32_t frames = 1;  ///< 1 to 8
};
using StartCycle = CycleOf<Side::Host>;
using CycleStarts = CycleOf<Side::Modem>;

/// What a sentence with a mini packet means.
enum class Mini : uint8_t {
  Send,     ///< `CCMUC`: from the host: send it
  Echo,     ///< `CAMUC`: the modem has taken it
  Received  ///< `CAMUA`: it was received
};

/// A mini packet, 13 bits.
template <Mini mini>
struct MiniPacketOf {
  uint32_t source = 0;
  uint32_t destination = kEverybody;
  uint32_t bits = 0;  ///< at most 0x1FFF
};
using SendMiniPacket = MiniPacketOf<Mini::Send>;
using MiniPacketEcho = MiniPacketOf<Mini::Echo>;
using MiniPacketReceived = MiniPacketOf<Mini::Received>;

// From the host to the modem.

/// `CCTXD`: the data of a frame, the answer to a DataRequest.
struct Transmit {
  uint32_t source = 0;
  uint32_t destination = kEverybody;
  bool acknowledge = false;
  Data data;
};

// From the modem to the host.

/// `CADRQ`: asks for the data of a frame.
struct DataRequest {
  uint32_t time_s = 0;  ///< of the modem's clock, since midnight
  uint32_t source = 0;
  uint32_t destination = kEverybody;
  bool acknowledge = false;
  uint32_t bytes = 0;  ///< that the frame has room for; at most 256
  uint32_t frame = 1;  ///< 1 to 8
};

/// `CARXD`: a frame was received.
struct Received {
  uint32_t source = 0;
  uint32_t destination = kEverybody;
  bool acknowledge = false;
  uint32_t frame = 1;  ///< 1 to 8
  Data data;
};

/// `CAMSG,BAD_CRC`: a damaged frame was received.
struct Damaged {
  uint32_t frame = 1;  ///< 1 to 8
};

/// `CAACK`: the receiver has acknowledged a frame.
struct Acknowledged {
  uint32_t source = 0;
  uint32_t destination = kEverybody;
  uint32_t frame = 1;  ///< 1 to 8
  bool acknowledged = true;
};

/// `CATXF`: the end of what was sent.
struct TransmitEnds {
  uint32_t bytes = 0;  ///< at most 65535
};

/// `CAERR`: the modem refuses something, in its own words.
struct Refusal {
  Text text;
};

/// `CAREV`: the modem has started, or still runs, in its own words.
struct Revision {
  Text text;
};

}  // namespace glider::hooks::micro_modem
