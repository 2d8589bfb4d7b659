// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/vehicle/propeller_forces.h"
#include "simulator/vehicle/vehicle_model.h"

namespace glider::simulator {

/// A vehicle with a propeller, a rudder and stern planes. It is lighter than the water: stopped, it
/// floats up, and at the surface it floats as deep as its weight needs.
class PropellerModel final : public VehicleModel {
 public:
  PropellerModel(const platforms::PropellerMotion& motion, const VehicleSettings& settings);

  [[nodiscard]] VehicleState start() const override;
  void step(VehicleState& state, const VehicleCommand& command, const Ocean& ocean,
            double now_s) const override;

 private:
  /// The water around the vehicle during one step.
  struct Water {
    double density = 0;  ///< kg/m3
    double depth_m = 0;  ///< of the bottom
    Planar current;
    double rises_mps = 0;
  };

  void moveMotors(VehicleState& state, double seconds) const;
  [[nodiscard]] double netLift(double depth_m, double density) const;
  [[nodiscard]] bool aground(const VehicleState& state, const Water& water) const;
  void moveHull(VehicleState& state, const Water& water, double seconds) const;

  platforms::PropellerMotion motion_;
  VehicleSettings settings_;
  double volume_m3_;
};

}  // namespace glider::simulator
