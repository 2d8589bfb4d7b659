// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/messages.h"

namespace glider::runtime::recon {

/// A simulated vehicle says this before all else: its clock waits for the SBC, whose program does
/// not keep its own time then.
inline constexpr char kVirtualTime[] = "virtual-time";

inline bool isVirtualTime(const hooks::recon::SimulationText& said) {
  return said.text == hooks::recon::textOf(kVirtualTime);
}

}  // namespace glider::runtime::recon
