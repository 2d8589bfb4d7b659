// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/lockstep.h"

#include <cstdint>
#include <memory>

namespace glider::simulator {

/// Follows a line between vehicle and SBC and knows whether the SBC still owes an answer: in
/// virtual time the vehicle's clock waits for that.
class LineTurns {
 public:
  LineTurns() = default;
  LineTurns(const LineTurns&) = delete;
  LineTurns& operator=(const LineTurns&) = delete;
  virtual ~LineTurns() = default;

  virtual void toSbc(const uint8_t* bytes, uint32_t count) = 0;
  virtual void fromSbc(const uint8_t* bytes, uint32_t count) = 0;
  [[nodiscard]] virtual bool settled() const = 0;
};

/// Frames of the hook protocol.
std::unique_ptr<LineTurns> hookTurns();

/// Sentences of the port for a backseat driver: what reports the sensor with index `clock` is a
/// control cycle, and a sentence with the SBC's count answers it.
std::unique_ptr<LineTurns> portTurns(uint32_t clock);

/// Packets of IMC: the first state of a second is a cycle, and the SBC's Heartbeat ends its answer.
std::unique_ptr<LineTurns> imcTurns();

/// Lines of RECON, of a simulated vehicle: the first state of a second is a cycle once the date is
/// known, and what the SBC reports of its mission's state, or a query of the time, ends its answer.
std::unique_ptr<LineTurns> reconTurns();

}  // namespace glider::simulator
