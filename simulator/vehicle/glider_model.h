// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/vehicle/vehicle_model.h"

namespace glider::simulator {

/// A buoyancy glider: a pump, a battery that moves to change the pitch, and a fin.
class GliderModel final : public VehicleModel {
 public:
  /// `envelope`: how far pump and fin move in either direction.
  GliderModel(const platforms::Motion& motion, const platforms::Envelope& envelope,
              const VehicleSettings& settings);

  [[nodiscard]] VehicleState start() const override;
  void step(VehicleState& state, const VehicleCommand& command, const Ocean& ocean,
            double now_s) const override;

 private:
  void moveMotors(VehicleState& state, const VehicleCommand& command) const;
  void movePitch(VehicleState& state) const;
  [[nodiscard]] double buoyancy(const VehicleState& state, double density) const;
  void moveThroughWater(VehicleState& state, double density, bool aground) const;
  void turn(VehicleState& state, double speed_mps) const;

  platforms::Motion motion_;
  double pump_cc_, fin_rad_;
  VehicleSettings settings_;
  double pitch_share_, yaw_share_, speed_share_;  ///< the share of each lag that one step covers
};

}  // namespace glider::simulator
