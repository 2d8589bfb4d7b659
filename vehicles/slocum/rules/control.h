// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/worlds/worlds.h"
#include "platforms/load/platform.h"
#include "vehicles/slocum/mission_files/mission_file.h"
#include "vehicles/slocum/rules/layers.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::slocum::rules {

/// A behaviour of the vehicle's mission file that keeps hookbeh's commands from flying while the
/// mission flies.
struct Disturbance {
  enum class Kind : uint8_t {
    Masks,    ///< it replaces them for a time
    Prevents  ///< the SBC never gets control, or loses it for good
  };
  Kind kind = Kind::Masks;
  support::SourceRange range;  ///< of the behaviour, in the mission file
  std::string what;
  std::string change;
};

/// When the mission flies, and in which state.
class MissionTimes {
 public:
  /// `starts_s`: of the vehicle's mission, when hookbeh is ready.
  MissionTimes(const ir::WidestWorld& world, double starts_s);
  /// Whether the mission may still fly at that time of the vehicle's mission, s.
  [[nodiscard]] bool fliesAt(double vehicle_s) const;
  /// Nothing is proved about when the mission ends.
  [[nodiscard]] bool isOpen() const { return !ends_s_; }
  /// The states that may be current then: "in state `look`", "in one of the states `a`, `b`"; "" if
  /// nothing can be said.
  [[nodiscard]] std::string stateAt(double vehicle_s) const;
  /// "1 h 0 min 20 s after the vehicle's mission has begun", or "without a proved end".
  [[nodiscard]] std::string endText() const;
  [[nodiscard]] double starts() const { return starts_s_; }

 private:
  struct Current {
    std::string name;
    double earliest_s = 0, latest_s = 0;
  };
  double starts_s_;
  std::optional<double> ends_s_;  ///< after the mission's start
  std::vector<Current> states_;
};

/// What of `vehicle` disturbs the mission, in the order of the file. A dive above hookbeh is not
/// among it: wholeOf() refuses it (GL3127).
std::vector<Disturbance> disturbances(const slocum::MissionFile& vehicle,
                                      const std::vector<Layer>& layers, const MissionTimes& times,
                                      const platforms::Platform& platform);

}  // namespace glider::slocum::rules
