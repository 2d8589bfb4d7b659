// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

#include <optional>
#include <span>
#include <string_view>

namespace glider::frontend {

/// A row of values.def.
struct ValueText {
  std::string_view name;
  std::string_view type;
  std::string_view what;  ///< one line
};
std::span<const ValueText> valueTexts();

/// Whether `name` is a row of values.def.
bool isValueName(std::string_view name);

/// A condition that the platform file names: `diving` is true where a sensor has the value 1.
struct SensorState {
  const platforms::PlatformSensor* sensor;
  double value;
};
std::optional<SensorState> findSensorState(const platforms::Platform& platform,
                                           std::string_view name);

/// The sensor that is the time since 1970; null if the vehicle has none.
const platforms::PlatformSensor* findTimestamp(const platforms::Platform& platform);

}  // namespace glider::frontend
