// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/tick.h"

#include <stdint.h>

namespace glider::hooks {

/// Decides what each Tick reports about the subscribed sensors: only what the SBC does not hold
/// already. A value counts as held once a Tick that brought it was answered; until then it is sent
/// with each report, so a lost Tick delays a change only until the next report.
class Reporter {
 public:
  /// A value that was sent this many Ticks ago is sent again with the next report, so that the
  /// effect of a damaged frame that passed its CRC does not last.
  static constexpr uint32_t kRefreshTicks = 16;

  /// `dictionary` outlives this.
  explicit Reporter(const GliderDictionary& dictionary) : dictionary_(&dictionary) {}

  /// From now on `subscribe` is served; the SBC holds nothing.
  void serve(const Subscribe& subscribe);
  [[nodiscard]] const Subscribe& subscription() const { return subscription_; }
  [[nodiscard]] uint16_t check() const { return check_; }

  /// Begins the next Tick.
  void begin();
  /// Subscribed sensor number `index` was reported in this cycle.
  void report(uint32_t index, double value);
  /// The content of the Tick, after all sensors are reported.
  [[nodiscard]] const TickReadings& readings() const { return readings_; }
  /// The Tick goes as frame `sequence`.
  void sent(uint8_t sequence);
  /// The SBC has answered frame `sequence`: if that is one of the newest Ticks, the SBC knows its
  /// content.
  void answered(uint8_t sequence);

 private:
  static constexpr uint32_t kRemembered = 8;  ///< Ticks whose answer may still arrive

  [[nodiscard]] bool isHeld(uint32_t index, uint64_t bits) const;
  void confirm(uint32_t ticks_ago);

  struct Row {
    uint64_t bits = 0;       ///< of the newest value sent, as on the line
    bool held = false;       ///< and the SBC has it
    uint8_t rest = 0;        ///< Ticks until it may be reported again
    uint8_t age = 0;         ///< Ticks since the value was sent, counted to kRefreshTicks
    uint8_t brought_in = 0;  ///< Ticks that carried exactly this value: bit 0 the newest
    uint8_t told_in = 0;     ///< Ticks that reported the sensor at all
  };
  [[nodiscard]] uint32_t widthOf(uint32_t index) const;

  const GliderDictionary* dictionary_;
  Subscribe subscription_;
  uint16_t check_ = 0xFFFF;  ///< of the empty subscription
  Row rows_[kMostSubscriptions];
  TickReadings readings_;
  uint8_t sequences_[kRemembered] = {};  ///< of the newest Ticks, the newest first
  uint32_t remembered_ = 0;
};

}  // namespace glider::hooks
