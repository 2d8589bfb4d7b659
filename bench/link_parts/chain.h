// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "bench/link_parts/line.h"
#include "hooks/client/client.h"
#include "hooks/hookbeh/hookbeh.h"
#include "hooks/hookprog/hookprog.h"
#include "simulator/slocum/line/flight_science_line.h"
#include "tests/slocum.h"

#include <array>
#include <vector>

/// The path of a sensor's change through SBC and hooks.
namespace glider::bench {

using namespace glider::hooks;

/// The whole chain in its usual time, with an SBC that gives an instruction whenever the sensor
/// that it watches has changed.
class Chain {
 public:
  Chain(uint16_t watched, double damage, uint64_t seed)
      : watched_(watched),
        noise_(seed, 10),
        science_side_(sbc_line_.left(), damage, Noise(seed, 11)),
        sbc_side_(sbc_line_.right(), damage, Noise(seed, 12)),
        line_({}, seed) {
    array_.fill(kNaN);
  }

  /// Cycles from each of `count` changes of the sensor to the command, sorted.
  std::vector<double> latencies(size_t count);

 private:
  static double get(void* self, uint16_t id, bool* fresh);
  static void set(void* self, uint16_t id, double value);
  /// The watched sensor changes now and then, once the chain is at rest.
  void maybeChange(bool its_time);
  void flightCycle();
  [[nodiscard]] HookbehInputs inputs() const;
  /// All sensors of the flight controller, as in each cycle of a vehicle.
  void report(const HookbehOutputs& out);
  void pollClient();
  void decide();
  /// The depth of the instruction identifies the value that caused it.
  static double depthFor(double value) { return 10 + value; }
  void instruct(HookControl control, double value);

  uint16_t watched_;
  Noise noise_;
  SerialLine sbc_line_{kFastBaud};
  Tap science_side_, sbc_side_;
  simulator::FlightScienceLine line_;
  std::array<double, GLIDER_SENSOR_COUNT> memory_{};  ///< of the science computer
  std::array<bool, GLIDER_SENSOR_COUNT> fresh_{};
  Hookprog hookprog_{gliderDictionary};
  Hookbeh hookbeh_{HookbehArgs{}, kHull};
  std::array<double, GLIDER_SENSOR_COUNT> array_{};
  std::array<Subscription, 1> subscribed_{{{watched_, 1, 0}}};
  Client client_{gliderDictionary, {"bench", 1, subscribed_.data(), 1}};
  double now_ = 0, cycle_ = 0, value_ = 10, known_ = kNaN, changed_at_ = 0;
  HookState state_ = HookState::Absent;
  bool at_rest_ = true, taking_ = false;
  std::vector<double> latencies_;
};

}  // namespace glider::bench
