// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/seat_on_board.h"
#include "simulator/ports/line_turns.h"

#include <cstdint>
#include <memory>

namespace glider::flights {

/// The SBC is at a port of the vehicle that is not hookprog's: the Slocum's for a backseat driver,
/// or one that speaks IMC or RECON.
struct PortEnd {
  SeatSettings mission;
  uint32_t clock = 0;  ///< the index on a Slocum's port of the vehicle's clock
  uint32_t baud = 0;   ///< of the line, as the vehicle's list of sensors says

  /// Who knows when the SBC owes an answer there.
  [[nodiscard]] std::unique_ptr<simulator::LineTurns> turns() const;
};

}  // namespace glider::flights
