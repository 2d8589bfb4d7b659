// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame.h"
#include "hooks/protocol/messages.h"
#include "simulator/faults/faults.h"
#include "simulator/flight_observer.h"
#include "simulator/journal.h"
#include "simulator/link/serial_line.h"
#include "simulator/ports/sbc_port.h"

#include <memory>
#include <vector>

namespace glider::simulator {

/// Joins the SBC to its end of the serial line, in lockstep, and applies its faults: power, port,
/// clock, a mission that does not advance. Records how it ends.
class SbcLink {
 public:
  /// `sbc` may be null: a line without an SBC at its other end. `start` starts it again after its
  /// power has returned; without `start`, it stays off.
  SbcLink(std::unique_ptr<SbcPort> sbc, StartSbc start, const Faults& faults, uint64_t seed,
          SerialLine& line, Journal& journal)
      : port_(std::move(sbc)),
        start_(std::move(start)),
        faults_(faults),
        seed_(seed),
        line_(line),
        end_(line.right()),
        journal_(journal) {}

  /// Sets the observer of what the SBC sends; null: none.
  void showTo(FlightObserver* observer) { observer_ = observer; }
  /// Passes on what has arrived by `now_s` and puts the answers on the line.
  void pump(double now_s);
  /// The SBC, for its other ports; null while it has no power.
  [[nodiscard]] SbcPort* powered() const { return alive() ? port_.get() : nullptr; }
  [[nodiscard]] bool alive() const { return port_ != nullptr && port_->alive(); }
  /// Whether its board has power, which it draws with or without a program that runs.
  [[nodiscard]] bool hasPower() const { return port_ != nullptr && !without_power_; }
  /// True when it will not come back.
  [[nodiscard]] bool goneForGood(double now_s) const;

 private:
  void followPower(double now_s);
  void startAgain(double now_s, EventId why);
  void followPort(double now_s);
  void followCard(double now_s);
  void exchange(const std::vector<uint8_t>& bytes, double now_s);
  void answerAsStuck(const std::vector<uint8_t>& bytes);
  void watchDone(const std::vector<uint8_t>& bytes);
  void flush();
  void noteDeath(double now_s);
  [[nodiscard]] double sbcClock(double now_s);

  std::unique_ptr<SbcPort> port_;
  StartSbc start_;
  const Faults& faults_;
  uint64_t seed_;
  SerialLine& line_;
  GliderByteStream end_;
  Journal& journal_;
  FlightObserver* observer_ = nullptr;
  std::vector<uint8_t> waiting_;  ///< answers that the line had no room for yet
  bool death_noted_ = false;
  bool without_power_ = false;
  bool without_port_ = false;
  std::vector<bool> card_fault_done_;  ///< by index in the list of faults
  double newest_clock_s_ = 0;

  // What a stuck SBC keeps sending.
  hooks::FrameDecoder heard_, said_;
  hooks::Done last_done_;
  uint8_t said_sequence_ = 0;
};

}  // namespace glider::simulator
