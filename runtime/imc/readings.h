// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/codec.h"
#include "hooks/imc/packet.h"

#include <stdint.h>

namespace glider::runtime::imc {

/// A row of readings.def.
enum class Reading : uint8_t {
#define READING(name, source, unit) name,
#include "runtime/imc/readings.def"
#undef READING
  Count
};
inline constexpr uint32_t kReadings = static_cast<uint32_t>(Reading::Count);

/// What the vehicle reports, in the units of readings.def. No heap.
class Readings {
 public:
  Readings();

  /// Takes what the packet reports, if it is of a message that readings.def names.
  void take(const hooks::imc::Packet& packet);
  /// The newest value; NaN before the first.
  [[nodiscard]] double value(Reading reading) const { return values_[index(reading)]; }
  /// Takes the value that was reported since the last call; false if there was none.
  bool takeReport(Reading reading, double* value);
  /// The value is not known until it is reported again.
  void forget(Reading reading);
  /// Where the vehicle is, degrees; NaN before the first state.
  [[nodiscard]] double latitude() const { return latitude_; }
  [[nodiscard]] double longitude() const { return longitude_; }

 private:
  static constexpr uint32_t index(Reading reading) { return static_cast<uint32_t>(reading); }
  void set(Reading reading, double value);
  void takeState(const hooks::imc::EstimatedState& state);
  void takeFix(const hooks::imc::GpsFix& fix);
  void takeNumber(const hooks::imc::Packet& packet);

  double values_[kReadings];
  bool fresh_[kReadings] = {};
  double latitude_ = __builtin_nan("");
  double longitude_ = __builtin_nan("");
};

}  // namespace glider::runtime::imc
