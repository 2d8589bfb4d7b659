// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/family/family.h"
#include "simulator/sensors/provided.h"
#include "tests/second_family/toy_seat.h"

namespace glider::simulator {

/// What a toy flies by itself, of a type that no other code knows: nothing.
struct OwnOfAToy {};

constinit const Family families::toy = {
    .name = "toy",
    .own_control = "itself",
    .missing_sensor = [](const platforms::Platform& /*platform*/) { return std::string_view(); },
    .provides = [](const platforms::PlatformSensor& sensor) { return isProvided(sensor.name); },
    .load_own =
        [](const std::filesystem::path& /*path*/, support::SourceManager& /*sources*/,
           support::DiagnosticEngine& /*diagnostics*/, std::any& own) {
          own = OwnOfAToy();
          return support::Result<void>();
        },
    .vehicle_keys = {},
    .read_vehicle = [](Fields& /*fields*/, std::any& /*own*/) {},
    .text_of =
        [](const std::any& own) {
          return std::any_cast<OwnOfAToy>(&own) != nullptr ? std::string("a toy") : std::string();
        },
    .apply_drawn = [](const DrawnFaults& /*drawn*/,
                      std::any& own) { (void)std::any_cast<OwnOfAToy&>(own); },
    .overtime_of =
        [](const std::any& own) { return std::any_cast<OwnOfAToy>(&own) != nullptr ? 600.0 : 0.0; },
    .raise_overtime = [](std::any& /*own*/, double /*seconds*/) { return std::optional<double>(); },
    .make_seat = [](const SeatSetup& setup) -> std::unique_ptr<SimulatedSeat> {
      return std::make_unique<ToySeat>(setup);
    }};

}  // namespace glider::simulator
