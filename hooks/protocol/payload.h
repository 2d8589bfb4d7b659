// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/frame.h"

/// How the encoders and decoders of messages begin and end.
namespace glider::hooks {

inline ByteWriter startPayload(Frame& frame, MessageType type, uint32_t most = kMostPayload) {
  frame.type = type;
  frame.size = 0;
  return {frame.payload, most};
}

inline void finishPayload(Frame& frame, const ByteWriter& writer) {
  frame.size = static_cast<uint16_t>(writer.size());
}

inline ByteReader payloadOf(const Frame& frame) {
  return {frame.payload, frame.size};
}

/// Flags of Beacon, Welcome and Tick.
inline constexpr uint8_t kFlagVirtualTime = 4;

}  // namespace glider::hooks
