// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"
#include "simulator/sensors/noise.h"

#include <cstdint>
#include <deque>
#include <vector>

namespace glider::simulator {

/// Applies faults to the bytes of one direction of a line: passes them on unchanged, late, damaged,
/// doubled or not at all. The same seed and bytes give the same damage.
class LineDamage {
 public:
  /// A byte and the time at which it is at the other end.
  struct Arrival {
    uint8_t value;
    double at_s;
  };

  /// Uses those of `faults` that are in direction `way`; `baud` is the line's speed.
  LineDamage(const std::vector<LineFault>& faults, LineWay way, uint64_t seed, double baud);

  /// Byte `value` is sent at `now_s` and would arrive at `at_s`; what arrives goes to `out`.
  /// Returns how many seconds more the wire is busy, with frames that it sends twice.
  double pass(uint8_t value, double now_s, double at_s, std::deque<Arrival>& out);
  /// True when this direction has no fault in the whole flight.
  [[nodiscard]] bool none() const { return faults_.empty(); }

 private:
  void damage(uint8_t value, double now_s, double at_s, std::deque<Arrival>& out);
  [[nodiscard]] bool vanishes(const LineFault& fault);
  void spoil(const LineFault& fault, uint8_t& value);
  [[nodiscard]] int copiesAtAnotherBaud(const LineFault& fault);
  [[nodiscard]] bool isDoubled(double now_s);
  const std::vector<uint8_t>* replayedFrame(double now_s);
  double again(const std::vector<uint8_t>& frame, double now_s, double at_s,
               std::deque<Arrival>& out);
  void remember(std::vector<uint8_t> frame);
  uint8_t randomByte() { return static_cast<uint8_t>(noise_.uniform() * 256); }

  std::vector<LineFault> faults_;
  Noise noise_;
  double baud_;
  std::vector<uint8_t> frame_;                 ///< the frame that is being sent
  std::vector<std::vector<uint8_t>> earlier_;  ///< frames that may be repeated; empty if none can
  double burst_left_ = 0;                      ///< bytes
  double heard_ = 0;     ///< bytes that a receiver at another speed has begun to receive
  double newest_s_ = 0;  ///< no byte overtakes another
};

}  // namespace glider::simulator
