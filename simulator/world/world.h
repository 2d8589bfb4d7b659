// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/geography/local_frame.h"
#include "simulator/ocean/ocean.h"
#include "simulator/scenario/scenario.h"
#include "simulator/vehicle/vehicle_model.h"

#include <cstdint>

namespace glider::simulator {

/// What all vehicles of a simulation share: the origin, to which positions in m are relative, the
/// water and the clock.
class World {
 public:
  /// Its origin is the start of `scenario`.
  explicit World(const Scenario& scenario)
      : origin_{scenario.latitude_deg, scenario.longitude_deg},
        frame_(scenario.latitude_deg, scenario.longitude_deg),
        ocean_(scenario.ocean),
        year_(scenario.year) {}

  [[nodiscard]] const GeoPosition& origin() const { return origin_; }
  [[nodiscard]] const LocalFrame& frame() const { return frame_; }
  [[nodiscard]] const Ocean& ocean() const { return ocean_; }
  [[nodiscard]] double year() const { return year_; }  ///< with its fraction

  /// s since it began. Each vehicle is brought to this time with SimulatedVehicle::advance.
  [[nodiscard]] double now() const { return static_cast<double>(steps_) * VehicleModel::kStep; }
  void tick() { ++steps_; }  ///< the clock advances by a step of the vehicle models

 private:
  GeoPosition origin_;
  LocalFrame frame_;
  Ocean ocean_;
  double year_;
  int64_t steps_ = 0;
};

}  // namespace glider::simulator
