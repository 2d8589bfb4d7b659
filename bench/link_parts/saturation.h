// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "bench/link_parts/line.h"
#include "hooks/client/client.h"
#include "hooks/hookprog/hookprog.h"
#include "tests/slocum.h"

#include <set>
#include <vector>

/// What the line carries when it is never idle.
namespace glider::bench {

using namespace glider::hooks;

/// Flight cycles as fast as the 115200 line takes their Ticks, each with every subscribed sensor
/// reported and `changing` of them changed.
class Saturation {
 public:
  /// `changing` from 0 to 1.
  Saturation(size_t sensors, double changing);

  /// Flies so long, and prints what the line carried.
  void run(double seconds);

 private:
  static constexpr double kWarmUp = 5;
  static constexpr uint64_t kUnderWay = 1200;

  static double get(void* self, uint16_t id, bool* fresh);
  static void set(void* self, uint16_t id, double value);
  [[nodiscard]] bool changes(uint16_t id) const;
  /// A one-byte sensor holds small numbers only.
  [[nodiscard]] double valueOf(uint16_t id) const;
  void flightCycle();
  void pollClient();
  void countTick();
  /// The SBC's end, which counts what it reads.
  GliderByteStream counted();

  std::vector<Subscription> subscribed_;
  double changing_;
  Client client_;
  Hookprog hookprog_{gliderDictionary};
  SerialLine line_{kFastBaud};
  Tap tap_{line_.left(), 0, Noise(1, 0)};
  std::set<uint16_t> fresh_;  ///< in the science computer's memory
  double now_ = 0, cycle_ = 0, ticks_ = 0, value_bytes_ = 0;
  uint64_t read_ = 0, written_before_ = 0;
};

}  // namespace glider::bench
