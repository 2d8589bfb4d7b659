// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "support/result.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace glider::codegen {

/// What a sensor of a platform file can be read from.
struct SensorSource {
  std::string_view name;
  std::string_view unit;
};

/// The vehicle without the hooks is steered in this way: "imc", "recon".
bool speaks(const platforms::Platform& platform, std::string_view front_seat);

/// Fills `sensors` with the numbers of the sensors that have a source, and `sources` with their
/// rows in `known`; returns how many. GL5001: no message has that source, it has another unit, or
/// there are more than fit.
support::Result<uint32_t> readSources(const platforms::Platform& platform,
                                      std::span<const SensorSource> known,
                                      std::span<uint16_t> sensors, std::span<uint16_t> sources);

}  // namespace glider::codegen
