// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/dock/dock_run.h"
#include "vehicles/slocum/dock/vehicle_record.h"

#include <string>
#include <vector>

namespace glider::slocum {

/// What a check writes to a vehicle, after the user has agreed: values that keep it at the surface,
/// a count, and a heading that changes, which a mission file of the folder follows with the fin.
class Steering {
 public:
  Steering(DockRun& run, VehicleRecord& record) : run_(run), record_(record) {}

  /// What will be written, for the user to agree to.
  [[nodiscard]] std::string question() const;
  /// Writes for as long as the setup says, and takes it back.
  void steer();
  [[nodiscard]] std::vector<vehicles::DockCheck> findings() const;

 private:
  void write(bool east);
  void takeBack();
  void take(const std::string& body);

  DockRun& run_;
  VehicleRecord& record_;
  uint32_t count_ = 0;
  double wanted_rad_ = 0;
  double wanted_s_ = 0;          ///< since when
  bool follows_ = false;         ///< the vehicle has reported the heading that was written last
  uint32_t turns_ = 0;           ///< headings that were written
  std::vector<double> delays_s;  ///< until the vehicle reported them
  bool taken_back_ = false;
};

}  // namespace glider::slocum
