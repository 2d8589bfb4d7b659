// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/packet.h"

#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <variant>
#include <vector>

/// A second codec of IMC: it follows a description of the messages as text, knows fields by name,
/// and shares nothing with hooks/imc but the types of a header.
namespace glider::imc_described {

using Bytes = std::vector<uint8_t>;
using hooks::imc::ByteOrder;
using hooks::imc::Header;

/// The bits of a number, or a text.
using Leaf = std::variant<uint64_t, std::string>;
/// Each number and text of a message by its path, such as `reference.speed.value`.
/// `reference.speed?` is 1 if that message is there, else 0.
using Leaves = std::map<std::string, Leaf>;

/// The messages that are described: id → name.
std::map<uint16_t, std::string> described();

/// Values for all fields of a message; NaN only as hooks/imc writes it.
Leaves randomLeaves(uint16_t id, std::mt19937& random);

Bytes payloadOf(uint16_t id, const Leaves& leaves, ByteOrder order);
/// Nothing if the payload is not exactly such a message.
std::optional<Leaves> leavesOf(uint16_t id, const Bytes& payload, ByteOrder order);

/// A whole packet.
Bytes packetOf(uint16_t id, const Header& header, const Bytes& payload, ByteOrder order);

/// CRC-16/ARC, bit by bit.
uint16_t slowCrc(const Bytes& bytes);

}  // namespace glider::imc_described
