// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/dictionary.h"

#include "support/diagnostics/ids/vehicle.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::platforms {
namespace {

struct Role {
  std::string_view name;
  std::string_view sensor;  ///< of a Slocum
  bool required;
};

constexpr bool Required = true, Optional = false;
constexpr Role kRoles[] = {
#define ROLE(role, sensor, need) {#role, #sensor, need},
#include "hooks/protocol/roles.def"
#undef ROLE
};

/// The sensor that the file gives the role, or else the one with the name that a Slocum's has.
uint32_t numberOf(const Platform& platform, const Role& role) {
  auto found = std::ranges::find(platform.sensors, role.name, &PlatformSensor::role);
  if (found == platform.sensors.end()) {
    found = std::ranges::find(platform.sensors, role.sensor, &PlatformSensor::name);
  }
  return found == platform.sensors.end() ? GLIDER_NO_SENSOR : found->id;
}

/// FNV-1a over names and widths: two programs with the same number use the same sensors.
uint32_t hashOf(const Platform& platform) {
  uint32_t hash = 2166136261U;
  const auto mix = [&](unsigned char byte) { hash = (hash ^ byte) * 16777619U; };
  for (const PlatformSensor& sensor : platform.sensors) {
    for (const char c : sensor.name) {
      mix(static_cast<unsigned char>(c));
    }
    mix(0);
    mix(sensor.bytes);
  }
  return hash;
}

}  // namespace

bool isRole(std::string_view name) {
  return std::ranges::find(kRoles, name, &Role::name) != std::end(kRoles);
}

support::Result<void> checkRoles(const Platform& platform) {
  for (const Role& role : kRoles) {
    if (role.required && numberOf(platform, role) == GLIDER_NO_SENSOR) {
      return support::fail(
          support::diagnostics::badDataFile, fmt::format("platform `{}`", platform.name),
          fmt::format(
              "missions cannot fly this vehicle: it has no sensor `{}`, which the hooks need",
              role.sensor));
    }
  }
  return {};
}

Dictionary::Dictionary(const Platform& platform) {
  for (const PlatformSensor& sensor : platform.sensors) {
    formats_.push_back({.dead_band = sensor.dead_band,
                        .bytes = sensor.bytes,
                        .every = static_cast<uint32_t>(sensor.every_s / platform.envelope.cycle_s),
                        .science = sensor.computer == Computer::Science ? 1U : 0U,
                        .reserved = 0});
  }
  for (const Role& role : kRoles) {
    roles_.push_back(numberOf(platform, role));
  }
  dictionary_ = {.sensors = formats_.data(),
                 .roles = roles_.data(),
                 .count = static_cast<uint32_t>(formats_.size()),
                 .hash = hashOf(platform)};
}

}  // namespace glider::platforms
