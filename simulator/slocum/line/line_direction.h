// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/sensors.h"
#include "simulator/faults/faults.h"
#include "simulator/sensors/noise.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glider::simulator {

/// A sensor's value on its way: the sensor by its number in the platform file, or by its name if
/// the file does not list it (then `id` is kNoSensor).
struct PassingValue {
  uint16_t id = hooks::kNoSensor;
  std::string name = {};
  double value = 0;
};

/// How late a value arrives, s.
struct LineLag {
  double least_s = 0;
  double usual_s = 0;      ///< most values are no later
  double most_s = 0;       ///< a value that waits behind those of other programs
  double waits_share = 0;  ///< share of these
};

/// One direction of the line between the data memories of the vehicle's two computers, as far as
/// the vendor's line is publicly known: each value goes as text with six decimals, is late by a
/// time of its own, and may overtake values of other sensors, but no older one of its own. A text
/// that noise has damaged is lost: the vendor's line has checks of its own.
class LineDirection {
 public:
  /// Uses those of `faults` that act in direction `way`.
  LineDirection(const Faults& faults, LineWay way, const LineLag& lag, uint64_t seed);

  /// Sets the time; it never goes back.
  void setNow(double now_s);
  /// The sending computer has set a sensor. NaN, never set, does not go.
  void send(PassingValue value);
  /// The next value that has arrived; none if there is no other now.
  std::optional<PassingValue> next();
  /// The receiving computer loses its power: what has arrived is gone.
  void dropArrived();
  /// The sending computer loses its power: what has not been sent is gone.
  void dropUnsent() { passing_.clear(); }

 private:
  struct Passing {
    double due_s;  ///< by the clock of the line
    PassingValue value;
  };
  [[nodiscard]] double lag();
  bool getsThrough(const PassingValue& value);
  [[nodiscard]] bool isSpoilt(const LineFault& fault, double characters);
  bool happens(double share) { return share > 0 && noise_.uniform() < share; }
  void pass(PassingValue value, double more_s);
  void repeat();

  std::vector<LineFault> faults_;
  std::vector<Span> consoles_;
  LineLag lag_;
  Noise noise_;
  double now_s_ = 0;
  double line_s_ = 0;  ///< the time without that in which the line was suspended
  std::vector<Passing> passing_;
  std::vector<PassingValue> earlier_;  ///< that may come again; empty if none can
  double burst_left_ = 0;              ///< characters
};

}  // namespace glider::simulator
