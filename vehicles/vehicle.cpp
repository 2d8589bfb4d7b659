// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/vehicle.h"

#include "support/diagnostics/ids/vehicle.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace glider::vehicles {
namespace {

constexpr const Vehicle* kVehicles[] = {
#define FAMILY(name) &families::name,
#include "vehicles/vehicles.def"
#undef FAMILY
};

}  // namespace

const Vehicle* vehicleOf(const platforms::Platform& platform) {
  const auto* const found = std::ranges::find(kVehicles, platform.family, &Vehicle::name);
  return found == std::end(kVehicles) ? nullptr : *found;
}

const Vehicle& vehicleOfFile(std::string_view path, const Vehicle* other) {
  std::string small(path);
  std::ranges::transform(small, small.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* const found = std::ranges::find_if(kVehicles, [&](const Vehicle* vehicle) {
    return small.ends_with(vehicle->own_mission_ending);
  });
  if (found != std::end(kVehicles)) {
    return **found;
  }
  return other != nullptr ? *other : **std::begin(kVehicles);
}

support::Result<void> tryOwnMission(const std::string& path, const support::ShowDiagnostics& show) {
  support::SourceManager sources;
  if (auto own = vehicleOfFile(path).read_own_mission(path, sources, show); !own) {
    return std::unexpected(own.error());
  }
  return {};
}

support::Result<void> tryInFlight(const std::string& path) {
  support::SourceManager sources;
  const auto own = vehicleOfFile(path).read_own_mission(path, sources, {});
  if (!own) {
    return std::unexpected(own.error());
  }
  const std::string why = (*own)->whyNotFlown();
  return why.empty() ? support::Result<void>()
                     : support::fail(support::diagnostics::skeletonErrors, path, why);
}

}  // namespace glider::vehicles
