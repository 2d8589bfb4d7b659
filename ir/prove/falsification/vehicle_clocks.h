// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <optional>
#include <span>
#include <vector>

namespace glider::ir::prove {

/// The sensors of a mission that are clocks of the vehicle (that of the calendar, of which `utc`
/// and `timeofday` are made, and its seconds into its own mission). They are healthy: they go on as
/// mission time does (docs/verification.md), which only traces and flights know, not proofs.
class VehicleClocks {
 public:
  explicit VehicleClocks(const ProofContext& proof_context);

  [[nodiscard]] const std::vector<SensorId>& sensors() const { return sensors_; }
  /// False if one of these readings (by sensor, SI units; NaN: unknown) at mission time `time`, s,
  /// does not go with one before, by more than kTolerance_s.
  bool goOn(std::span<const double> readings, double time);

 private:
  /// A reading may be from the frame before, and another one from the newest.
  static constexpr double kTolerance_s = 30;

  std::vector<SensorId> sensors_;
  std::vector<std::optional<double>> started_;  ///< of each: its reading when the mission began
};

}  // namespace glider::ir::prove
