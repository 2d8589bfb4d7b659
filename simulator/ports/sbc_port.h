// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"
#include "support/result.h"
#include "support/trace/trace.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glider::simulator {

/// The SBC end of the 115200 line in virtual time: in process, or a program behind a pty. The
/// simulator never links the runtime; this is where they meet.
class SbcPort {
 public:
  SbcPort() = default;
  SbcPort(const SbcPort&) = delete;
  SbcPort& operator=(const SbcPort&) = delete;
  virtual ~SbcPort() = default;

  /// "in-process", "host", "ts7800", "ts5500".
  [[nodiscard]] virtual std::string way() const = 0;
  /// The time of the simulated world, s, before each deliver(): for those who look on. The SBC's
  /// own clock may differ.
  virtual void setTime(double /*now_s*/) {}
  /// Passes on bytes that have arrived at the SBC by virtual time `now_s`.
  virtual void deliver(std::span<const uint8_t> bytes, double now_s) = 0;
  /// Lockstep: waits until the SBC has ended its answers to all whole frames delivered so far (each
  /// ends with a Done message), or is gone, or has not answered for ten seconds of real time;
  /// returns what it sent since the last call.
  virtual std::vector<uint8_t> collect() = 0;
  /// Cuts its power.
  virtual void kill() = 0;
  /// A program that has ended by itself counts as alive until it owes an answer.
  [[nodiscard]] virtual bool alive() const = 0;
  /// True when its own clock is the time of deliver(): it is then called in every step of the
  /// flight, also with no bytes, and its time-outs run. A separate program has its own clock, and
  /// only receives frames.
  [[nodiscard]] virtual bool keepsTime() const { return false; }
  /// Its serial port is unplugged or plugged in again. Only for a port that keeps time.
  virtual void plug(bool /*in*/) {}
  /// Passes on what the acoustic modem has sent to the second serial port of the SBC, which may be
  /// nothing. Called in every step of the flight, after deliver(), while the SBC has power and a
  /// modem is in use.
  virtual void hearModem(std::span<const uint8_t> /*bytes*/) {}
  /// As if the modem had received `raw` for the mission's sensor `id`, which is not the vehicle's:
  /// for a replay.
  virtual void hearValue(uint16_t /*id*/, double /*raw*/) {}
  /// What the SBC has sent to the modem since the last call, which follows each hearModem().
  virtual std::vector<uint8_t> toModem() { return {}; }
  /// What its mission has logged since the last call, as far as that is known.
  virtual std::vector<support::LoggedNote> takeNotes() { return {}; }
  /// Damages the data on its storage card; `seed` determines where. The card of an external SBC
  /// cannot be reached.
  virtual void damageCard(const CardFault& /*fault*/, uint64_t /*seed*/) {}
  /// Why it is not alive, for the trace: "killed", "exited with status 1", "hung"; empty while it
  /// is.
  [[nodiscard]] virtual std::string exitReason() const = 0;
};

/// Starts an SBC.
using StartSbc = std::function<support::Result<std::unique_ptr<SbcPort>>()>;

}  // namespace glider::simulator
