// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/messages.h"
#include "runtime/front_seat/position.h"

#include <stdint.h>

namespace glider::runtime::recon {

/// A row of readings.def.
enum class Reading : uint8_t {
#define READING(name, source, unit) name,
#include "runtime/recon/readings.def"
#undef READING
  Count
};
inline constexpr uint32_t kReadings = static_cast<uint32_t>(Reading::Count);

/// What the vehicle reports, in the units of readings.def. No heap.
class Readings {
 public:
  Readings();

  /// `clock_s`: of that state, since 1970.
  void take(const hooks::recon::State& state, double clock_s);
  void take(const hooks::recon::Ctd& ctd);
  /// The newest value; NaN before the first.
  [[nodiscard]] double value(Reading reading) const { return values_[index(reading)]; }
  /// Takes the value that was reported since the last call; false if there was none.
  bool takeReport(Reading reading, double* value);
  /// The depth in the newest state, m; NaN if that has none.
  [[nodiscard]] double depthNow() const { return depth_now_; }
  /// Where the vehicle is, by the newest state that had a position; unknown if that is kOldSecs
  /// older than the newest.
  [[nodiscard]] const Place& here() const { return here_; }

  static constexpr double kOldSecs = 10;

 private:
  static constexpr uint32_t index(Reading reading) { return static_cast<uint32_t>(reading); }
  void set(Reading reading, double value);
  void takePlace(const hooks::recon::State& state, double clock_s);

  double values_[kReadings];
  bool fresh_[kReadings] = {};
  double depth_now_ = __builtin_nan("");
  Place here_;
  double here_s_ = __builtin_nan("");  ///< by the vehicle's clock
};

}  // namespace glider::runtime::recon
