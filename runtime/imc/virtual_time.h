// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/codec.h"

namespace glider::runtime::imc {

/// A simulated vehicle announces this service before all else: its clock waits for the SBC, whose
/// program does not keep its own time then.
inline constexpr char kVirtualTimeService[] = "glidercc+virtual-time";

inline bool isVirtualTime(const hooks::imc::Packet& packet) {
  hooks::imc::Announce announce;
  return packet.id == hooks::imc::Announce::kId && decode(packet, announce) &&
         announce.services == hooks::imc::textOf(kVirtualTimeService);
}

}  // namespace glider::runtime::imc
