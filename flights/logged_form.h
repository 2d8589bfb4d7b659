// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace glider::flights {

/// How a value that a mission logs is shown to people.
struct LoggedForm {
  enum class Half : uint8_t { None, Latitude, Longitude };

  std::string unit;        ///< "m", "deg"; "timestamp": s since 1970; empty for a plain number
  double to_shown = 1;     ///< factor from SI
  Half half = Half::None;  ///< what it is of a position, in degrees

  bool operator==(const LoggedForm&) const = default;
};

/// The unit of a sensor under the vehicle's name, "m_depth"; empty: none, or not known.
using SensorUnit = std::function<std::string(const std::string& vehicle_name)>;

/// The form of a value of `type` that does not come from a sensor.
LoggedForm formOf(const ir::Type& type);
/// The form of an expression's value; the one of the sensor for a bare reading, and of a window
/// that of its readings: the language has no dimension for a concentration.
LoggedForm formOf(const ir::Mission& mission, ir::ExprId id, const SensorUnit& unit);
LoggedForm formOf(const ir::Sensor& sensor, const SensorUnit& unit);
/// Of the sensors that `platform`, which must outlive it, declares.
SensorUnit unitsOf(const platforms::Platform& platform);
/// All `log` statements of a mission, those of its profiles and routes too.
void forEachLog(const ir::Mission& mission, const std::function<void(const ir::Statement&)>& visit);

/// "11.779 m, 39 10.500 N 73 50.101 W, unknown": `values`, in the units of `forms`, which are as
/// many or more. A latitude before a longitude is one position; angles are in degrees; times are
/// "3 h 30 min", and those since 1970 "2009-08-11T14:16:20Z".
std::string shownValues(std::span<const LoggedForm> forms, std::span<const double> values);

/// "6.18456231454 rad", "unknown": a value in the unit of `form` with 12 digits.
std::string exactValue(const LoggedForm& form, double value);

}  // namespace glider::flights
